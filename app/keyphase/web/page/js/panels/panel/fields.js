/** Native controls in the look of the page: sliders with their number, choices, switches, buttons. */

import { el, icon } from "../../lib/dom.js";
import { plain } from "../../lib/format.js";

/** A slider's way is divided into so many places. */
const PLACES = 1000;
/** So near the automatic value, as a share of the way, a hand that slides is caught by it. */
const CATCHES = 0.012;
/** The slider's thumb, so that the notch lies under its middle. */
const THUMB_PX = 8;

let count = 0;
const nextId = () => `field-${(count += 1)}`;

/**
 * A group of controls that can be folded.
 * @param {string} title
 * @param {{open?: boolean}} given
 * @param {...(Node|string)} children
 */
export function group(title, { open = true }, ...children) {
  return el(
    "details",
    { class: "group", open },
    el("summary", {}, el("span", { text: title }), icon("down", "small")),
    ...children,
  );
}

/**
 * One line: what it is called, and its control.
 * @param {string} title
 * @param {string} hint
 * @param {HTMLElement} control the one that the title names
 * @param {...Node} beside
 */
export function line(title, hint, control, ...beside) {
  control.id ||= nextId();
  return el(
    "div",
    { class: "field", title: hint },
    el("label", { for: control.id, text: title }),
    ...(beside.length ? beside : [control]),
  );
}

/**
 * A slider and its number. `share` and `value` take one to the other; `told` is called with each
 * value, and whether the hand still holds it; null is the automatic value.
 * @param {{title: string, hint: string, share: (value: number) => number,
 *   value: (share: number) => number, unit?: string, low: number, high: number, step: number|"any",
 *   told: (value: number|null, held: boolean, event: Event) => void}} given
 */
export function slider({ title, hint, share, value, unit = "", low, high, step, told }) {
  let automatic = /** @type {number|null} */ (null);
  const range = /** @type {HTMLInputElement} */ (
    el("input", { type: "range", min: 0, max: PLACES, step: 1, id: nextId() })
  );
  const notch = el("i", { class: "notch", hidden: true });
  const number = /** @type {HTMLInputElement} */ (
    el("input", {
      type: "number",
      class: "number",
      min: low,
      max: high,
      step,
      "aria-label": `${title}, value${unit ? ` in ${unit}` : ""}`,
    })
  );
  /** The value the thumb is at; the automatic one catches it. */
  const slid = () => {
    const at = Number(range.value) / PLACES;
    if (automatic !== null && Math.abs(at - share(automatic)) <= CATCHES) return automatic;
    return value(at);
  };
  const show = (shown) => {
    if (shown === null || shown === undefined) return;
    const at = share(shown);
    range.style.setProperty("--share", String(at));
    range.setAttribute(
      "aria-valuetext",
      `${plain(rounded(shown))}${unit && ` ${unit}`}${shown === automatic ? ", automatic" : ""}`,
    );
    if (Math.round(at * PLACES) !== Number(range.value))
      range.value = String(Math.round(at * PLACES));
    if (document.activeElement !== number) number.value = String(rounded(shown));
  };
  const tell = (held) => (event) => {
    const now = slid();
    show(now);
    told(now === automatic ? null : now, held, event);
  };
  range.addEventListener("input", tell(true));
  range.addEventListener("change", tell(false));
  range.addEventListener("dblclick", (event) => automatic !== null && told(null, false, event));
  number.addEventListener("change", (event) => {
    if (number.value !== "" && number.checkValidity()) told(Number(number.value), false, event);
    number.blur();
  });
  const way = el("span", { class: "slider" }, range, notch);
  return {
    node: line(title, hint, range, way, number),
    /** @param {number|null} shown @param {number|null} [found] the automatic value */
    show(shown, found = null) {
      automatic = found;
      notch.hidden = found === null;
      if (found !== null) {
        notch.style.setProperty(
          "left",
          `calc(${THUMB_PX / 2}px + ${share(found)} * (100% - ${THUMB_PX}px))`,
        );
        notch.title = `automatic: ${plain(rounded(found))}`;
      }
      way.classList.toggle("automatic", shown === found);
      show(shown);
    },
    disable(off) {
      range.disabled = number.disabled = off;
    },
  };
}

/** Four figures: what a slider can place and a person can read; of small ones as many as have room. */
const rounded = (value) => Number(value.toPrecision(figures(Math.abs(value))));
const figures = (size) => (size < 0.001 ? 1 : size < 0.01 ? 2 : size < 0.1 ? 3 : 4);

/**
 * One of several.
 * @param {string} title
 * @param {string} hint
 * @param {(value: string) => void} told
 */
export function choice(title, hint, told) {
  const select = /** @type {HTMLSelectElement} */ (
    el("select", { on: { change: () => told(select.value) } })
  );
  let offered = "";
  return {
    node: line(title, hint, select, el("span", { class: "select" }, select, icon("down", "small"))),
    /** @param {{value: string, text: string}[]} options @param {string} value */
    show(options, value) {
      const now = JSON.stringify(options);
      if (now !== offered) {
        offered = now;
        select.replaceChildren(
          ...options.map((one) => el("option", { value: one.value, text: one.text })),
        );
      }
      if (select.value !== value) select.value = value;
    },
    disable(off) {
      select.disabled = off;
    },
  };
}

/**
 * On or off.
 * @param {string} title
 * @param {string} hint
 * @param {(on: boolean) => void} told
 */
export function toggle(title, hint, told) {
  const box = /** @type {HTMLInputElement} */ (
    el("input", { type: "checkbox", on: { change: () => told(box.checked) } })
  );
  return {
    node: el("label", { class: "toggle", title: hint }, box, el("span", { text: title })),
    show: (on) => (box.checked = on),
    disable: (off) => (box.disabled = off),
  };
}

/**
 * @param {string} text
 * @param {{run: () => void, hint?: string, look?: string, symbol?: string}} given
 */
export function button(text, { run, hint = "", look = "", symbol = "" }) {
  return /** @type {HTMLButtonElement} */ (
    el(
      "button",
      { type: "button", class: `panel-button ${look}`, title: hint, on: { click: run } },
      symbol ? icon(symbol) : "",
      el("span", { text }),
    )
  );
}

/** Buttons side by side, as wide as each other. @param {...Node} buttons */
export const row = (...buttons) => el("div", { class: "panel-row" }, ...buttons);
