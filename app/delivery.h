// SPDX-License-Identifier: GPL-3.0-or-later
// Where a build's files go: written aside, each mesh read back and proved, all of them shown at
// once at the end, and recorded for the report.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/progress.h"
#include "design/mesh_format.h"
#include "export/colour.h"
#include "files/staging_folder.h"
#include "geometry/solid/audit.h"
#include "geometry/solid/solid_error.h"

namespace latticast {

struct Design;
struct Material;
struct Solid;

/// "NAME-part", with the segment's number between where there are several.
std::string part_name(const Design& design, std::size_t segment, std::string_view part);

/// A mesh to be delivered, and what a report says of it.
struct Part {
  std::string stem;  ///< of its files
  std::string kind;  ///< empty: a preview, which is no piece of the actuator
  std::size_t segment = 0;
  const Material* material = nullptr;  ///< none for what the printer prints
  Colour colour = usual_colour;
  int prints = 1;               ///< how many are needed
  bool touches_itself = false;  ///< a moved part that does, which is no fault of its mesh
  std::vector<Colour> vertex_colours = {};  ///< in formats that have them
  std::vector<double> vertex_strains = {};  ///< likewise
};

/// What the audit of a part's files found.
struct DeliveredMesh {
  Audit audited;
  SolidError error;
};

/// A piece of the actuator or of a mold that was made, or what is poured into one.
struct DeliveredPiece {
  std::string name;
  std::string kind;
  std::size_t segment = 0;
  std::vector<std::string> files = {};
  const Material* material = nullptr;
  double volume_mm3 = 0;
  int prints = 1;                          ///< how many are needed
  std::optional<DeliveredMesh> mesh = {};  ///< absent for what is poured
};

/// All that was delivered, in the order of work.
struct Delivered {
  std::vector<std::string> files;
  std::vector<DeliveredPiece> pieces;
  std::vector<std::pair<std::string, double>> seconds;  ///< of each stage
};

class Delivery {
 public:
  /// Throws FileError where the folder cannot be made.
  Delivery(const Design& design, const std::filesystem::path& folder, const Console& console);

  Progress& progress() { return progress_; }
  const Delivered& delivered() const { return delivered_; }
  const std::string& summary() const { return summary_; }
  int ready() const { return ready_; }  ///< files that are written

  /// More meshes to come: each is drawn, then written and proved in every format.
  void expect_meshes(std::size_t count);

  /// part_name() of the design that is built.
  std::string part_name(std::size_t segment, std::string_view part) const;
  bool writes(MeshFormat format) const;

  /// Where to write a file that is no mesh.
  std::filesystem::path add_file(const std::string& name);
  /// Lists a file before it is written, for a report that lists itself.
  void list_file(const std::string& name) { delivered_.files.push_back(name); }
  void write_listed(const std::string& name, const std::string& bytes);

  /// Writes a solid in every format, reads each file back and proves it. `known` is the audit of
  /// its mesh, welded, where that has been made. Throws AuditFailed.
  void deliver(const Part& part, const Solid& solid, const Audit* known = nullptr);

  void record(DeliveredPiece piece) { delivered_.pieces.push_back(std::move(piece)); }
  /// A line, or several, of the list for people.
  void tell(const std::string& lines) { summary_ += lines; }
  /// The time since the note before: all that was done for this stage.
  void note_time(const std::string& stage);

  /// How far the delivery has come.
  struct Mark {
    std::size_t staged = 0;
    std::size_t files = 0;
    std::size_t pieces = 0;
    std::size_t summary = 0;
    int ready = 0;
  };
  Mark mark() const;
  /// Forgets what has come since.
  void take_back(const Mark& mark);

  /// The files appear in the folder.
  void commit() { staging_.commit(); }

 private:
  void tell_of_contact(const Part& part, const Audit& result);

  const Design& design_;
  const Console& console_;
  Progress progress_;
  StagingFolder staging_;
  Delivered delivered_;
  std::string summary_;
  int ready_ = 0;
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

}  // namespace latticast
