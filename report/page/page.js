// SPDX-License-Identifier: GPL-3.0-or-later
// Fills the page from its data. The last of the plain scripts.
"use strict";

/** Leaves out a section whose content nothing was put into. @param {string} id */
function leave_out_empty(id) {
  if (by_id(`${id}-content`).children.length > 0) return;
  by_id(id).remove();
  document.querySelector(`nav a[href="#${id}"]`)?.closest("li").remove();
}

/** @param {PageData} data */
function show_tables(data) {
  show_facts(data.report);
  show_dimensions(data.report);
  show_checks(data.report, new Set(), () => {});
  show_pieces(data.report);
  show_plan(data.report);
  show_errors_and_times(data.report);
}

function start_page() {
  let data;
  try {
    data = read_data();
  } catch (error) {
    by_id("main").prepend(h("p", { class: "alarm", role: "alert" }, `The data of this page cannot be read: ${error.message}`));
    return;
  }
  show_tables(data);
}

start_page();
