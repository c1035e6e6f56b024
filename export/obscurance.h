// SPDX-License-Identifier: GPL-3.0-or-later
// Crevices are darker than open faces.
#pragma once

#include "export/rasteriser.h"

namespace latticast {

/// How much of the light from all round reaches a sample, 0 to 1: less where other samples stand
/// close before its facet. After McGuire, Osman, Bukowski, Hennessy, "The Alchemy screen-space
/// ambient obscurance algorithm", HPG 2011. Neighbouring samples look in different directions, so
/// that only the mean over a pixel (samples x samples of them) is smooth. Things farther than
/// `radius` samples do not count. `normal` is the facet's unit normal as (right, down, away from
/// the eye), turned towards the eye.
double openness(const Layer& layer, int column, int row, const Point& normal, double radius,
                int samples);

}  // namespace latticast
