// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/picture/picture.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include <gtest/gtest.h>

#include "export/picture/ambient_occlusion.h"
#include "tests/unit/export/mesh/example_meshes.h"

namespace latticast {
namespace {

constexpr Colour red{0.9, 0.1, 0.1};
constexpr Colour blue{0.1, 0.1, 0.9};
const Camera from_the_front{{0, 1, 0}, {0, 0, 1}, 0};
const PictureOptions small{120, 80, 0.05, true};

/// An upright square of half side `half` around the y axis, at y.
TriangleMesh square(double half, double y) {
  return {{{-half, y, -half}, {half, y, -half}, {half, y, half}, {-half, y, half}},
          {{0, 1, 2}, {0, 2, 3}}};
}

struct Pixel {
  int red, green, blue, opacity;
};

Pixel at(const Image& image, int column, int row) {
  const std::size_t i = 4 * (static_cast<std::size_t>(row) * image.width + column);
  return {image.rgba.at(i), image.rgba.at(i + 1), image.rgba.at(i + 2), image.rgba.at(i + 3)};
}

Pixel middle(const Image& image) {
  return at(image, image.width / 2, image.height / 2);
}

double covered_pixels(const Image& image) {
  double sum = 0;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    sum += image.rgba[i] / 255.0;
  }
  return sum;
}

TEST(Picture, IsEmptyWithoutObjects) {
  const Image clear = draw_picture({}, from_the_front, small);
  EXPECT_EQ(covered_pixels(clear), 0);
  PictureOptions on_white = small;
  on_white.transparent = false;
  const Image white = draw_picture({{TriangleMesh{}, red}}, from_the_front, on_white);
  EXPECT_EQ(white.rgba, std::vector<std::uint8_t>(std::size_t{4} * 120 * 80, 255));
}

TEST(Picture, FitsTheFrame) {
  // A square fills the height but for the border of 5 % of it on each side.
  const Image image = draw_picture({{square(3, 0), red}}, from_the_front, small);
  EXPECT_NEAR(covered_pixels(image), 72 * 72, 1);
  EXPECT_EQ(at(image, 60, 3).opacity, 0);
  EXPECT_EQ(at(image, 60, 4).opacity, 255);
  EXPECT_EQ(at(image, 60, 75).opacity, 255);
  EXPECT_EQ(at(image, 60, 76).opacity, 0);
  EXPECT_EQ(at(image, 23, 40).opacity, 0);
  EXPECT_EQ(at(image, 24, 40).opacity, 255);
}

TEST(Picture, ShowsWhatIsNearer) {
  const PictureObject near{square(1, -5), red};
  const PictureObject far{square(2, 5), blue};
  for (const double perspective : {0.0, 40.0}) {
    const Camera camera{{0, 1, 0}, {0, 0, 1}, perspective};
    for (const auto& objects : {std::vector{near, far}, std::vector{far, near}}) {
      const Pixel seen = middle(draw_picture(objects, camera, small));
      EXPECT_GT(seen.red, 2 * seen.blue);
      const Camera behind{{0, -1, 0}, {0, 0, 1}, perspective};
      const Pixel from_behind = middle(draw_picture(objects, behind, small));
      EXPECT_GT(from_behind.blue, 2 * from_behind.red);
    }
  }
}

TEST(Picture, CutsCrossingFacesWhereTheyMeet) {
  // Two squares through the z axis, turned by 45 degrees either way: each is in front on one side.
  TriangleMesh left = square(1, 0);
  TriangleMesh right = left;
  for (Point& p : left.vertices) {
    p[1] = p[0];
  }
  for (Point& p : right.vertices) {
    p[1] = -p[0];
  }
  const Image image = draw_picture({{left, red}, {right, blue}}, from_the_front, small);
  EXPECT_GT(at(image, 50, 40).red, 2 * at(image, 50, 40).blue);
  EXPECT_GT(at(image, 70, 40).blue, 2 * at(image, 70, 40).red);
}

TEST(Picture, ASymmetricObjectHasASymmetricOutline) {
  for (const double perspective : {0.0, 30.0}) {
    const Image image = draw_picture({{torus(48, 16), red}}, {{0, 1, -1}, {0, 0, 1}, perspective},
                                     {200, 120, 0.05, true});
    int differing = 0;
    int covered = 0;
    for (int row = 0; row < 120; ++row) {
      for (int column = 0; column < 100; ++column) {
        const int here = at(image, column, row).opacity;
        covered += here == 255 ? 1 : 0;
        differing += std::abs(here - at(image, 199 - column, row).opacity) > 30 ? 1 : 0;
      }
    }
    EXPECT_GT(covered, 1000);
    EXPECT_EQ(differing, 0);
    EXPECT_EQ(middle(image).opacity, 0) << "the hole of the torus";
  }
}

TEST(Picture, UpIsUpAndRightIsRight) {
  TriangleMesh corner = square(1, 0);
  corner.triangles = {{0, 1, 3}};  // without its upper right half
  const Image image = draw_picture({{corner, red}}, from_the_front, small);
  EXPECT_EQ(at(image, 40, 60).opacity, 255);
  EXPECT_EQ(at(image, 80, 20).opacity, 0);
}

TEST(Picture, PerspectiveMakesNearThingsLarger) {
  std::vector<PictureObject> objects{{square(1, -4), red, {-2, 0, 0}},
                                     {square(1, 4), blue, {2, 0, 0}}};
  const auto widths = [&](double perspective) {
    const Image image = draw_picture(objects, {{0, 1, 0}, {0, 0, 1}, perspective}, small);
    std::array<int, 2> count{0, 0};
    for (int column = 0; column < 120; ++column) {
      const Pixel seen = at(image, column, 40);
      count[0] += seen.opacity == 255 && seen.red > seen.blue ? 1 : 0;
      count[1] += seen.opacity == 255 && seen.blue > seen.red ? 1 : 0;
    }
    return count;
  };
  EXPECT_NEAR(widths(0)[0], widths(0)[1], 1);
  EXPECT_GT(widths(40)[0], 1.2 * widths(40)[1]);
}

TEST(Picture, OffsetsPlaceObjectsSideBySide) {
  const Image image = draw_picture(
      {{square(1, 0), red, {0, 0, 0}}, {square(1, 0), blue, {3, 0, 0}}}, from_the_front, small);
  EXPECT_GT(at(image, 20, 40).red, 2 * at(image, 20, 40).blue);
  EXPECT_EQ(middle(image).opacity, 0);
  EXPECT_GT(at(image, 100, 40).blue, 2 * at(image, 100, 40).red);
}

TEST(Picture, TransparentObjectsLetThingsShineThrough) {
  const PictureObject behind{square(1, 5), blue};
  PictureObject glass{square(1, -5), red, {0, 0, 0}, 0.5};
  const Pixel mixed = middle(draw_picture({glass, behind}, from_the_front, small));
  const Pixel solid = middle(draw_picture({behind}, from_the_front, small));
  EXPECT_GT(mixed.red, solid.red + 50);
  EXPECT_GT(mixed.blue, 80);
  EXPECT_LT(mixed.blue, solid.blue);
  EXPECT_EQ(mixed.opacity, 255);
  EXPECT_NEAR(middle(draw_picture({glass}, from_the_front, small)).opacity, 128, 1);
  // Behind an opaque object it is not seen at all.
  glass.offset_mm = {0, 20, 0};
  const Pixel hidden = middle(draw_picture({glass, behind}, from_the_front, small));
  EXPECT_EQ(hidden.red, solid.red);
}

TEST(Picture, LightComesFromTheUpperLeft) {
  const auto brightness = [](double x, double z) {
    // A face seen at a slant, turned towards (x, z).
    TriangleMesh face = square(1, 0);
    for (Point& p : face.vertices) {
      p[1] = x * p[0] + z * p[2];
    }
    return middle(draw_picture({{face, {0.5, 0.5, 0.5}}}, from_the_front, small)).green;
  };
  EXPECT_GT(brightness(-1, 1), brightness(0, 0));
  EXPECT_GT(brightness(0, 0), brightness(1, -1));
  EXPECT_GT(brightness(1, -1), 30) << "the far side is not black";
}

TEST(Picture, LeavesOutTrianglesThatAreNotFinite) {
  TriangleMesh broken = square(1, 0);
  broken.vertices.push_back({NAN, 0, 0});
  broken.vertices.push_back({0, INFINITY, 0});
  broken.triangles.push_back({0, 1, 4});
  broken.triangles.push_back({5, 1, 2});
  broken.triangles.push_back({0, 0, 1});
  EXPECT_EQ(draw_picture({{broken, red}}, from_the_front, small).rgba,
            draw_picture({{square(1, 0), red}}, from_the_front, small).rgba);
}

TEST(Picture, IsTheSameEveryTime) {
  const std::vector<PictureObject> objects{{torus(48, 16), blue},
                                           {torus(9, 5), red, {8, 0, 3}, 0.4}};
  const Camera camera{{1, 2, -1}, {0, 0, 1}, 25};
  EXPECT_EQ(draw_picture(objects, camera, small).rgba, draw_picture(objects, camera, small).rgba);
}

TEST(Picture, RefusesWhatCannotBeSeen) {
  const std::vector<PictureObject> objects{{square(1, 0), red}};
  EXPECT_THROW(draw_picture(objects, {{0, 0, 0}, {0, 0, 1}, 0}, small), std::invalid_argument);
  EXPECT_THROW(draw_picture(objects, {{0, 0, 2}, {0, 0, -1}, 0}, small), std::invalid_argument);
  EXPECT_THROW(draw_picture(objects, {{0, 1, 0}, {NAN, 0, 1}, 0}, small), std::invalid_argument);
  EXPECT_THROW(draw_picture(objects, {{0, 1, 0}, {0, 0, 1}, 120}, small), std::invalid_argument);
  for (const PictureOptions& options :
       {PictureOptions{0, 80}, PictureOptions{80, -1}, PictureOptions{1 << 30, 1 << 30},
        PictureOptions{80, 80, 0.5}, PictureOptions{80, 80, NAN}}) {
    EXPECT_THROW(draw_picture(objects, from_the_front, options), std::invalid_argument);
  }
}

TEST(Openness, IsFullOnAnOpenFaceAndLessBesideAWall) {
  Layer layer(200, 100);
  for (float& depth : layer.depth) {
    depth = 50;
  }
  const Point towards_the_eye{0, 0, -1};
  const AmbientOcclusion occlusion(20, 3);
  EXPECT_DOUBLE_EQ(occlusion.openness(layer, 100, 50, towards_the_eye), 1);
  for (int row = 0; row < 100; ++row) {
    for (int column = 103; column < 200; ++column) {
      layer.depth[static_cast<std::size_t>(row) * 200 + column] = 40;
    }
  }
  const auto mean = [&](int left) {
    double sum = 0;
    for (int i = 0; i < 9; ++i) {
      sum += occlusion.openness(layer, left + i % 3, 48 + i / 3, towards_the_eye) / 9;
    }
    return sum;
  };
  EXPECT_LT(mean(99), 0.9);
  EXPECT_LT(mean(99), mean(90));
  EXPECT_DOUBLE_EQ(mean(72), 1) << "farther than the radius";
  EXPECT_DOUBLE_EQ(mean(105), 1) << "on top of the wall";
}

}  // namespace
}  // namespace latticast
