// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/material/law.h"

#include <iterator>

#include <fmt/core.h>

#include "design/text/written_number.h"

namespace latticast {
namespace {

template <class... Laws>
constexpr bool all_answer(const std::variant<Laws...>*) {
  return (ConstitutiveLaw<Laws> && ...);
}
static_assert(all_answer(static_cast<const Law*>(nullptr)));

template <class... Laws>
std::vector<std::string_view> names_of(const std::variant<Laws...>*) {
  return {Laws::name...};
}

std::string value_text(const LawConstant& constant) {
  if (!constant.is_list) return fmt::format("{}", written(constant.values.front(), 6));
  std::string text;
  for (const double value : constant.values) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", written(value, 6));
  }
  return fmt::format("[{}]", text);
}

}  // namespace

std::string_view law_name(const Law& law) {
  return std::visit([](const auto& l) { return l.name; }, law);
}

std::string rubber_law_names() {
  std::vector<std::string_view> names = names_of(static_cast<const Law*>(nullptr));
  std::erase(names, Linear::name);
  const std::string_view last = names.back();
  names.pop_back();
  std::string text;
  for (const std::string_view name : names) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", name);
  }
  return fmt::format("{} or {}", text, last);
}

double rest_shear_modulus_mpa(const Law& law) {
  return std::visit([](const auto& l) { return l.rest_shear_modulus_mpa(); }, law);
}

double first_invariant_limit(const Law& law) {
  return std::visit([](const auto& l) { return l.first_invariant_limit(); }, law);
}

EnergyDensity energy_density(const Law& law, const InPlaneStretch& at) {
  return std::visit([&](const auto& l) { return l.energy_density(at); }, law);
}

Law scaled(Law law, double factor) {
  const auto scale = [factor]<class L>(L& l) {
    for (const LawKey<L>& key : L::keys) {
      if (key.range.unit != std::string_view("MPa")) continue;
      if (const auto* number = std::get_if<double L::*>(&key.member)) {
        l.** number *= factor;
      } else {
        for (double& x : l.*std::get<std::vector<double> L::*>(key.member)) x *= factor;
      }
    }
  };
  std::visit(scale, law);
  return law;
}

std::string law_fault(const Law& law) {
  const auto own_fault = []<class L>(const L& l) -> std::string {
    if constexpr (requires { l.fault(); }) return std::string(l.fault());
    return "";
  };
  if (std::string fault = std::visit(own_fault, law); !fault.empty()) return fault;
  const double modulus = rest_shear_modulus_mpa(law);
  if (!(modulus < modulus_range.low)) return "";
  return fmt::format("its shear modulus at rest, {} MPa, must be at least {} MPa",
                     written(modulus, 6), written(modulus_range.low, 6));
}

std::vector<LawConstant> constants_of(const Law& law) {
  std::vector<LawConstant> constants;
  const auto collect = [&constants]<class L>(const L& l) {
    for (const LawKey<L>& key : L::keys) {
      if (const auto* number = std::get_if<double L::*>(&key.member)) {
        constants.push_back({key.key, key.range.unit, {l.**number}, false});
      } else {
        const auto list = std::get<std::vector<double> L::*>(key.member);
        constants.push_back({key.key, key.range.unit, l.*list, true});
      }
    }
  };
  std::visit(collect, law);
  return constants;
}

std::string law_text(const Law& law) {
  std::string text(law_name(law));
  const std::vector<LawConstant> constants = constants_of(law);
  for (std::size_t i = 0; i < constants.size(); ++i) {
    const LawConstant& constant = constants[i];
    text += fmt::format(", {} = {}", constant.key, value_text(constant));
    const bool unit_follows = i + 1 < constants.size() && constants[i + 1].unit == constant.unit;
    if (!constant.unit.empty() && !unit_follows) text += fmt::format(" {}", constant.unit);
  }
  return text;
}

}  // namespace latticast
