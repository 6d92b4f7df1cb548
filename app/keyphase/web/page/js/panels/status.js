/** The status line: values under the pointer, progress, the legend of origins. */

import { byId, el } from "../lib/dom.js";
import { height as heightText, moment } from "../lib/format.js";
import { curvesOf, valueAt } from "../model/signals.js";
import { glyphIcon } from "../timeline/glyphs.js";
import { digitsOf, valueText } from "../timeline/tracks.js";

const AXES = ["x", "y", "z"];
const UNITS = { position: "mm", force: "N" };

/** @param {import("../lib/store.js").Store} store */
export function createStatus(store) {
  const where = el("span", { text: "Pointer" });
  const at = el("b");
  const error = el("b");
  const errorGroup = el("span", {}, "error", error);
  const vectors = Object.fromEntries(Object.keys(UNITS).map((name) => [name, vector(name)]));
  const progress = el("i");
  const progressText = el("span");
  const progressGroup = el(
    "span",
    { hidden: true },
    progressText,
    el("div", { class: "progress" }, progress),
  );
  const latency = el("span", { id: "latency", class: "wide", hidden: true });
  const gripper = sign("gripper", false);
  byId("status").append(
    el("span", { id: "replay-status" }),
    where,
    at,
    errorGroup,
    ...Object.values(vectors).map(({ node }) => node),
    progressGroup,
    el("span", { class: "space" }),
    latency,
    gripper,
    ...legend(),
  );
  store.later(["document"], ({ document: doc }) => {
    gripper.hidden = !doc?.boundaries.some(({ origin }) => origin === "gripper");
  });

  store.later(["pointer", "clock", "whole", "fine", "document"], (state) => {
    const { document: doc, pointer, clock } = state;
    const shown = Boolean(doc);
    const groups = Object.values(vectors).map(({ node }) => node);
    for (const node of [where, at, errorGroup, ...groups]) node.hidden = !shown;
    if (!shown) return;
    const time = pointer ?? clock;
    where.textContent = pointer === null ? "Playhead" : "Pointer";
    at.textContent = moment(time);
    const curve = curvesOf(state, "error")?.series[0];
    const value = curve ? valueAt(curve, time) : NaN;
    errorGroup.hidden = Number.isNaN(value);
    error.textContent = heightText(value);
    for (const [name, { node, values }] of Object.entries(vectors)) {
      const series = curvesOf(state, name)?.series;
      node.hidden = !series?.length;
      AXES.forEach(
        (_, k) => (values[k].textContent = valueText(series?.[k], time, digitsOf(name))),
      );
    }
  });

  store.later(["progress"], ({ progress: state }) => {
    progressGroup.hidden = !state || state.done;
    if (!state || state.done) return;
    progressText.textContent = state.name;
    progress.style.setProperty("width", `${100 * (state.fraction ?? 0.15)}%`);
  });
}

function vector(name) {
  const values = AXES.map((axis) => el("b", { style: { color: `var(--axis-${axis}-text)` } }));
  return { values, node: el("span", {}, name, ...values, UNITS[name]) };
}

function sign(origin, filled) {
  return el("span", {}, glyphIcon(origin, filled), String(origin));
}

function legend() {
  const origins = [
    ["position", false],
    ["force", true],
    ["both", true],
    ["user", true],
  ];
  return [
    ...origins.map(([origin, filled]) => sign(origin, filled)),
    el("span", { class: "wide", text: "filled: contact change" }),
    el("span", { class: "wide", text: "shaded: interval" }),
  ];
}
