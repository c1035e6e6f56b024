// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/property/random_design_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/unit/geometry/solid/random_patterns.h"

namespace latticast {
namespace {

// Keeps most meshes below 200,000 triangles.
constexpr double most_outline_pieces = 15'000;

constexpr int impossible_pressure = 11;  // the last of the mistakes

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

struct SegmentDraft {
  double length;
  double inner_radius;
  double liner_thickness;
  double lattice_thickness;
  std::string lattice_text;
  double thinnest;
  double outlines_around = 0;  // how often outlines go around the tube, all together
  int outline_count = 0;
};

class Writer {
 public:
  explicit Writer(std::uint64_t seed) : random_(seed) {}

  DesignText run() {
    if (one_in(8)) mistake_ = random_.whole(0, impossible_pressure);
    const int segments = one_in(4) ? random_.whole(2, 3) : 1;
    std::vector<SegmentDraft> drafts;
    const double size = random_.log_between(0.3, 30);
    for (int i = 0; i < segments; ++i) drafts.push_back(draft_segment(size));
    const double tolerance = fitting_tolerance(drafts);
    std::string text = "name = \"random\"\n";
    for (const SegmentDraft& draft : drafts) text += segment_text(draft);
    text += model_text() + make_text() + "[export]\ntolerance = " + number(tolerance) + "\n" +
            "formats = " + formats() + "\n";
    return with_mistake(std::move(text), drafts.front());
  }

 private:
  bool one_in(int n) { return random_.whole(1, n) == 1; }

  template <class... Text>
  std::string any_of(const Text&... texts) {
    const std::vector<std::string> all{texts...};
    return all[static_cast<std::size_t>(random_.whole(0, static_cast<int>(all.size()) - 1))];
  }

  SegmentDraft draft_segment(double size) {
    SegmentDraft draft{};
    draft.length = size * random_.log_between(1, 20);
    draft.inner_radius = size * random_.log_between(0.4, 4);
    draft.liner_thickness = draft.inner_radius * random_.between(0.1, 0.6);
    draft.lattice_thickness = draft.liner_thickness * random_.between(0.2, 1);
    draft.thinnest = std::min(draft.liner_thickness, draft.lattice_thickness);
    const bool rings = one_in(2);
    const int families = random_.whole(rings ? 0 : 1, 3);
    if (one_in(4)) add_fillet(draft);
    if (rings) add_rings(draft);
    double angle = 0;
    for (int i = 0; i < families; ++i) {
      angle = i == 0 || one_in(2) ? any_angle() : angle_near(angle);
      if (one_in(3)) {
        one_in(3) ? add_sinusoids(draft) : add_horseshoes(draft);
      } else {
        add_family(draft, angle);
      }
    }
    return draft;
  }

  void add_rings(SegmentDraft& draft) {
    const int count = random_.whole(2, 12);
    const double share = draft.length / count;
    const double width = share * (one_in(5) ? 0.999 : random_.between(0.05, 0.9));
    draft.lattice_text += "[segment.lattice.rings]\n";
    draft.lattice_text += one_in(2) ? "count = " + std::to_string(count) + "\n"
                                    : "pitch = " + number(share * random_.between(1, 1.3)) + "\n";
    draft.lattice_text += "width = " + number(width) + "\n";
    draft.thinnest = std::min(draft.thinnest, width);
    draft.outlines_around += 2 * count;
    draft.outline_count += 2 * count;
  }

  double any_angle() {
    switch (random_.whole(0, 7)) {
      case 0:
        return 90;
      case 1:
        return random_.between(89.9, 90.1);
      case 2:
        return one_in(2) ? random_.log_between(0.5, 8) : 180 - random_.log_between(0.5, 8);
      case 3:
        return 5.0 * random_.whole(1, 35);
      default:
        return random_.between(8, 172);
    }
  }

  double angle_near(double other) {
    switch (random_.whole(0, 3)) {
      case 0:
        return other;
      case 1:
        return 180 - other;
      case 2:
        return std::min(other + random_.log_between(1e-6, 1), 179.5);
      default:
        return 180 - other + random_.between(-1e-3, 1e-3);
    }
  }

