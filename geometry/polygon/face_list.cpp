// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polygon/face_list.h"

#include <utility>

#include "geometry/polygon/polygon_triangles.h"

namespace latticast {

void FaceList::add(std::span<const std::uint32_t> corners) {
  if (corners.size() == 3) {
    triangles_.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  polygons_.push_back({triangles_.size(), corners_.size()});
  corners_.insert(corners_.end(), corners.begin(), corners.end());
}

std::vector<Triangle> FaceList::triangles(std::span<const Point> vertices) && {
  if (polygons_.empty()) return std::move(triangles_);
  std::vector<Triangle> all;
  all.reserve(triangles_.size() + corners_.size());
  std::vector<Point> points;
  std::size_t taken = 0;
  for (std::size_t i = 0; i < polygons_.size(); ++i) {
    const auto [place, first] = polygons_[i];
    all.insert(all.end(), triangles_.data() + taken, triangles_.data() + place);
    taken = place;
    const std::size_t end = i + 1 < polygons_.size() ? polygons_[i + 1].first : corners_.size();
    points.clear();
    for (std::size_t j = first; j < end; ++j) points.push_back(vertices[corners_[j]]);
    for (const Triangle& t : polygon_triangles(points)) {
      all.push_back({corners_[first + t[0]], corners_[first + t[1]], corners_[first + t[2]]});
    }
  }
  all.insert(all.end(), triangles_.data() + taken, triangles_.data() + triangles_.size());
  return all;
}

}  // namespace latticast
