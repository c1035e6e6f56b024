// SPDX-License-Identifier: GPL-3.0-or-later
// The bill of pieces: what to print and cast, of what, how much of it.
"use strict";

const PIECE_KINDS = {
  lattice: "lattice",
  liner: "liner",
  "lattice-mold": "mold of the lattice",
  "liner-mold": "mold of the liner",
};

/** @param {Object[]} pieces @returns {Array<[string, number, number|null]>} material, mm³, grams or null */
function amounts_by_material(pieces) {
  const amounts = new Map();
  for (const piece of pieces.filter((p) => p.material)) {
    const [volume, mass] = amounts.get(piece.material) ?? [0, 0];
    amounts.set(piece.material, [
      volume + (piece.volume_mm3 ?? 0),
      mass === null || !is_number(piece.mass_g) ? null : mass + piece.mass_g,
    ]);
  }
  return [...amounts].map(([material, [volume, mass]]) => [material, volume, mass]);
}

/** @param {Object[]} pieces @returns {HTMLElement} */
function piece_table(pieces) {
  return table_of(
    "Bill of pieces",
    [
      { head: "Piece", cell: (p) => (p.prints > 1 ? `${p.name}: print ${p.prints} ×` : p.name) },
      { head: "Kind", cell: (p) => PIECE_KINDS[p.kind] ?? p.kind },
      { head: "Segment", number: true, cell: (p) => (p.segment > 0 ? String(p.segment) : null) },
      { head: "Material", cell: (p) => p.material },
      { head: "Size x × y × z", unit: "mm", number: true, cell: (p) => size_text(p.size_mm) },
      {
        head: "Volume",
        unit: "cm³",
        number: true,
        cell: (p) => measured(is_number(p.volume_mm3) ? p.volume_mm3 / 1000 : null),
      },
      { head: "Mass", unit: "g", number: true, cell: (p) => measured(p.mass_g) },
      {
        head: "Files",
        cell: (p) =>
          h(
            "ul",
            { class: "plain" },
            list(p.files).map((file) => h("li", {}, file)),
          ),
      },
    ],
    pieces,
  );
}

/** @param {Object} report */
function show_pieces(report) {
  const pieces = list(report.pieces);
  const box = by_id("pieces-content");
  if (pieces.length === 0) {
    box.append(h("p", {}, "No piece was made."));
    return;
  }
  box.append(piece_table(pieces));
  const amounts = amounts_by_material(pieces);
  if (amounts.length === 0) return;
  box.append(
    table_of(
      "Material needed, without what stays in the cup",
      [
        { head: "Material", cell: ([material]) => material },
        { head: "Volume", unit: "cm³", number: true, cell: ([, volume]) => measured(volume / 1000) },
        { head: "Mass", unit: "g", number: true, cell: ([, , mass]) => measured(mass) },
      ],
      amounts,
    ),
  );
}
