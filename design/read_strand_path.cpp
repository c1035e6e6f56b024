// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/read_strand_path.h"

#include <cmath>
#include <string>

#include "design/units.h"

namespace latticast {
namespace {

// Reads the path that is written; a second one is refused.
class PathKeys {
 public:
  PathKeys(TableReader& table, double strand_mm) : table_(table), strand_mm_(strand_mm) {}

  template <class Path>
  void look_for() {
    const Field field = table_.may(Path::key);
    if (!field.present()) return;
    if (found_.empty()) {
      found_ = Path::key;
      path_ = Path::read(field, strand_mm_);
    } else {
      field.refuse("a strand follows one path, but " + found_ + " is given as well",
                   "keep " + found_ + " or " + std::string(Path::key));
    }
  }

  template <class... Curved>
  StrandPath read(const std::variant<StraightPath, Curved...>& /*paths*/) {
    (look_for<Curved>(), ...);
    return path_;
  }

 private:
  TableReader& table_;
  double strand_mm_;
  std::string found_;
  StrandPath path_;
};

}  // namespace

StrandPath read_strand_path(TableReader& table, const Segment& segment, double angle_deg) {
  const double strand_mm = segment.length_mm / std::sin(radians(angle_deg));
  return PathKeys(table, strand_mm).read(StrandPath{});
}

}  // namespace latticast
