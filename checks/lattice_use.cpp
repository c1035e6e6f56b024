// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/lattice_use.h"

namespace latticast {

double least_wall_mm(const Printer& printer) {
  return printer.min_wall_mm.value_or(printer.process == Process::sla ? 0.4 : 0.8);
}

double least_gap_mm(const Printer& printer) {
  return printer.min_gap_mm.value_or(printer.process == Process::sla ? 0.3 : 0.4);
}

std::string LatticeUse::part(const std::string& name) const {
  return (grooved ? "lattice-mold " : "") + name;
}

std::string LatticeUse::strand_word() const {
  return grooved ? "groove" : "strand";
}

std::string LatticeUse::between_word() const {
  return grooved ? "land" : "gap";
}

std::string LatticeUse::strand_limit() const {
  return grooved ? "least gap" : "least wall";
}

std::string LatticeUse::between_limit() const {
  return grooved ? "least wall" : "least gap";
}

std::vector<LatticeUse> lattice_uses(const Design& design) {
  const Make& make = design.make;
  const Printer& printer = design.printer;
  const bool grooved = make.lattice_mold && make.lattice_mold->method == MoldMethod::direct;
  const bool pattern = make.lattice_mold && !grooved;
  const bool nothing_yet = !make.lattice && !make.liner && !make.lattice_mold && !make.liner_mold;
  std::vector<LatticeUse> uses;
  const bool alone = make.lattice || nothing_yet;
  if (alone || pattern) {
    uses.push_back({false, least_wall_mm(printer), least_gap_mm(printer),
                    printer.min_gap_mm.has_value(), alone});
  }
  if (grooved) {
    uses.push_back({true, least_gap_mm(printer), least_wall_mm(printer),
                    printer.min_wall_mm.has_value(), false});
  }
  return uses;
}

}  // namespace latticast
