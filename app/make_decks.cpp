// SPDX-License-Identifier: GPL-3.0-or-later
// Decks for finite-element programs, segment by segment.
#include <fmt/core.h>

#include "app/makers.h"
#include "design/design.h"
#include "design/unsupported_design.h"
#include "export/deck/deck.h"
#include "files/atomic_file.h"
#include "geometry/pattern/rings.h"
#include "model/cell/cell_materials.h"
#include "model/cell/drawn_cell.h"
#include "model/cell/strip_wedges.h"
#include "model/prediction.h"

namespace latticast {
namespace {

constexpr StripDivision division = {
    .strip = 2, .gap = 4, .ring = 1, .span = 2, .liner = 3, .lattice = 1, .grading = 1.6};

/// Throws UnsupportedDesign where a segment has no deck.
void require_deck(const Design& design, std::size_t s) {
  const Segment& segment = design.segments[s];
  const std::string problem = parts_problem(segment);
  if (!problem.empty()) {
    throw UnsupportedDesign(
        fmt::format("segment {} has no deck: a deck {}; leave make.deck out", s + 1, problem));
  }
  const std::string law = law_without_deck(segment.liner.material.law);
  if (design.make.deck->inp && !law.empty()) {
    throw UnsupportedDesign(fmt::format(
        "segment {} has no deck: its programs know no {} law like the liner's; fit another one to "
        "it, or ask for formats = [\"msh\"] alone",
        s + 1, law));
  }
}

/// Strips have hexahedra's edges along them, anything else is what the plane shows.
WedgeMesh mesh_of(const Segment& segment, bool whole, std::size_t s) {
  if (const FoundStrips found = find_strips(segment); found.tube) {
    const std::optional<Rings>& rings = segment.lattice->rings;
    return strip_wedges(*found.tube, segment.length_mm,
                        rings ? ring_centres_mm(*rings, segment.length_mm) : std::vector<double>{},
                        division, whole);
  }
  FoundWedges found = find_drawn_wedges(segment, whole);
  if (found.mesh) return std::move(*found.mesh);
  throw UnsupportedDesign(
      fmt::format("segment {} has no deck: its lattice {}", s + 1, found.reason));
}

void make_deck(Build& build, std::size_t s) {
  const Design& design = build.design();
  Delivery& delivery = build.delivery;
  const Segment& segment = design.segments[s];
  const Deck& deck = *design.make.deck;
  const std::string stem = delivery.part_name(s, "deck");
  delivery.progress().begin(stem);
  const WedgeMesh mesh = mesh_of(segment, deck.whole, s);
  std::string files;
  if (deck.inp) {
    const DeckJob job{design.name, segment.liner.material.law,
                      std::get<Linear>(segment.lattice->material.law),
                      segment_pressures_kpa(design, s, {})};
    write_file_atomically(delivery.add_file(stem + ".inp"), inp_deck(mesh, job));
    files += stem + ".inp";
  }
  if (deck.msh) {
    write_file_atomically(delivery.add_file(stem + ".msh"), msh_deck(mesh));
    files += (files.empty() ? "" : ", ") + stem + ".msh";
  }
  delivery.tell(fmt::format("{}: {}, {} wedges, {} nodes\n", files,
                            mesh.sectors == 1
                                ? std::string("whole tube")
                                : fmt::format("one of {} equal sectors", mesh.sectors),
                            mesh.wedges.size(), mesh.nodes.size()));
  delivery.note_time(stem);
}

}  // namespace

void make_decks(Build& build, std::vector<Task>& tasks) {
  const Design& design = build.design();
  build.delivery.progress().expect(static_cast<int>(design.segments.size()));
  for (std::size_t s = 0; s < design.segments.size(); ++s) {
    require_deck(design, s);
    tasks.push_back({s, [&build, s] { make_deck(build, s); }});
  }
}

}  // namespace latticast