  void add_family(SegmentDraft& draft, double angle) {
    const double middle =
        draft.inner_radius + draft.liner_thickness + 0.5 * draft.lattice_thickness;
    const double around = 2 * std::numbers::pi * middle;
    const double radians = angle * std::numbers::pi / 180;
    const int count = random_.whole(1, 12);
    const double fraction = one_in(8) ? 0.99999 : random_.between(0.02, 0.85);
    const double width = fraction * around * std::sin(radians) / count;
    draft.lattice_text += "[[segment.lattice.grid]]\nangle = " + number(angle) + "\n";
    if (one_in(5)) {
      draft.lattice_text += "width = [";
      for (int i = 0; i < count; ++i)
        draft.lattice_text += number(width * random_.between(0.5, 1)) + ", ";
      draft.lattice_text += "]\n";
    } else {
      draft.lattice_text +=
          "count = " + std::to_string(count) + "\nwidth = " + number(width) + "\n";
    }
    draft.thinnest = std::min(draft.thinnest, 0.5 * width);
    draft.outlines_around += 2 * count * draft.length / std::abs(std::tan(radians)) / around;
    draft.outline_count += 2 * count;
  }

  void add_fillet(SegmentDraft& draft) {
    const double fillet = draft.inner_radius * random_.log_between(0.003, 0.7);
    draft.lattice_text += "fillet = " + number(fillet) + "\n";
    draft.thinnest = std::min(draft.thinnest, fillet);
  }

  // Mostly columns that close and leave gaps.
  void add_horseshoes(SegmentDraft& draft) {
    const double middle =
        draft.inner_radius + draft.liner_thickness + 0.5 * draft.lattice_thickness;
    const double around = 2 * std::numbers::pi * middle;
    const double angle = one_in(3) ? 90 : random_.between(20, 160);
    const double sine = std::sin(angle * std::numbers::pi / 180);
    const bool alternate = !one_in(4);
    const double arc = one_in(3) ? 180 : random_.between(30, one_in(8) ? 270 : 180);
    const double bend = std::sin(0.5 * arc * std::numbers::pi / 180);
    const int count = random_.whole(1, 8);
    const double share = around * sine / count;
    const double longest = std::min(share, draft.length / sine);
    const int arcs = std::min(40, static_cast<int>(std::ceil(draft.length / sine / longest *
                                                             random_.log_between(0.7, 5))));
    const double closing = draft.length / sine / arcs / (2 * bend);
    const double radius = one_in(12) ? closing * random_.between(0.9, 1.1) : closing;
    const double width = random_.log_between(0.05, 0.7) * std::min(1.5 * radius, share);
    draft.lattice_text += "[[segment.lattice.grid]]\nangle = " + number(angle) +
                          "\ncount = " + std::to_string(count) + "\n";
    if (one_in(3)) {
      draft.lattice_text += "width = { from = " + number(width) + ", to = " + number(0.5 * width) +
                            ", profile = " + any_of("\"cosine\"", "\"halves\"") + " }\n";
    } else {
      draft.lattice_text += "width = " + number(width) + "\n";
    }
    draft.lattice_text += "horseshoe = { radius = " + number(radius) + ", arc = " + number(arc) +
                          ", alternate = " + (alternate ? "true" : "false") + " }\n";
    draft.thinnest = std::min(draft.thinnest, 0.5 * width);
    const double along = arcs * radius * arc * std::numbers::pi / 180;
    draft.outlines_around += 4 * count * along / around;
    draft.outline_count += 4 * count * arcs;
  }

  // Mostly waves that neither fold over themselves nor meet their neighbours.
  void add_sinusoids(SegmentDraft& draft) {
    const double middle =
        draft.inner_radius + draft.liner_thickness + 0.5 * draft.lattice_thickness;
    const double around = 2 * std::numbers::pi * middle;
    const double angle = one_in(3) ? 90 : random_.between(20, 160);
    const double sine = std::sin(angle * std::numbers::pi / 180);
    const int count = random_.whole(1, 8);
    const double share = around * sine / count;
    const int links = random_.whole(1, 40);
    const double chord = draft.length / sine / links;
    const double slope = random_.log_between(0.05, one_in(8) ? 8 : 2);
    const double amplitude =
        std::min(slope * chord / std::numbers::pi, one_in(8) ? share : 0.4 * share);
    const double radius = chord * chord / (std::numbers::pi * std::numbers::pi * amplitude);
    const double width =
        random_.log_between(0.05, 0.7) * std::min({2 * radius, share - amplitude, chord});
    draft.lattice_text += "[[segment.lattice.grid]]\nangle = " + number(angle) +
                          "\ncount = " + std::to_string(count) + "\nwidth = " + number(width) +
                          "\nsinusoid = { amplitude = " + number(amplitude) +
                          ", waves = " + number(0.5 * links) + " }\n";
    draft.thinnest = std::min(draft.thinnest, 0.5 * width);
    const double along = links * std::hypot(chord, 2 * amplitude);
    draft.outlines_around += 4 * count * along / around;
    draft.outline_count += 4 * count * links;
  }

