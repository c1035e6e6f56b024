// SPDX-License-Identifier: GPL-3.0-or-later
// Constitutive laws: the closed list of them, and what can be asked of any one. Each law is a
// struct in a header of its own that answers all of it (`ConstitutiveLaw`).
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "design/material/gent.h"
#include "design/material/linear.h"
#include "design/material/mooney.h"
#include "design/material/neo_hookean.h"
#include "design/material/ogden.h"
#include "design/material/yeoh.h"

namespace latticast {

using Law = std::variant<Linear, NeoHookean, Yeoh, Gent, Mooney, Ogden>;

/// What a law must answer:
///   name, keys              how the design file calls it and its constants
///   rest_shear_modulus_mpa  at small strain
///   first_invariant_limit   I1 - 3 that it cannot reach; infinite where there is no such limit
///   energy_density          with exact derivatives; zero with zero gradient at rest, and of full
///                           relative accuracy near it
/// Optional: `std::string_view fault() const`, a rule that the constants break between them beyond
/// their ranges; empty when they break none, and where one of them is not a number.
template <class L>
concept ConstitutiveLaw = requires(const L& law, const InPlaneStretch& at) {
  { L::name } -> std::convertible_to<std::string_view>;
  { L::keys[0] } -> std::convertible_to<LawKey<L>>;
  { law.rest_shear_modulus_mpa() } -> std::same_as<double>;
  { law.first_invariant_limit() } -> std::same_as<double>;
  { law.energy_density(at) } -> std::same_as<EnergyDensity>;
};

/// As the design file spells it: "neo-hookean".
std::string_view law_name(const Law& law);

/// Names of the laws that a rubber can have, all but linear: "neo-hookean, yeoh or gent".
std::string rubber_law_names();

/// Shear modulus at rest in MPa.
double rest_shear_modulus_mpa(const Law& law);

/// I1 - 3 that the law cannot reach; infinite where there is no such limit.
double first_invariant_limit(const Law& law);

/// Stored energy per volume. Precondition: I1 - 3 is below the law's limit.
EnergyDensity energy_density(const Law& law, const InPlaneStretch& at);

/// The same law with all moduli times `factor`: every stress is multiplied by it, every law here
/// being proportional to its moduli. Ratios, exponents and limits stay.
Law scaled(Law law, double factor);

/// What is wrong with the constants beyond their single ranges: a rest shear modulus that is not
/// positive, or the law's own rule. Empty when nothing is, or when one of them is not a number.
std::string law_fault(const Law& law);

/// One constant with its value, or with its list of values.
struct LawConstant {
  std::string_view key;
  std::string_view unit;  ///< empty: a pure number
  std::vector<double> values;
  bool is_list = false;
};

/// In the order of the law's keys.
std::vector<LawConstant> constants_of(const Law& law);

/// For people: "gent, mu = 0.08 MPa, jm = 60". Neighbours of one unit share it.
std::string law_text(const Law& law);

}  // namespace latticast
