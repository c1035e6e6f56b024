// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/slivers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "geometry/solid/plane_offsets.h"

namespace latticast {
namespace {

using namespace plane_offsets;

constexpr double far_along = 8;    // in widths, along one outline: nearer places are its corners
constexpr double least_reach = 4;  // in widths
constexpr double arc_share = 1.0 / 16;     // of the width: flatness of corners that are rounded
constexpr double tongue_share = 1.0 / 16;  // of the width: thinner ends of a sliver are left
constexpr double overlap_share = 1.0 / 8;  // of the width: by which a patch is larger
constexpr double finest_width = 64;        // in Clipper's steps

// A piece of an outline, short enough for a few cells.
struct Piece {
  PlanePoint a;
  PlanePoint b;
  std::uint32_t curve = 0;
  double along_mm = 0;  // from the curve's first point
};

double distance_to(PlanePoint p, PlanePoint a, PlanePoint b) {
  const double u = b.u - a.u;
  const double z = b.z - a.z;
  const double square = u * u + z * z;
  const double along = square > 0 ? ((p.u - a.u) * u + (p.z - a.z) * z) / square : 0;
  const double part = std::clamp(along, 0.0, 1.0);
  return std::hypot(p.u - a.u - part * u, p.z - a.z - part * z);
}

// Outlines do not cross: the nearest places of two pieces are an end of one of them. That end,
// where it is nearer than `width`.
std::optional<PlanePoint> near_end(const Piece& p, Piece q, double width, double around) {
  const double shift = around * std::round((q.a.u - p.a.u) / around);
  q.a.u -= shift;
  q.b.u -= shift;
  for (const PlanePoint& end : {p.a, p.b}) {
    if (distance_to(end, q.a, q.b) < width) return end;
  }
  for (const PlanePoint& end : {q.a, q.b}) {
    if (distance_to(end, p.a, p.b) < width) return end;
  }
  return std::nullopt;
}

class NearPieces {
 public:
  NearPieces(const Region& united, double width)
      : width_(width),
        around_(united.grid.sectors * united.grid.sector_steps * united.grid.u_step_mm),
        curves_(outline_curves(united)) {
    double length = 0;
    std::size_t edges = 0;
    for (const OutlineCurve& curve : curves_) {
      lengths_.push_back(length_of(curve));
      length += lengths_.back();
      edges += curve.points.size();
    }
    cell_ =
        std::max(4 * width, length / (4.0 * static_cast<double>(std::max<std::size_t>(edges, 1))));
    columns_ = std::max<std::int64_t>(1, static_cast<std::int64_t>(around_ / cell_));
    cells_.reserve(4 * edges);
  }

  std::vector<PlanePoint> run() {
    for (std::uint32_t c = 0; c < curves_.size(); ++c) {
      double along = 0;
      for (std::size_t i = 0; i < curves_[c].points.size(); ++i) {
        const PlanePoint a = curves_[c].points[i];
        const PlanePoint b = after(curves_[c], i);
        const double whole = distance(a, b);
        const int parts = 1 + static_cast<int>(whole / cell_);
        for (int k = 0; k < parts; ++k) {
          const Piece piece{between(a, b, double(k) / parts), between(a, b, double(k + 1) / parts),
                            c, along + whole * k / parts};
          look_around(piece);
        }
        along += whole;
      }
    }
    return std::move(places_);
  }

 private:
  static PlanePoint after(const OutlineCurve& curve, std::size_t i) {
    if (i + 1 < curve.points.size()) return curve.points[i + 1];
    return {curve.points.front().u + curve.around_mm, curve.points.front().z};
  }

  static PlanePoint between(PlanePoint a, PlanePoint b, double part) {
    return {std::lerp(a.u, b.u, part), std::lerp(a.z, b.z, part)};
  }

  static double length_of(const OutlineCurve& curve) {
    double length = 0;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      length += distance(curve.points[i], after(curve, i));
    }
    return length;
  }

  bool are_far_along(const Piece& p, const Piece& q) const {
    if (p.curve != q.curve) return true;
    const double apart = std::abs(p.along_mm - q.along_mm);
    const double longest = distance(p.a, p.b) + distance(q.a, q.b);
    return std::min(apart, lengths_[p.curve] - apart) - longest > far_along * width_;
  }

  static bool are_boxes_apart(const Piece& p, const Piece& q, double width) {
    return std::max(p.a.z, p.b.z) + width < std::min(q.a.z, q.b.z) ||
           std::max(q.a.z, q.b.z) + width < std::min(p.a.z, p.b.z);
  }

  void add_place(PlanePoint at) {
    constexpr double apart = 100;  // in widths
    const auto is_known = [&](PlanePoint known) {
      return std::abs(std::remainder(known.u - at.u, around_)) < apart * width_ &&
             std::abs(known.z - at.z) < apart * width_;
    };
    if (!places_.empty() && is_known(places_.back())) return;
    if (std::any_of(places_.begin(), places_.end(), is_known)) return;
    places_.push_back({at.u - around_ * std::floor(at.u / around_), at.z});
  }

  // Looks at the pieces that are there already, and joins them.
  void look_around(const Piece& piece) {
    const auto number = static_cast<std::uint32_t>(pieces_.size());
    const auto [left, right] = std::minmax(piece.a.u, piece.b.u);
    const auto [low, high] = std::minmax(piece.a.z, piece.b.z);
    for (auto row = cell_of(low - width_); row <= cell_of(high + width_); ++row) {
      for (auto column = cell_of(left - width_); column <= cell_of(right + width_); ++column) {
        std::vector<std::uint32_t>& cell = cells_[key(column, row)];
        for (const std::uint32_t other : cell) {
          const Piece& there = pieces_[other];
          if (are_boxes_apart(piece, there, width_) || !are_far_along(piece, there)) continue;
          const auto near = near_end(piece, there, width_, around_);
          if (near) add_place(*near);
        }
        cell.push_back(number);
      }
    }
    pieces_.push_back(piece);
  }

