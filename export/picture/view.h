// SPDX-License-Identifier: GPL-3.0-or-later
// Camera, orthographic or perspective: from mm in space to a place on the screen.
#pragma once

#include <vector>

#include "export/picture/picture.h"

namespace latticast {

/// A camera fitted to a scene: every finite vertex lands inside the picture's border. Screen
/// coordinates are (x to the right, y down, depth away from the eye), in samples; planes stay
/// planes.
class View {
 public:
  /// `samples` are the samples along one side of a pixel. Throws std::invalid_argument for a zero
  /// camera direction or an `up` parallel to it.
  View(const std::vector<PictureObject>& objects, const Camera& camera,
       const PictureOptions& options, int samples);

  /// A direction in space as (right, down, away from the eye).
  Point turned(const Point& direction) const;

  /// A point in space on the screen.
  Point on_screen(const Point& point) const;

 private:
  void fit_centre(const std::vector<PictureObject>& objects, double perspective_deg);
  void fit_frame(const std::vector<PictureObject>& objects, const PictureOptions& options,
                 int samples);
  Point projected(const Point& point) const;

  Point forward_;
  Point right_;
  Point down_;
  Point centre_{0, 0, 0};
  double nearness_ = 0;  // 1/(distance of the eye from the centre); 0 is an orthographic view
  double scale_ = 1;     // samples per mm at the centre
  Point shift_{0, 0, 0};
};

}  // namespace latticast