  // As fine as anyone may ask for, but not so fine that the tests take hours.
  double fitting_tolerance(const std::vector<SegmentDraft>& drafts) {
    double coarsest = 1;
    double needed = 1e-5;
    for (const SegmentDraft& draft : drafts) {
      coarsest = std::min(coarsest, 0.9 * draft.thinnest);
      const double radius = draft.inner_radius + draft.liner_thickness + draft.lattice_thickness;
      const double turns = draft.outlines_around + 0.2 * draft.outline_count + 2;
      const double sectors = most_outline_pieces / static_cast<double>(drafts.size()) / turns;
      const double angle = 2 * std::numbers::pi / sectors;
      needed = std::max(needed, radius * angle * angle / 12);
    }
    const double wanted = drafts.front().inner_radius * random_.log_between(2e-4, 2e-2);
    return std::min(coarsest, std::max(wanted, needed));
  }

  std::string segment_text(const SegmentDraft& draft) {
    return "[[segment]]\nlength = " + number(draft.length) +
           "\n[segment.liner]\ninner_radius = " + number(draft.inner_radius) +
           "\nthickness = " + number(draft.liner_thickness) + "\nmaterial = " +
           any_of("\"ecoflex-00-50\"", "\"dragon-skin-30\"", "{ law = \"neo-hookean\", mu = 0.08 }",
                  "{ law = \"yeoh\", c1 = 0.04, c2 = 0.002, c3 = 0 }",
                  "{ law = \"gent\", mu = 0.08, jm = 30 }") +
           "\n[segment.lattice]\nthickness = " + number(draft.lattice_thickness) +
           "\nmaterial = \"hei-cast-8400\"\n" + draft.lattice_text;
  }

  std::string model_text() {
    return "[model]\njoint = " + any_of("\"none\"", "\"paper\"", "\"clear-span\"") + "\n";
  }

  std::string make_text() {
    std::string text = "[make]\nlattice = true\n";
    if (mistake_ == impossible_pressure) return text + "preview = { pressures = [5000] }\n";
    if (one_in(3)) text += "liner = true\n";
    if (one_in(6))
      text += "preview = { pressures = " + any_of("[0, 5]", "[3]", "[-2, 10]") + " }\n";
    return text;
  }

  std::string formats() {
    return any_of("[\"stl\"]", "[\"stl\"]", "[\"obj\"]", "[\"obj\", \"stl\"]");
  }

  DesignText with_mistake(std::string text, const SegmentDraft& first) {
    const auto replaced = [&](const std::string& old, const std::string& by) {
      const std::size_t at = text.find(old);
      if (at != std::string::npos) text.replace(at, old.size(), by);
      return at != std::string::npos;
    };
    const std::string length = "length = " + number(first.length);
    switch (mistake_) {
      case 0:
        return {text + "[[segment\n", "syntax"};
      case 1:
        replaced(length, "length = -5");
        return {text, "negative length"};
      case 2:
        replaced(length, "length = nan");
        return {text, "length that is no number"};
      case 3:
        replaced("[export]", "[export]\ncolour = \"red\"");
        return {text, "unknown key"};
      case 4:
        replaced("formats = [", "formats = [\"dwg\", ");
        return {text, "unknown format"};
      case 5:
        replaced("material = \"hei-cast-8400\"", "material = \"unobtainium\"");
        return {text, "unknown material"};
      case 6:
        replaced("thickness = ", "thickness = \"thick\" # ");
        return {text, "text in place of a number"};
      case 7:
        if (replaced("angle = ", "angle = 180 # ")) return {text, "angle of 180 degrees"};
        break;
      case 8:
        if (replaced("width = ", "width = 1e4 # ")) return {text, "strands or rings that overlap"};
        break;
      case 9:
        replaced("tolerance = ", "tolerance = 0 # ");
        return {text, "tolerance of nothing"};
      case 10:
        replaced(length + "\n", "");
        return {text, "missing length"};
      case impossible_pressure:
        return {text, "pressure beyond every equilibrium"};
      default:
        break;
    }
    return {text, ""};
  }

  RandomNumbers random_;
  int mistake_ = -1;
};

}  // namespace

DesignText random_design_text(std::uint64_t seed) {
  return Writer(seed).run();
}

}  // namespace latticast
