// SPDX-License-Identifier: GPL-3.0-or-later
// Provenance of rounded outlines: which drawn curve, or which fillet, an edge follows that an
// offset has made. Found by distance, since the offset (Clipper) keeps no account of it.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/solid/drawn_edges.h"

namespace latticast {

struct RoundedOutlineOptions {
  double radius_mm = 0;    ///< of the fillets
  double rounding_mm = 0;  ///< by which an edge may have left the drawn edge that it is a part of
  double flatness_mm = 0;  ///< by which the chords of an arc may leave it
};

/// Traces outlines that were made from one pattern. Linear in the edges of the pattern, and a
/// constant time for an edge of an outline.
class RoundedOutlineTracer {
 public:
  RoundedOutlineTracer(const Pattern& pattern, const RoundedOutlineOptions& options);

  /// Gives the outline its curves: the pattern's, moved by whole circumferences to where the
  /// outline is, and arcs of the fillets' radius between them. Lines of their own remain: edges
  /// along the seam and the segment's ends, and chords of two arcs that lie in line at an
  /// inflection and have become one edge. Precondition: material on the outline's left.
  void trace(Strand& outline) const;

 private:
  void add_to_cells(EdgeOrigin edge);
  const std::vector<EdgeOrigin>& near(PlanePoint place) const;

  RoundedOutlineOptions options_;
  double length_mm_ = 0;
  DrawnEdges drawn_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::vector<EdgeOrigin>> cells_;
};

}  // namespace latticast
