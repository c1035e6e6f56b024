// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/section/section_reading.h"

#include <algorithm>
#include <memory>
#include <string>
#include <unordered_set>
#include <variant>

#include "geometry/pattern/rings.h"
#include "model/section/bonded_lattice.h"
#include "model/section/section_symmetry.h"
#include "model/strand/links.h"

namespace latticast {
namespace {

constexpr double mixture_rubber = 0.91;
constexpr double mixture_lattice = 0.09;

/// Rings as they exist on the segment: how much of the layer they fill, and their pitch.
struct RingLayout {
  double fraction = 0;
  double pitch_mm = 0;  ///< 0: no rings
  double width_mm = 0;
};

RingLayout ring_layout(const Segment& segment) {
  const std::optional<Rings>& rings = segment.lattice->rings;
  if (!rings) return {};
  const auto count = static_cast<double>(ring_centres_mm(*rings, segment.length_mm).size());
  if (count == 0) return {};
  return {count * rings->width_mm / segment.length_mm, ring_pitch_mm(*rings, segment.length_mm),
          rings->width_mm};
}

/// k_t / V of one strand: 12 E I / L_t over w h L_t is E (w sin(alpha) / p)^2.
double joint_modulus(double modulus_mpa, double width_mm, double sine, const RingLayout& rings,
                     JointModel joint) {
  if (joint == JointModel::none || rings.pitch_mm == 0) return 0;
  const double slenderness = width_mm * sine / rings.pitch_mm;
  const double paper = modulus_mpa * slenderness * slenderness;
  if (joint == JointModel::paper) return paper;
  const double clear = rings.pitch_mm - rings.width_mm;
  if (!(clear > 0)) {
    throw UnsupportedDesign("the rings touch, so the strands have no clear span to bend in");
  }
  const double shortening = rings.pitch_mm / clear;
  return paper * shortening * shortening * shortening;
}

void refuse_in_mixture(const Grid& grid, std::size_t index) {
  if (is_curved(grid.path)) {
    throw UnsupportedDesign(grid_name(index) + " has " + std::string(describe(grid.path).name) +
                            " strands, which the mixture wall cannot tell from "
                            "straight ones; use kind = \"layered\"");
  }
  const auto [thin, wide] = std::minmax_element(grid.widths_mm.begin(), grid.widths_mm.end());
  if (*thin != *wide) {
    throw UnsupportedDesign(grid_name(index) +
                            " has strands of unequal width, so the section bends, but the mixture "
                            "wall counts no strips; use kind = \"layered\"");
  }
}

void add_pad(const Segment& segment, const Grid& grid, double width_mm, StrandPlace& strand) {
  const double period = segment.lattice_circumference_mm() * grid.direction().sine / grid.count();
  strand.pad_mm =
      pad_thickness_mm(period, width_mm / period, segment.liner.thickness_mm) / grid.count();
}

Bond bond_of_rings(const Segment& segment, const RingLayout& rings) {
  if (rings.pitch_mm == 0) return {};
  const double share = rings.width_mm / rings.pitch_mm;
  return {share, pad_thickness_mm(rings.pitch_mm, share, segment.liner.thickness_mm)};
}

struct Layer {
  const Segment& segment;
  const ModelChoice& model;
  RingLayout rings;
  LawsByShape laws;
};

/// Strips and rings are plates on the liner; a unit cell's section is the nearest one to it.
bool is_bonded(const ModelChoice& model) {
  return model.wall == WallKind::bonded || model.wall == WallKind::unit_cell;
}

void refuse_in_bonded(const Grid& grid, std::size_t index) {
  if (!is_curved(grid.path)) return;
  throw UnsupportedDesign(
      grid_name(index) + " has " + std::string(describe(grid.path).name) +
      " strands, which kind = \"bonded\" knows by calibration alone; use kind = "
      "\"layered\"");
}

StrandFamily strand_family(const Layer& layer, std::size_t index) {
  const Segment& segment = layer.segment;
  const Grid& grid = segment.lattice->grids[index];
  const bool layered = layer.model.wall != WallKind::mixture;
  if (!layered) refuse_in_mixture(grid, index);
  if (is_bonded(layer.model)) refuse_in_bonded(grid, index);
  const double modulus = strand_modulus_mpa(*segment.lattice);
  // Exactly mirrored for mirrored angles: a symmetric lattice is symmetric to the last bit, and
  // does not twist.
  const StrandDirection direction = grid.direction();
  StrandFamily family;
  family.cosine = direction.cosine;
  family.sine = direction.sine;
  const double around = segment.lattice_circumference_mm() * family.sine;
  double filled = 0;
  for (const double width : grid.widths_mm) {
    StrandPlace strand;
    if (const auto link = link_shape(segment, grid, width)) {
      strand.law = layer.laws.at(*link);
      family.links_per_mm = 1 / (strand.law->rest_chord_mm() * family.sine);
    } else {
      // The mixture counts no strips: a family as a whole carries c2, whatever its strands.
      const double fraction = layered ? width / around : mixture_lattice / grid.count();
      filled += fraction;
      strand.stretch_modulus_mpa = fraction * modulus;
      if (is_bonded(layer.model)) {
        const auto& material = std::get<Linear>(segment.lattice->material.law);
        strand.joint_modulus_mpa =
            fraction * clear_shear_joint_mpa(material, width, family.sine, layer.rings.pitch_mm,
                                             layer.rings.width_mm);
        add_pad(segment, grid, width, strand);
        family.pad_mm += strand.pad_mm;
      } else {
        strand.joint_modulus_mpa =
            fraction * joint_modulus(modulus, width, family.sine, layer.rings, layer.model.joint);
      }
      family.stretch_modulus_mpa += strand.stretch_modulus_mpa;
      family.joint_modulus_mpa += strand.joint_modulus_mpa;
    }
    family.strands.push_back(std::move(strand));
  }
  if (layered && filled > 1) {
    throw UnsupportedDesign("the strands of " + grid_name(index) + " overlap: they would fill " +
                            std::to_string(filled) + " times the layer at mid radius");
  }
  return family;
}

void add_lattice(const Segment& segment, const ModelChoice& model, const StrandLaws& known,
                 Section& section) {
  const bool mixture = model.wall == WallKind::mixture;
  if (mixture) {
    section.isotropic_fraction = mixture_rubber;
    section.isotropic_to_mm = section.outer_radius_mm;
  }
  section.anisotropic_from_mm = mixture ? section.inner_radius_mm : section.liner_outer_radius_mm;
  section.anisotropic_to_mm = section.outer_radius_mm;
  const RingLayout rings = ring_layout(segment);
  double share = mixture && rings.pitch_mm > 0 ? mixture_lattice : rings.fraction;
  if (is_bonded(model)) {
    section.bond = bond_of_rings(segment, rings);
    share = section.bond->ring_share;
  }
  section.ring_modulus_mpa = share * strand_modulus_mpa(*segment.lattice);
  const Layer layer{segment, model, rings, mixture ? LawsByShape{} : build_laws(segment, known)};
  for (std::size_t i = 0; i < segment.lattice->grids.size(); ++i) {
    if (segment.lattice->grids[i].count() == 0) continue;
    section.families.push_back(strand_family(layer, i));
  }
  settle_symmetry(segment, model, section);
}

const Law& rubber_law(const Material& liner) {
  if (!std::holds_alternative<Linear>(liner.law)) return liner.law;
  throw UnsupportedDesign(
      "the liner has a linear law, which only axial columns under columns = \"rods\" can use; "
      "other sections need a rubber (" +
      rubber_law_names() + ")");
}

}  // namespace

Section prepare_section(const Segment& segment, const ModelChoice& model, const StrandLaws& known) {
  Section section;
  section.inner_radius_mm = segment.inner_radius_mm();
  section.liner_outer_radius_mm = segment.liner_outer_radius_mm();
  section.outer_radius_mm = segment.outer_radius_mm();
  section.isotropic_from_mm = section.inner_radius_mm;
  section.isotropic_to_mm = section.liner_outer_radius_mm;
  section.anisotropic_from_mm = section.anisotropic_to_mm = section.liner_outer_radius_mm;
  section.liner_law = rubber_law(segment.liner.material);
  section.shear_modulus_mpa = rest_shear_modulus_mpa(section.liner_law);
  section.isotropic = true;
  if (segment.lattice) add_lattice(segment, model, known, section);
  return section;
}

StrandLaws laws_of(const Section& section) {
  StrandLaws laws;
  std::unordered_set<const StrandLaw*> met;
  for (const StrandFamily& family : section.families) {
    for (const StrandPlace& strand : family.strands) {
      if (strand.law && met.insert(strand.law.get()).second) laws.push_back(strand.law);
    }
  }
  return laws;
}

}  // namespace latticast
