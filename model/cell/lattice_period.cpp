// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/lattice_period.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

#include "geometry/pattern/rings.h"
#include "geometry/pattern/strand_path.h"

namespace latticast {
namespace {

constexpr int most_pitches = 6;     // of the rings in one period
constexpr double same_mm = 2e-3;    // of places that are taken for one
constexpr double snapping = 0.005;  // of a pitch, that rings are moved by without a word

/// How one family repeats: by `around` about the axis, and by (shift, along) along the tube.
struct FamilyPeriod {
  double around_mm = 0;
  double along_mm = 0;  // 0: any, as straight strands do
  double cotangent = 0;
  double link_mm = 0;  // height of a link, 0 of a straight strand
  int strands = 1;     // equal ones, or groups of them, evenly spaced
};

/// How often a family's widths repeat around the tube.
int repeats_of(const std::vector<double>& widths) {
  const std::size_t count = widths.size();
  for (std::size_t period = 1; period < count; ++period) {
    if (count % period != 0) continue;
    if (std::equal(widths.begin() + static_cast<std::ptrdiff_t>(period), widths.end(),
                   widths.begin())) {
      return static_cast<int>(count / period);
    }
  }
  return 1;
}

FamilyPeriod family_period(const Segment& segment, const Grid& grid) {
  FamilyPeriod family;
  family.strands = repeats_of(grid.widths_mm);
  family.around_mm = segment.lattice_circumference_mm() / family.strands;
  const StrandDirection direction = grid.direction();
  family.cotangent = direction.cosine / direction.sine;
  if (!is_curved(grid.path)) return family;
  family.link_mm = link_chord_mm(closed(placed_strand(segment, grid))) * direction.sine;
  const auto* horseshoe = std::get_if<Horseshoe>(&grid.path);
  const bool alternates = horseshoe == nullptr || horseshoe->alternate;
  family.along_mm = (alternates ? 2 : 1) * family.link_mm;
  return family;
}

/// The distance of x from the nearest multiple of `step`.
double off_multiple(double x, double step) {
  return std::abs(x - step * std::round(x / step));
}

/// The shift after `along` under which all families repeat.
std::optional<double> common_shift(const std::vector<FamilyPeriod>& families, double along_mm) {
  const FamilyPeriod& first = families.front();
  for (int i = 0; i < first.strands; ++i) {
    const double shift = along_mm * first.cotangent + i * first.around_mm;
    const bool fits = std::all_of(families.begin(), families.end(), [&](const FamilyPeriod& f) {
      return off_multiple(shift - along_mm * f.cotangent, f.around_mm) < same_mm;
    });
    if (fits) return shift;
  }
  return std::nullopt;
}

/// Whether all links fit into `along`, none of them moved by more than `share` of it.
bool holds_links(const std::vector<FamilyPeriod>& families, double along_mm, double share) {
  return std::all_of(families.begin(), families.end(), [&](const FamilyPeriod& f) {
    return f.along_mm == 0 ||
           (along_mm > 0.5 * f.along_mm && off_multiple(along_mm, f.along_mm) < share * along_mm);
  });
}

class PeriodFinder {
 public:
  explicit PeriodFinder(const Segment& segment) : segment_(segment) {
    for (const Grid& grid : segment.lattice->grids) {
      if (grid.count() > 0) families_.push_back(family_period(segment, grid));
    }
    for (const FamilyPeriod& family : families_) {
      if (family.link_mm > link_mm_) link_mm_ = family.link_mm;
      longest_mm_ = std::max(longest_mm_, family.along_mm);
    }
    const auto& rings = segment.lattice->rings;
    if (!rings) return;
    const std::vector<double> centres = ring_centres_mm(*rings, segment.length_mm);
    if (centres.empty()) return;
    pitch_mm_ = ring_pitch_mm(*rings, segment.length_mm);
    first_ring_mm_ = centres.front();
  }

  FoundPeriod find() {
    if (!choose_length()) return {std::nullopt, std::move(reason_)};
    const auto shift = common_shift(families_, along_mm_);
    if (!shift) return {std::nullopt, std::move(reason_)};
    FoundPeriod found;
    LatticePeriod& period = found.period.emplace();
    period.drawn = segment_;
    period.shift_mm = *shift;
    period.repeats = shared_repeats();
    if (period.repeats == 1 && !are_upright()) {
      return {std::nullopt, "knows strands that differ around the tube along the axis only"};
    }
    place(period);
    period.assumed = std::move(assumed_);
    return found;
  }