  std::int64_t cell_of(double at) const {
    return static_cast<std::int64_t>(std::floor(at / cell_));
  }

  // Columns are a little narrower than cells where the circumference is no whole number of them.
  std::uint64_t key(std::int64_t column, std::int64_t row) const {
    const std::int64_t around = ((column % columns_) + columns_) % columns_;
    return static_cast<std::uint64_t>(row) << 32U | static_cast<std::uint64_t>(around);
  }

  double width_;
  double around_;
  std::vector<OutlineCurve> curves_;
  std::vector<double> lengths_;
  double cell_ = 0;
  std::int64_t columns_ = 1;
  std::vector<Piece> pieces_;
  std::vector<PlanePoint> places_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

struct Box {
  cInt left = 0;
  cInt right = 0;
  cInt low = 0;
  cInt high = 0;
};

Box box_of(const Path& path) {
  const auto u = [](const auto& p) { return IntegerGrid::u_of(p); };
  const auto z = [](const auto& p) { return IntegerGrid::z_of(p); };
  Box box{u(path.front()), u(path.front()), z(path.front()), z(path.front())};
  for (const auto& point : path) {
    box = {std::min(box.left, u(point)), std::max(box.right, u(point)), std::min(box.low, z(point)),
           std::max(box.high, z(point))};
  }
  return box;
}

class SliverSearch {
 public:
  SliverSearch(const Pattern& pattern, double width_mm)
      : grid_(pattern),
        width_(width_mm / grid_.u_step_mm),
        margin_(static_cast<cInt>(16 * width_)),
        drawn_(united_around_one_period(pattern, grid_, margin_)) {}

  std::vector<Sliver> run(bool with_necks) {
    const Paths gaps = kept(difference(closed(), drawn_));
    add(gaps, true);
    if (!with_necks) return std::move(found_);
    drawn_ = joined(gaps);
    add(kept(difference(drawn_, opened())), false);
    return std::move(found_);
  }

 private:
  Path window() const { return box(-margin_, period + margin_, 0, grid_.length); }

  Paths closed() const {
    const Paths grown = offset(drawn_, 0.5 * width_, arc_share * width_);
    return part_in(offset(grown, -0.5 * width_, arc_share * width_), window());
  }

  Paths opened() const {
    const Paths shrunk = offset(drawn_, -0.5 * width_, arc_share * width_);
    return offset(shrunk, 0.5 * width_, arc_share * width_);
  }

  Paths joined(const Paths& more) const {
    ClipperLib::Clipper clipper;
    clipper.AddPaths(drawn_, ClipperLib::ptSubject, true);
    clipper.AddPaths(more, ClipperLib::ptSubject, true);
    Paths result;
    clipper.Execute(ClipperLib::ctUnion, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    return part_in(result, window());
  }

  // Without corners, thin tongues and what rounding leaves, and a little larger.
  Paths kept(const Paths& paths) const {
    const double flatness = arc_share * width_;
    const Paths thick = offset(offset(paths, -tongue_share * width_, flatness),
                               (tongue_share + overlap_share) * width_, flatness);
    Paths result;
    for (const Path& path : thick) {
      if (reach(box_of(path)) > least_reach * width_) result.push_back(path);
    }
    return result;
  }

  static double reach(const Box& box) {
    return std::hypot(static_cast<double>(box.right - box.left),
                      static_cast<double>(box.high - box.low));
  }

  void add(const Paths& paths, bool is_gap) {
    for (const Path& path : paths) {
      const Box around = box_of(path);
      const double u = 0.5 * static_cast<double>(around.left + around.right);
      if (u < 0 || u >= static_cast<double>(period)) continue;  // a copy of one in the period
      Sliver sliver;
      sliver.is_gap = is_gap;
      sliver.middle = {u * grid_.u_step_mm,
                       0.5 * static_cast<double>(around.low + around.high) * grid_.z_step_mm};
      sliver.reach_mm = reach(around) * grid_.u_step_mm;
      sliver.patch.outline = grid_.outline_of(path);
      if (!is_gap) std::reverse(sliver.patch.outline.begin(), sliver.patch.outline.end());
      found_.push_back(std::move(sliver));
    }
  }

  IntegerGrid grid_;
  double width_;  // in steps
  cInt margin_;
  Paths drawn_;
  std::vector<Sliver> found_;
};

double area_of(const std::vector<PlanePoint>& outline) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    twice += cross(outline[0], outline[i], outline[i + 1]);
  }
  return 0.5 * std::abs(twice);
}

}  // namespace

std::vector<PlanePoint> near_places(const Region& united, double width_mm) {
  return NearPieces(united, width_mm).run();
}

std::vector<Sliver> slivers_of(const Pattern& pattern, double width_mm, bool with_necks) {
  const IntegerGrid grid(pattern);
  if (width_mm < finest_width * grid.u_step_mm || grid.length < 1) return {};
  return SliverSearch(pattern, width_mm).run(with_necks);
}

Pattern without_slivers(Pattern pattern, const std::vector<Sliver>& slivers, double width_mm) {
  if (slivers.empty()) return pattern;
  for (const Sliver& sliver : slivers) {
    pattern.error.area_mm2 += area_of(sliver.patch.outline);
    pattern.strands.push_back(sliver.patch);
  }
  pattern.error.distance_mm += 0.5 * width_mm;
  return pattern;
}

}  // namespace latticast
