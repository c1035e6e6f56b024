// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and words as the page shows them, and elements that carry them.
"use strict";

const MISSING = "–";

/** @param {number|null|undefined} value @returns {boolean} whether it is a number that can be shown */
function is_number(value) {
  return typeof value === "number" && Number.isFinite(value);
}

/** @param {string} text a number as JavaScript writes it @returns {string} with a minus sign */
function with_minus(text) {
  return text.replace(/-/g, "\u2212");
}

/** @param {number} value @returns {string} as mantissa and power of ten, two digits */
function scientific(value) {
  if (!is_number(value)) return MISSING;
  if (value === 0) return "0";
  const [mantissa, exponent] = value.toExponential(1).split("e");
  const raised = String(Number(exponent)).replace(/./g, (c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(c)]));
  return `${with_minus(mantissa)}·10${raised}`;
}

/**
 * A predicted or measured number.
 * @param {number|null} value
 * @param {number} digits significant ones; those before the point are always shown
 */
function measured(value, digits = 4) {
  if (!is_number(value)) return MISSING;
  const size = Math.abs(value);
  if (size < 1e-9) return "0";
  if (size < 1e-3 || size >= 1e7) return scientific(value);
  const before = Math.floor(Math.log10(size)) + 1;
  return with_minus(value.toFixed(Math.max(0, Math.min(digits - before, 6))));
}

/** @param {number|null} value one that somebody chose, such as 85 or 2.656; no trailing zeros */
function given(value) {
  return is_number(value) ? with_minus(String(Number(value.toPrecision(6)))) : MISSING;
}

/** @param {number|null} value a count @returns {string} in groups of three digits */
function count(value) {
  return is_number(value) ? String(value).replace(/\B(?=(\d{3})+$)/g, "\u202f") : MISSING;
}

/** @param {number|null} value @param {string} unit @param {function} format of the number */
function with_unit(value, unit, format = measured) {
  if (!is_number(value)) return MISSING;
  return unit === "°" || unit === "degrees" ? `${format(value)}°` : `${format(value)}${unit ? `\u00a0${unit}` : ""}`;
}

/** @param {number} n @param {string} one @param {string} many @returns {string} "1 error", "2 errors" */
function counted(n, one, many = `${one}s`) {
  return `${count(n)}\u00a0${n === 1 ? one : many}`;
}

/** @param {string[]} words @returns {string} "a, b and c" */
function listed(words) {
  return words.length < 2 ? words.join("") : `${words.slice(0, -1).join(", ")} and ${words.at(-1)}`;
}

/** @param {string} word @returns {string} beginning with a capital letter */
function capital(word) {
  return word.charAt(0).toUpperCase() + word.slice(1);
}

/** Sets attributes: functions are listeners ("onclick"), false and null leave one out. */
function set_attributes(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, value);
  }
}

/**
 * An HTML element. Texts become text nodes, so that no name of a design is ever read as HTML.
 * @param {string} tag
 * @param {Object} attributes
 * @param {...(Node|string|null|Array)} children
 */
function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  set_attributes(element, attributes);
  element.append(...children.flat(3).filter((child) => child !== null && child !== undefined));
  return element;
}

/** An SVG element; parameters as of h(). */
function svg(tag, attributes = {}, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  set_attributes(element, attributes);
  element.append(...children.flat(3).filter((child) => child !== null && child !== undefined));
  return element;
}

/** @param {string} id @returns {HTMLElement} */
function by_id(id) {
  return document.getElementById(id);
}
