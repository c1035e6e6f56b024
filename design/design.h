// SPDX-License-Identifier: GPL-3.0-or-later
// The design as its author wrote it, typed and validated: what is wanted, not how it is made.
// Grammar: docs/design-file.md. Lengths mm, angles degrees, pressures kPa, moduli MPa.
#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "design/material/material.h"
#include "design/mesh_format.h"
#include "design/strand_path.h"
#include "design/units.h"
#include "design/wall_kind.h"

namespace latticast {

/// The soft tube: inner_radius <= R <= inner_radius + thickness.
struct Liner {
  double inner_radius_mm = 0;
  double thickness_mm = 0;
  Material material;

  friend bool operator==(const Liner&, const Liner&) = default;
};

/// Circumferential rings. Exactly one of `count` (>= 2, evenly spaced, first and last flush with
/// the ends) and `pitch_mm` (centres at (phase + i) pitch, those rings that lie wholly on the
/// segment) is set.
struct Rings {
  static constexpr double usual_phase = 0.5;

  std::optional<int> count;
  std::optional<double> pitch_mm;
  double width_mm = 0;
  double phase = usual_phase;  ///< of rings by pitch, 0 <= phase < 1

  /// Of the first ring by pitch that does not reach past the segment's start. Precondition: rings
  /// by pitch.
  double first_centre_mm() const;

  friend bool operator==(const Rings&, const Rings&) = default;
};

/// Unit vector along a straight line of the unrolled plane: u runs around the tube, z along it.
struct StrandDirection {
  double cosine = 0;  ///< along u
  double sine = 1;    ///< along z
};

/// One family of equal-angle strands, evenly spaced around the tube; strand 0 starts at Theta = 0.
struct Grid {
  double angle_deg = 0;           ///< from the circumferential direction, 0 < angle < 180
  std::vector<double> widths_mm;  ///< one per strand, measured square to the strand at mid radius
  StrandPath path;

  int count() const { return static_cast<int>(widths_mm.size()); }
  double angle_rad() const { return radians(angle_deg); }

  /// Mirrored angles, alpha and 180 degrees - alpha, have exactly mirrored directions; that of 90
  /// degrees is exactly (0, 1).
  StrandDirection direction() const;

  friend bool operator==(const Grid&, const Grid&) = default;
};

/// The reinforcing layer bonded outside the liner.
struct Lattice {
  double thickness_mm = 0;
  Material material;
  std::optional<Rings> rings;
  std::vector<Grid> grids;
  double fillet_mm = 0;  ///< radius of every inward corner where strands meet; 0: sharp

  friend bool operator==(const Lattice&, const Lattice&) = default;
};

/// Whether any strand is other than straight.
bool has_curved_strands(const Lattice& lattice);

/// One length of tube with its own section and, in a load case, its own pressure.
struct Segment {
  double length_mm = 0;
  Liner liner;
  std::optional<Lattice> lattice;  ///< absent: a bare tube
  std::string name = {};           ///< for people and paths; empty without one

  double inner_radius_mm() const { return liner.inner_radius_mm; }
  double liner_outer_radius_mm() const { return liner.inner_radius_mm + liner.thickness_mm; }
  double outer_radius_mm() const {
    return liner_outer_radius_mm() + (lattice ? lattice->thickness_mm : 0.0);
  }
  /// R_c, where strand widths are measured. Precondition: the segment has a lattice.
  double lattice_mid_radius_mm() const {
    return liner_outer_radius_mm() + 0.5 * lattice->thickness_mm;
  }
  /// 2 pi R_c, the period of the unrolled plane. Precondition: the segment has a lattice.
  double lattice_circumference_mm() const { return 2 * std::numbers::pi * lattice_mid_radius_mm(); }

  /// The same tube, whatever its name.
  friend bool operator==(const Segment& a, const Segment& b) {
    return a.length_mm == b.length_mm && a.liner == b.liner && a.lattice == b.lattice;
  }
};

/// One pressure per segment.
struct LoadCase {
  std::vector<double> pressures_kpa;
};

/// What of a bonded wall is set by a unit cell: nothing; its stiffness at rest; one state under
/// pressure as well.
enum class Calibrate { nothing, stiffness, state };
enum class ColumnModel { distributed, rods };
enum class JointModel { none, paper, clear_span };

struct ModelChoice {
  WallKind wall = WallKind::layered;
  Calibrate calibrate = Calibrate::stiffness;  ///< only where wall is bonded
  ColumnModel columns = ColumnModel::distributed;
  JointModel joint = JointModel::clear_span;
  double cell_error_percent = 0;  ///< that a unit cell's response at rest may be off by; 0: what
                                  ///< its coarsest meshes give
};

/// Cast in a grooved mold, or in a flexible mold made around a printed pattern.
enum class MoldMethod { direct, replica };

struct LatticeMold {
  std::optional<int> pieces;  ///< absent: chosen from the undercuts ("auto")
  double wall_mm = 5;
  MoldMethod method = MoldMethod::direct;
};

/// Open at both ends; closed at the upper end; with flanges that take the lattice between them.
enum class LinerEnds { open, closed, flanged };

struct LinerMold {
  double wall_mm = 5;
  LinerEnds ends = LinerEnds::open;
  bool keyed = false;  ///< cast inside the finished lattice
  int pieces = 2;      ///< of the shell
};

struct Preview {
  std::vector<LoadCase> cases;
};

/// Files for finite-element programs: of one of the lattice's equal sectors, or of the whole tube.
struct Deck {
  bool inp = true;
  bool msh = false;
  bool whole = false;
};

/// What to make; nothing that is not named.
struct Make {
  bool lattice = false;
  bool liner = false;
  bool flat_pattern = false;  ///< the lattice unrolled, as drawings at true scale
  std::optional<LatticeMold> lattice_mold;
  std::optional<LinerMold> liner_mold;
  std::optional<Preview> preview;
  std::optional<Deck> deck;
  bool report = false;
};

struct Export {
  std::vector<MeshFormat> formats = {MeshFormat::stl};
  double tolerance_mm = 0.01;  ///< chord error of written meshes
};

enum class Process { fdm, sla };

struct Printer {
  Process process = Process::fdm;
  std::optional<double> min_wall_mm;
  std::optional<double> min_gap_mm;
  std::optional<double> clearance_mm;
  std::optional<std::array<double, 3>> bed_mm;
};

/// Between pieces that are put together, on the diameter: as given, or what is usual for the
/// process.
inline double fit_clearance_mm(const Printer& printer) {
  return printer.clearance_mm.value_or(printer.process == Process::sla ? 0.15 : 0.3);
}

struct Design {
  std::string name;
  std::vector<Segment> segments;
  std::vector<LoadCase> load;
  ModelChoice model;
  Make make;
  Export output;
  Printer printer;
};

}  // namespace latticast
