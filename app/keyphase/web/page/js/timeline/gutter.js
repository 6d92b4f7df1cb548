/** The column at the left of the tracks: name, unit, fold button, value under the pointer. */

import { el, icon } from "../lib/dom.js";

/**
 * @typedef {{top: number, bottom: number, right: number}} TextBox  px, from the gutter's upper
 *   right corner
 * @typedef {{plot: HTMLElement, marks: SVGElement, gutter: HTMLElement, texts: () => TextBox[]}}
 *   TrackParts  what a track draws on, and what is written beside it
 *
 * @param {{key: string, title: string, unit?: string, foldable?: boolean}} row
 * @param {(key: string) => void} [fold]
 */
export function createGutter({ key, title, unit = "", foldable = true }, fold) {
  const small = el("small", { text: unit });
  const chevron = el("span", { class: "chevron" }, icon("down", "small"));
  const name = foldable
    ? el(
        "button",
        {
          class: "gutter-name",
          type: "button",
          "aria-expanded": "true",
          on: { click: () => fold?.(key) },
        },
        chevron,
        el("span", { text: title }),
        small,
      )
    : el("div", { class: "gutter-name plain" }, el("span", { text: title }), small);
  const body = el("div", { class: "gutter-body" });
  const node = el("div", { class: "gutter", data: { gutter: key } }, name, body);
  let wasFolded = null;
  /** @type {TextBox[]|null} */
  let texts = null;
  return {
    node,
    body,
    small,
    /** What is written in it, measured once each time it is placed: ticks keep clear of it. */
    texts: () => (texts ??= textBoxes(node)),
    /** @param {import("../model/rows.js").Row} row */
    place({ y, height, folded }) {
      texts = null;
      node.style.setProperty("top", `${y}px`);
      node.style.setProperty("height", `${height}px`);
      node.classList.toggle("short", height <= 28);
      if (!foldable || wasFolded === folded) return;
      wasFolded = folded;
      name.setAttribute("aria-expanded", String(!folded));
      name.title = `${folded ? "Open" : "Fold"} ${title.toLowerCase()}`;
      chevron.replaceChildren(icon(folded ? "right" : "down", "small"));
    },
  };
}

/** @param {HTMLElement} node @returns {TextBox[]} */
function textBoxes(node) {
  const around = node.getBoundingClientRect();
  const range = document.createRange();
  return [...node.querySelectorAll(".gutter-name, .gutter-note, .switch, .readout-row b")]
    .filter((one) => one.checkVisibility())
    .map((one) => {
      range.selectNodeContents(one);
      const { top, bottom, right } = range.getBoundingClientRect();
      return { top: top - around.top, bottom: bottom - around.top, right: right - around.right };
    });
}

/**
 * The values of a track's curves under the pointer; in a low track only the letters.
 * @param {HTMLElement} body
 * @param {{key: string, color: string}[]} curves
 */
export function createReadout(body, curves) {
  const values = curves.map(() => el("span", { class: "value" }));
  const named = curves.length > 1;
  const rows = curves.map(({ key, color }, k) =>
    el(
      "div",
      { class: "readout-row" },
      el("i", { style: { "border-color": `var(${color})` } }),
      named ? el("b", { text: key }) : "",
      values[k],
    ),
  );
  const letters = el(
    "div",
    { class: "readout-letters" },
    ...(named
      ? curves.map(({ key, color }) => el("b", { text: key, style: { color: `var(${color})` } }))
      : []),
  );
  body.append(el("div", { class: "readout" }, ...rows), letters);
  return {
    /** @param {(string|null)[]} texts one per curve; null: there is no such curve */
    show(texts) {
      texts.forEach((text, k) => {
        rows[k].hidden = text === null;
        if (values[k].textContent !== text) values[k].textContent = text;
      });
    },
  };
}
