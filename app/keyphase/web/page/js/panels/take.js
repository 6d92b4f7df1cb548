/** While a take is recorded the timeline shows it, from its beginning until now. */

import { byId, el, svg } from "../lib/dom.js";
import { curvesIn } from "../model/recordings/take.js";

const AXES = ["x", "y", "z"];
const ROWS = [
  { key: "position", title: "Position", unit: "mm", least: 20 },
  { key: "force", title: "Force", unit: "N", least: 4 },
];
const WIDTH = 1000;
const HEIGHT = 100;

/**
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 */
export function createTake(store, actions) {
  const told = el("b", { role: "timer" });
  const stop = el("button", {
    type: "button",
    class: "button",
    text: "Stop",
    on: { click: () => actions.record("stop") },
  });
  const rows = ROWS.map(createRow);
  const node = el(
    "div",
    { class: "take", hidden: true, "aria-label": "Take", role: "group" },
    el("header", {}, el("i", { class: "dot" }), told, stop),
    ...rows.map((row) => row.node),
  );
  byId("timeline").append(node);
  store.on(["take"], ({ take, record }) => {
    node.hidden = !take;
    if (!take) return;
    told.textContent = `Recording ${record?.workcell ?? ""}, ${take.times.at(-1).toFixed(1)} s`;
    for (const row of rows) row.draw(take);
  });
}

/** @param {typeof ROWS[number]} row */
function createRow({ key, title, unit, least }) {
  const lines = AXES.map((axis) =>
    svg("polyline", {
      style: { stroke: `var(--axis-${axis})` },
      "vector-effect": "non-scaling-stroke",
    }),
  );
  const values = AXES.map((axis) => el("span", { style: { color: `var(--axis-${axis}-text)` } }));
  const picture = svg(
    "svg",
    { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: "none", "aria-hidden": "true" },
    ...lines,
  );
  return {
    node: el(
      "div",
      { class: "take-row" },
      el("div", { class: "take-names" }, el("b", { text: `${title} ${unit}` }), ...values),
      picture,
    ),
    /** @param {import("../model/recordings/take.js").Take} take */
    draw(take) {
      const points = curvesIn(take.times, take[key], { width: WIDTH, height: HEIGHT, least });
      lines.forEach((line, k) => line.setAttribute("points", points[k]));
      values.forEach((value, k) => {
        value.textContent = `${AXES[k]} ${take[key].at(-1)[k].toFixed(1)}`;
      });
    },
  };
}
