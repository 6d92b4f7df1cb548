/** The name of a recording where room is short: what tells it from others is seen. */

import { el } from "../lib/dom.js";
import { cutName, nameApart } from "../model/recordings/recording_list.js";

/** A longer name may be cut, but for so many letters at its end. */
const WHOLE = 12;
const END = 7;

/**
 * Its end stays whole where the rest is cut. What holds it decides by the name's own letters
 * (dir="auto") at which side it begins.
 * @param {string} whole
 * @param {number} [common] how much of its beginning all share, of which the middle is left out
 */
export function nameInTwo(whole, common = 0) {
  const parts = nameApart(cutName(whole, common), END);
  const name = parts.join("");
  if (name.length <= WHOLE) return [el("span", { class: "name-start", text: name })];
  const part = (look, text) => el("span", { class: look, text, "aria-hidden": "true" });
  return [
    el("span", { class: "unseen", text: name }),
    part("name-start", parts[0]),
    part("name-end", parts[1]),
  ];
}
