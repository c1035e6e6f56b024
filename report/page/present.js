// SPDX-License-Identifier: GPL-3.0-or-later
// The present pressure of every segment; whoever shows it is told when it changes.
"use strict";

/**
 * @typedef {Object} Present
 * @property {number[]} pressures_kPa
 * @property {Array<[number, number]>} ranges  of each segment
 */

/** @param {Object[]} segments of the view */
class PresentPressures {
  constructor(segments) {
    this.ranges = segments.map((segment) => {
      const pressures = list(segment.states).map((state) => state.pressure_kPa);
      return [Math.min(...pressures), Math.max(...pressures)];
    });
    this.pressures_kPa = segments.map(() => 0);
    this.listeners = [];
  }

  /** @param {function(number[])} listener called now and after every change */
  follow(listener) {
    this.listeners.push(listener);
    listener(this.pressures_kPa);
  }

  /** @param {number} segment from 0 @returns {number} the pressure within the segment's range */
  held(segment, pressure_kPa) {
    const [low, high] = this.ranges[segment];
    return Math.min(high, Math.max(low, pressure_kPa));
  }

  /** @param {number[]} pressures_kPa held within each segment's range */
  set_all(pressures_kPa) {
    this.pressures_kPa = this.ranges.map((_, i) => this.held(i, pressures_kPa[i] ?? 0));
    for (const listener of this.listeners) listener(this.pressures_kPa);
  }

  /** @param {number} segment from 0 */
  set_one(segment, pressure_kPa) {
    this.set_all(this.pressures_kPa.map((value, i) => (i === segment ? pressure_kPa : value)));
  }

  /** @param {number} pressure_kPa of all segments */
  set_same(pressure_kPa) {
    this.set_all(this.ranges.map(() => pressure_kPa));
  }
}
