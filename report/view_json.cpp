// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/view_json.h"

#include <array>
#include <cmath>
#include <span>

#include <nlohmann/json.hpp>

#include "checks/check_finding.h"
#include "design/design.h"
#include "design/units.h"
#include "model/shape/shape.h"
#include "report/report_view.h"

namespace latticast {
namespace {

using Json = nlohmann::ordered_json;

// Shepperd's choice of the largest component keeps all digits (Shepperd 1978).
std::array<double, 4> quaternion(const Rotation& r) {
  const double trace = r[0][0] + r[1][1] + r[2][2];
  std::size_t largest = 3;
  double most = trace;
  for (std::size_t i = 0; i < 3; ++i) {
    if (r[i][i] > most) {
      most = r[i][i];
      largest = i;
    }
  }
  std::array<double, 4> q{};
  if (largest == 3) {
    q = {r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1], 1 + trace};
  } else {
    const std::size_t i = largest;
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    q[i] = 1 + r[i][i] - r[j][j] - r[k][k];
    q[j] = r[j][i] + r[i][j];
    q[k] = r[k][i] + r[i][k];
    q[3] = r[k][j] - r[j][k];
  }
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& x : q) x /= length;
  return q;
}

Json end_json(const State& state, const Segment& segment) {
  const Frame end = frame_along(state, segment.length_mm);
  return {{"pressure_kPa", state.pressure_kpa},
          {"end", {{"origin_mm", end.origin}, {"quaternion", quaternion(end.rotation)}}}};
}

Json segment_json(const ViewSegment& view, const Segment& segment, std::size_t number) {
  Json json{{"number", number}, {"rest_length_mm", segment.length_mm}};
  json["bodies"] = Json::array();
  for (const ViewBody& body : view.bodies) {
    json["bodies"].push_back({{"node", body.node}, {"role", body.is_liner ? "liner" : "lattice"}});
  }
  json["states"] = Json::array();
  for (const State& state : view.states) json["states"].push_back(end_json(state, segment));
  return json;
}

// On the outer surface, so that the place can be seen.
Json marker_json(const ViewSegment& view, const Segment& segment, const CheckFinding& finding,
                 std::size_t index) {
  const double theta = radians(finding.place->theta_deg);
  const double radius = segment.outer_radius_mm();
  const Point rest{radius * std::cos(theta), radius * std::sin(theta), finding.place->z_mm};
  Json places = Json::array();
  for (const State& state : view.states) {
    const Shape shape(std::span(&segment, 1), std::span(&state, 1));
    places.push_back(shape.moved(rest, 0));
  }
  return {{"finding", index}, {"segment", finding.segment}, {"positions_mm", places}};
}

Json markers_json(const ReportView& view, const Design& design, const CheckFindings& findings) {
  Json markers = Json::array();
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const CheckFinding& finding = findings[i];
    if (!finding.place || finding.segment < 1) continue;
    const std::size_t s = static_cast<std::size_t>(finding.segment) - 1;
    markers.push_back(marker_json(view.segments[s], design.segments[s], finding, i));
  }
  return markers;
}

}  // namespace

std::string view_json(const ReportView& view, const Design& design, const CheckFindings& findings) {
  Json json;
  json["segments"] = Json::array();
  for (std::size_t s = 0; s < view.segments.size(); ++s) {
    json["segments"].push_back(segment_json(view.segments[s], design.segments[s], s + 1));
  }
  json["markers"] = markers_json(view, design, findings);
  json["cases"] = Json::array();
  for (const LoadCase& load : design.load) {
    json["cases"].push_back({{"pressures_kPa", load.pressures_kpa}});
  }
  json["tolerance_mm"] = view.tolerance_mm;
  json["note"] = view.note;
  return json.dump();
}

}  // namespace latticast
