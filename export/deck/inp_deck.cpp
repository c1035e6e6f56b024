// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>
#include <variant>

#include <fmt/core.h>

#include "design/units.h"
#include "export/deck/deck.h"

namespace latticast {
namespace {

constexpr double liner_d1_by_mu = 0.001;
constexpr double most_poisson_ratio = 0.4995;
constexpr std::size_t numbers_a_line = 12;
constexpr std::size_t ogden_terms = 4;

/// A line's values by commas, each as short as it can be without loss.
template <class... Numbers>
std::string line(Numbers... numbers) {
  std::string text;
  ((text += text.empty() ? fmt::format("{}", numbers) : fmt::format(", {}", numbers)), ...);
  return text + '\n';
}

/// Constants of a law; empty where decks have none like it.
struct LawLines {
  std::string operator()(const NeoHookean& law) const {
    return "*HYPERELASTIC, NEO HOOKE\n" + line(0.5 * law.shear_modulus_mpa, d1);
  }
  std::string operator()(const Yeoh& law) const {
    return "*HYPERELASTIC, YEOH\n" +
           line(law.c1_mpa, law.c2_mpa, law.c3_mpa, d1, 1e6 * d1, 1e6 * d1);
  }
  std::string operator()(const Mooney& law) const {
    return "*HYPERELASTIC, MOONEY-RIVLIN\n" + line(law.c10_mpa, law.c01_mpa, d1);
  }
  std::string operator()(const Ogden& law) const {
    const std::size_t terms = law.mu_mpa.size();
    if (terms > ogden_terms) return {};
    // There a term is 2 mu/alpha^2.
    std::string text;
    for (std::size_t i = 0; i < terms; ++i) {
      text += fmt::format("{}, {}, ", 0.5 * law.mu_mpa[i] * law.alpha[i], law.alpha[i]);
    }
    for (std::size_t i = 0; i < terms; ++i) {
      text += fmt::format("{}{}", i == 0 ? d1 : 1e6 * d1, i + 1 < terms ? ", " : "\n");
    }
    return fmt::format("*HYPERELASTIC, OGDEN, N={}\n{}", terms, text);
  }
  std::string operator()(const Gent&) const { return {}; }
  std::string operator()(const Linear&) const { return {}; }

  double d1 = 0;
};

std::string liner_lines(const Law& law) {
  return std::visit(LawLines{liner_d1_by_mu / rest_shear_modulus_mpa(law)}, law);
}

std::string lattice_lines(const Linear& law) {
  const double nu = std::min(law.poisson_ratio, most_poisson_ratio);
  const double shear = law.youngs_modulus_mpa / (2 * (1 + nu));
  const double bulk = law.youngs_modulus_mpa / (3 * (1 - 2 * nu));
  return "*HYPERELASTIC, NEO HOOKE\n" + line(0.5 * shear, 2 / bulk);
}

class InpWriter {
 public:
  InpWriter(const WedgeMesh& mesh, const DeckJob& job)
      : mesh_(mesh), job_(job), reference_(static_cast<int>(mesh.nodes.size()) + 1) {}

  std::string text() {
    add_header();
    add_mesh();
    add_sets();
    add_materials();
    add_ends();
    add_ties();
    for (const double pressure : job_.pressures_kpa) add_step(pressure);
    return std::move(text_);
  }

 private:
  int turning() const { return reference_ + 1; }  // node whose displacement is the tip's rotation
  bool is_sector() const { return mesh_.sectors > 1; }

  void add_header() {
    text_ += "*HEADING\n" + job_.title + '\n';
    text_ += "** mm, N, MPa. The tube's axis is z, its base at z = 0, its tip a rigid body.\n";
    text_ += fmt::format(
        "** Node {}, set TIP_REFERENCE, moves with the tip; node {}, set TIP_TURN, "
        "has the tip's\n** rotation in rad as its displacement.\n",
        reference_, turning());
    if (is_sector()) {
      text_ += fmt::format(
          "** One of {} equal sectors: forces and torques are those of the tube "
          "over {}.\n",
          mesh_.sectors, mesh_.sectors);
    }
  }

  void add_mesh() {
    text_ += "*NODE, NSET=ALL\n";
    for (std::size_t n = 0; n < mesh_.nodes.size(); ++n) {
      const auto& [x, y, z] = mesh_.nodes[n];
      text_ += fmt::format("{}, {:.12g}, {:.12g}, {:.12g}\n", n + 1, x, y, z);
    }
    text_ += fmt::format("*NODE, NSET=TIP_REFERENCE\n{}, 0, 0, {}\n", reference_, mesh_.length_mm);
    text_ += fmt::format("*NODE, NSET=TIP_TURN\n{}, 0, 0, {}\n", turning(), mesh_.length_mm);
    add_elements(WedgePart::liner, "LINER");
    add_elements(WedgePart::lattice, "LATTICE");
  }