 private:
  /// A height after which rings and links repeat.
  bool choose_length() {
    if (pitch_mm_ == 0) {
      along_mm_ = longest_mm_ > 0 ? longest_mm_
                                  : segment_.lattice_circumference_mm() / families_.front().strands;
      reason_ = "knows families of strands that repeat together, these do not";
      return holds_links(families_, along_mm_, snapping) || shorter_links_repeat();
    }
    for (int pitches = 1; pitches <= most_pitches; ++pitches) {
      const double along = pitches * pitch_mm_;
      if (!holds_links(families_, along, snapping) || !common_shift(families_, along)) continue;
      along_mm_ = longest_mm_ > 0 ? longest_mm_ * std::round(along / longest_mm_) : along;
      pitch_mm_ = along_mm_ / pitches;
      return true;
    }
    if (longest_mm_ == 0) {
      reason_ = "needs rings and families that repeat together within six pitches, these do not" +
                better_pitch();
      return false;
    }
    return set_rings_to_links();
  }

  bool shorter_links_repeat() {
    for (int i = 2; i <= most_pitches; ++i) {
      if (!holds_links(families_, i * longest_mm_, snapping)) continue;
      along_mm_ = i * longest_mm_;
      return true;
    }
    return false;
  }

  /// Rings that drift along the waves are set to one place of them.
  bool set_rings_to_links() {
    const double waves = std::max(1.0, std::round(pitch_mm_ / longest_mm_));
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(),
                  "the unit cell has a ring every %.6g mm, on the bulges, not every %.6g mm: rings "
                  "and waves do not repeat together",
                  waves * longest_mm_, pitch_mm_);
    assumed_ = text.data();
    along_mm_ = pitch_mm_ = waves * longest_mm_;
    first_ring_mm_ = 0.5 * link_mm_;
    reason_ = "knows families of strands that repeat together, these do not";
    return holds_links(families_, along_mm_, snapping);
  }

  int shared_repeats() const {
    int repeats = families_.front().strands;
    for (const FamilyPeriod& f : families_) repeats = std::gcd(repeats, f.strands);
    return repeats;
  }

  /// For two families of opposite angles: the pitch at which they repeat that is nearest.
  std::string better_pitch() const {
    if (families_.size() < 2 || shared_repeats() == 1) return {};
    const double apart = std::abs(families_[1].cotangent - families_[0].cotangent);
    const double around = std::min(families_[0].around_mm, families_[1].around_mm);
    if (apart == 0) return {};
    const double step = around / apart;
    const double pitch = step * std::max(1.0, std::round(pitch_mm_ / step));
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "; rings every %.6g mm would", pitch);
    return text.data();
  }

  bool are_upright() const {
    return std::all_of(families_.begin(), families_.end(),
                       [](const FamilyPeriod& f) { return f.cotangent == 0; });
  }

  /// Where the period lies on a drawing long enough for it.
  void place(LatticePeriod& period) const {
    const bool in_step =
        std::all_of(families_.begin(), families_.end(), [&](const FamilyPeriod& f) {
          return f.link_mm == 0 || pitch_mm_ == 0 ||
                 off_multiple(first_ring_mm_ - 0.5 * f.link_mm, f.link_mm) < snapping * f.link_mm;
        });
    period.mirrored = are_upright() && in_step;
    double start = pitch_mm_ > 0 ? first_ring_mm_ : 0.5 * link_mm_;
    if (period.mirrored && link_mm_ > 0) {
      start = link_mm_ * (0.5 + std::round(start / link_mm_ - 0.5));
    }
    period.from_mm = start + along_mm_;
    period.to_mm = period.from_mm + (period.mirrored ? 0.5 : 1) * along_mm_;
    period.drawn.length_mm = drawn_length_mm();
    period.drawn.lattice = drawn_lattice(start);
  }

  double drawn_length_mm() const { return 4 * along_mm_; }

  Lattice drawn_lattice(double ring_mm) const {
    Lattice lattice = *segment_.lattice;
    if (pitch_mm_ > 0) {
      lattice.rings = Rings{.count = std::nullopt,
                            .pitch_mm = pitch_mm_,
                            .width_mm = lattice.rings->width_mm,
                            .phase = std::fmod(ring_mm / pitch_mm_, 1.0)};
    }
    for (Grid& grid : lattice.grids) {
      if (grid.count() == 0) continue;
      grid.path = closed(placed_strand(segment_, grid)).shape;
      // Waves are counted on the whole of a strand.
      auto* sinusoid = std::get_if<Sinusoid>(&grid.path);
      if (sinusoid != nullptr) sinusoid->waves *= drawn_length_mm() / segment_.length_mm;
    }
    return lattice;
  }

  const Segment& segment_;
  std::vector<FamilyPeriod> families_;
  double link_mm_ = 0;
  double longest_mm_ = 0;  // of the families' own periods
  double pitch_mm_ = 0;    // 0: no rings
  double first_ring_mm_ = 0;
  double along_mm_ = 0;
  std::string reason_;
  std::string assumed_;
};

}  // namespace

int equal_sectors(const Segment& segment) {
  int sectors = 0;
  for (const Grid& grid : segment.lattice->grids) {
    if (grid.count() > 0) sectors = std::gcd(sectors, repeats_of(grid.widths_mm));
  }
  return std::max(sectors, 1);
}

FoundPeriod find_period(const Segment& segment) {
  return PeriodFinder(segment).find();
}

}  // namespace latticast
