// SPDX-License-Identifier: GPL-3.0-or-later
// Tables: a caption, heads with their scope, numbers to the right, a box of its own to scroll in.
"use strict";

/**
 * @typedef {Object} Column
 * @property {string} head
 * @property {string} [unit]     under the head
 * @property {boolean} [number]  set to the right, in digits of one width
 * @property {function(Object): (Node|string|null)} cell
 */

/** @param {string} unit @returns {HTMLElement|null} ", mm" */
function unit_after(unit) {
  return unit ? h("span", { class: "unit" }, `, ${unit}`) : null;
}

/** @param {Column} column @returns {HTMLElement} */
function column_head(column) {
  return h("th", { scope: "col", class: column.number ? "number" : null }, column.head, unit_after(column.unit));
}

/**
 * One line for each of the items; the first column names the line.
 * @param {string} caption
 * @param {Column[]} columns
 * @param {Object[]} items
 * @param {function(Object, number): Object} attributes of an item's line
 */
function table_of(caption, columns, items, attributes = () => ({})) {
  const lines = items.map((item, index) =>
    h(
      "tr",
      attributes(item, index),
      columns.map((column, i) =>
        h(
          i === 0 ? "th" : "td",
          { scope: i === 0 ? "row" : null, class: column.number ? "number" : null },
          column.cell(item, index) ?? MISSING,
        ),
      ),
    ),
  );
  return scrolling(
    caption,
    h(
      "table",
      {},
      h("caption", {}, caption),
      h("thead", {}, h("tr", {}, columns.map(column_head))),
      h("tbody", {}, lines),
    ),
  );
}

/** @param {string} label @param {HTMLElement} table @returns {HTMLElement} a box that scrolls sideways */
function scrolling(label, table) {
  return h("div", { class: "wide", role: "region", "aria-label": label, tabindex: "0" }, table);
}

/**
 * One line for each property, one column for each item; lines in which no item has a value are left out.
 * @param {string} caption
 * @param {string[]} heads  of the items
 * @param {Array<[string, string, function(Object): (string|null)]>} lines  name, unit and value
 * @param {Object[]} items
 */
function property_table(caption, heads, lines, items) {
  const kept = lines
    .map(([name, unit, value]) => [name, unit, items.map(value)])
    .filter(([, , values]) => values.some((value) => value !== null && value !== MISSING));
  return scrolling(
    caption,
    h(
      "table",
      { class: "properties" },
      h("caption", {}, caption),
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          h("th", { scope: "col" }, "Property"),
          heads.map((head) => h("th", { scope: "col", class: "number" }, head)),
        ),
      ),
      h(
        "tbody",
        {},
        kept.map(([name, unit, values]) =>
          h(
            "tr",
            {},
            h("th", { scope: "row" }, name, unit_after(unit)),
            values.map((value) => h("td", { class: "number" }, value ?? MISSING)),
          ),
        ),
      ),
    ),
  );
}

/**
 * A part that is shut at first, and made when it is opened: thousands of lines would delay the page.
 * @param {string} summary
 * @param {function(): Node} make
 * @param {boolean} open from the beginning
 */
function made_when_opened(summary, make, open = false) {
  const details = h("details", { open }, h("summary", {}, summary), open ? make() : null);
  details.addEventListener("toggle", () => {
    if (details.open && details.children.length === 1) details.append(make());
  });
  return details;
}