  void add_elements(WedgePart part, std::string_view set) {
    text_ += fmt::format("*ELEMENT, TYPE=C3D15, ELSET={}\n", set);
    for (std::size_t w = 0; w < mesh_.wedges.size(); ++w) {
      if (mesh_.wedges[w].part != part) continue;
      text_ += fmt::format("{},", w + 1);
      for (std::size_t n = 0; n < 15; ++n) {
        text_ += fmt::format(" {}{}", mesh_.wedges[w].nodes[n] + 1, n == 14 ? "\n" : ",");
        if (n == 6) text_ += '\n';
      }
    }
  }

  void add_set(std::string_view kind, std::string_view name,
               const std::vector<std::int32_t>& numbers) {
    text_ += fmt::format("*{}={}\n", kind, name);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const bool last = (i + 1) % numbers_a_line == 0 || i + 1 == numbers.size();
      text_ += fmt::format("{}{}", numbers[i] + 1, last ? "\n" : ", ");
    }
  }

  void add_sets() {
    add_set("NSET, NSET", "BASE", mesh_.base);
    add_set("NSET, NSET", "TIP", mesh_.tip);
    add_set("NSET, NSET", "BOND", mesh_.bond);
    add_set("ELSET, ELSET", "CAVITY", mesh_.bore);
    text_ += "*SURFACE, NAME=CAVITY_FACE, TYPE=ELEMENT\nCAVITY, S1\n";
  }

  void add_materials() {
    text_ += "*MATERIAL, NAME=LINER\n" + liner_lines(job_.liner);
    text_ += "*MATERIAL, NAME=LATTICE\n" + lattice_lines(job_.lattice);
    text_ += "*SOLID SECTION, ELSET=LINER, MATERIAL=LINER\n";
    text_ += "*SOLID SECTION, ELSET=LATTICE, MATERIAL=LATTICE\n";
  }

  void add_ends() {
    text_ += "*BOUNDARY\nBASE, 1, 3\n";
    // A sector's images keep its tip on the axis.
    if (is_sector()) text_ += "TIP_REFERENCE, 1, 2\nTIP_TURN, 1, 2\n";
    text_ +=
        fmt::format("*RIGID BODY, NSET=TIP, REF NODE={}, ROT NODE={}\n", reference_, turning());
  }

  /// u_far = R u_near, R the turn by a sector about the axis. Both ends are held already.
  void add_ties() {
    std::set<std::int32_t> held(mesh_.base.begin(), mesh_.base.end());
    held.insert(mesh_.tip.begin(), mesh_.tip.end());
    const double c = std::cos(2 * pi / mesh_.sectors);
    const double s = std::sin(2 * pi / mesh_.sectors);
    for (const auto& [near, far] : mesh_.ties) {
      if (held.contains(near)) continue;
      text_ += fmt::format("*EQUATION\n3\n{}, 1, 1, {}, 1, {:.16g}, {}, 2, {:.16g}\n", far + 1,
                           near + 1, -c, near + 1, s);
      text_ += fmt::format("*EQUATION\n3\n{}, 2, 1, {}, 1, {:.16g}, {}, 2, {:.16g}\n", far + 1,
                           near + 1, -s, near + 1, -c);
      text_ += fmt::format("*EQUATION\n2\n{}, 3, 1, {}, 3, -1\n", far + 1, near + 1);
    }
  }

  void add_step(double pressure_kpa) {
    const double pressure = mpa_from_kpa(pressure_kpa);
    const double bore = pi * mesh_.inner_radius_mm * mesh_.inner_radius_mm / mesh_.sectors;
    text_ +=
        fmt::format("** {} kPa\n*STEP, NLGEOM, INC=200\n*STATIC\n0.2, 1, 1e-5, 1\n", pressure_kpa);
    text_ += fmt::format("*DLOAD\nCAVITY, P1, {}\n", pressure);
    text_ += fmt::format("*CLOAD\nTIP_REFERENCE, 3, {}\n", pressure * bore);
    text_ += "*NODE FILE\nU\n*EL FILE\nS, E\n";
    text_ += "*NODE PRINT, NSET=TIP_REFERENCE\nU\n*NODE PRINT, NSET=TIP_TURN\nU\n*END STEP\n";
  }

  const WedgeMesh& mesh_;
  const DeckJob& job_;
  int reference_;
  std::string text_;
};

}  // namespace

std::string law_without_deck(const Law& liner) {
  return liner_lines(liner).empty() ? std::string(law_name(liner)) : std::string();
}

std::string inp_deck(const WedgeMesh& mesh, const DeckJob& job) {
  return InpWriter(mesh, job).text();
}

}  // namespace latticast
