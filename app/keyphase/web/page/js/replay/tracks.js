/**
 * The tracks of a replay: what is measured, thin, over what was demonstrated, thick and pale, laid
 * under each skill; and the force at which a skill is over.
 */

import { cssColor } from "../lib/colors.js";
import { el, svg } from "../lib/dom.js";
import { textWidth } from "../lib/text_width.js";
import { signed } from "../lib/format.js";
import { createCurves } from "../timeline/curves/curves.js";
import { normOf } from "../timeline/curves/series.js";
import { createReadout } from "../timeline/gutter.js";
import { axisStep, multiples } from "../lib/scale.js";
import { tickLabels } from "../timeline/tracks.js";
import { indexAt, liveSeries } from "./samples.js";

const AXES = [
  { key: "x", color: "--axis-x" },
  { key: "y", color: "--axis-y" },
  { key: "z", color: "--axis-z" },
];
const OFF = [{ key: "off", color: "--accent" }];
const PENS = {
  force: { curves: AXES, width: 1.1, pale: 3.5, digits: 2, least: 2 },
  position: { curves: AXES, width: 1.5, pale: 4, digits: 1, least: 10 },
  off: { curves: OFF, width: 1.4, pale: 0, digits: 1, least: 4 },
  torque: { curves: AXES, width: 1.1, pale: 3.5, digits: 3, least: 0.05 },
};
const TICK_EVERY_PX = 26;
const identity = (value) => value;

/**
 * @param {string} key
 * @param {import("../timeline/gutter.js").TrackParts} parts
 */
export function createReplayTrack(key, { plot, marks, gutter, texts }) {
  const { curves, width, pale, digits, least } = PENS[key];
  let laid = [];
  const open = createCurves(
    plot,
    curves.map(({ color }) => ({ color, width })),
    { pale: demonstratedLines },
  );
  const folded = createCurves(plot, [{ color: "--text-3", width: 1 }]);
  const note = el("div", { class: "replay-notes" });
  gutter.append(note);
  if (key === "force") note.append(...FORCE_NOTES());
  const now = el("b");
  if (key === "off") note.append(el("div", { class: "gutter-note" }, "now ", now));
  const readout = key === "off" ? null : createReadout(gutter, curves);

  function demonstratedLines() {
    return laid.flatMap(({ shift, data }) =>
      curves.flatMap(({ key: axis, color }) => {
        const values = data[`${key}_${axis}`];
        if (!values) return [];
        const times = data.time_s.map((time) => time + shift);
        return [{ series: { key: axis, times, values }, color: cssColor(color), width: pale }];
      }),
    );
  }

  return {
    /**
     * @param {import("./samples.js").Samples} samples
     * @param {import("./schedule.js").Slot[]} slots
     * @param {import("../model/rows.js").Row} row
     */
    draw(samples, slots, scale, row) {
      laid = key === "off" ? [] : layDemonstrated(slots, samples);
      plot.classList.toggle("folded", row.folded);
      (row.folded ? open : folded).hide();
      const live = liveSeries(samples, key);
      const view = { from: scale.from, to: scale.to };
      if (row.folded) {
        const norm = [normOf(live)];
        folded.resize(scale.width, row.height, true);
        folded.draw(norm, rangeOf(norm, [], row.height, least, key), view);
        marks.replaceChildren();
        return;
      }
      const range = rangeOf(live, key === "off" ? [] : valuesOf(laid, key), row.height, least, key);
      open.resize(scale.width, row.height, false);
      open.draw(live, range, view);
      const ends = key === "force" ? drawEndConditions(slots, samples, scale, open.y) : [];
      const inside = svg(
        "g",
        { "clip-path": "url(#replay-clip)" },
        ...ends,
        ...dots(live, scale, open.y, curves),
      );
      marks.replaceChildren(...tickLabels(range, open.y, texts()), inside);
    },
    /** The newest values, in the gutter. */
    read(samples) {
      const values = liveSeries(samples, key).map((series) => series.values.at(-1));
      if (key === "off") now.textContent = Number.isFinite(values[0]) ? values[0].toFixed(1) : "–";
      else
        readout.show(values.map((value) => (Number.isFinite(value) ? signed(value, digits) : "–")));
    },
    recolor() {
      open.recolor();
      folded.recolor();
    },
  };
}

const FORCE_NOTES = () =>
  ["live", "demonstrated", "end condition"].map((text) =>
    el("div", { class: `gutter-note pen ${text.replace(" ", "-")}`, text }),
  );

/**
 * Where the demonstration of each skill lies on the replay's axis: from where the skill starts; of
 * one that met its contact, so that both contacts coincide.
 * @param {import("./schedule.js").Slot[]} slots
 * @param {import("./samples.js").Samples} samples
 */
export function layDemonstrated(slots, samples) {
  return slots.flatMap((slot) => {
    const data = samples.demonstrated[slot.index];
    if (!data) return [];
    const met = slot.progress === "done" && slot.skill.outcome === "contact";
    const [from, to] = slot.skill.demonstrated_s;
    return [{ shift: met ? slot.met - (to - from) : slot.start, data }];
  });
}

const valuesOf = (laid, key) =>
  laid.flatMap(({ data }) => ["x", "y", "z"].flatMap((axis) => data[`${key}_${axis}`] ?? []));

/** All that is drawn fits, with air; the unit's own least span keeps noise small. */
function rangeOf(series, more, height, least, key) {
  let low = key === "off" || series.length === 1 ? 0 : Infinity;
  let high = -Infinity;
  for (const values of [...series.map((one) => one.values), more]) {
    for (const value of values) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  if (!Number.isFinite(high)) [low, high] = [0, least];
  if (!Number.isFinite(low)) low = 0;
  const missing = Math.max(0, least - (high - low));
  high += key === "off" || series.length === 1 ? missing : missing / 2;
  low -= key === "off" || series.length === 1 ? 0 : missing / 2;
  const air = 0.07 * (high - low);
  const bottom = low === 0 ? -0.4 * air : low - air;
  const top = high + air;
  return {
    low: bottom,
    high: top,
    ticks: multiples(bottom, top, axisStep(bottom, top, height / TICK_EVERY_PX)),
    map: identity,
  };
}

/**
 * A dot at the newest value of each curve.
 * @param {import("../lib/scale.js").Scale} scale
 */
function dots(live, scale, y, curves) {
  const last = live[0].times.length - 1;
  if (last < 0) return [];
  return curves.map(({ color }, k) =>
    svg("circle", {
      cx: scale.x(live[k].times[last]),
      cy: y(live[k].values[last]),
      r: 2.4,
      style: { fill: `var(${color})` },
    }),
  );
}

const AXIS_NAMES = ["x", "y", "z"];

/**
 * The force along the main axis of its direction at which each skill is over.
 * @param {import("./schedule.js").Slot[]} slots
 * @param {import("./samples.js").Samples} samples
 * @param {import("../lib/scale.js").Scale} scale
 */
function drawEndConditions(slots, samples, scale, y) {
  /** @type {{from: number, to: number, y: number}[]} */
  const written = [];
  return slots
    .filter(({ skill }) => skill.contact)
    .flatMap((slot) => {
      const { direction, threshold_N: threshold } = slot.skill.contact;
      const axis = direction.reduce(
        (best, value, k) => (Math.abs(value) > Math.abs(direction[best]) ? k : best),
        0,
      );
      const level = levelBefore(slot, samples, axis) + direction[axis] * threshold;
      const [from, to] = [Math.max(scale.x(slot.start), 0), scale.x(slot.met ?? slot.end)];
      if (to <= 0) return [];
      const at = y(level);
      const text = `ends at F${AXIS_NAMES[axis]} ${signed(level, 1).replace("+", "")} N`;
      const below = direction[axis] < 0;
      const line = svg("path", { d: `M${from + 2} ${at}H${to}`, class: "end-condition" });
      const long = textWidth(text, "600 11px");
      const place = { ...besides(from, scale.width, long), y: at + (below ? 12 : -4) };
      const left = place["text-anchor"] ? place.x - long : place.x;
      const box = { from: left, to: left + long, y: place.y };
      // The line is there all the same, and the skill's own card says it in words.
      if (left < 0 || written.some((other) => overlap(other, box))) return [line];
      written.push(box);
      return [line, svg("text", { ...place, class: "end-condition-text", text })];
    });
}

const LINE_PX = 12;
const overlap = (one, other) =>
  one.from < other.to + 4 && other.from < one.to + 4 && Math.abs(one.y - other.y) < LINE_PX;

/** Right of where a skill begins; left of it where that leaves the track. */
const besides = (from, width, long) =>
  from + 6 + long <= width ? { x: from + 6 } : { x: from - 4, "text-anchor": "end" };

/**
 * The usual force in a skill before its contact: measured once there is enough, else demonstrated.
 * @param {import("./schedule.js").Slot} slot
 * @param {import("./samples.js").Samples} samples
 */
function levelBefore(slot, samples, axis) {
  const from = indexAt(samples, slot.start);
  const to = slot.progress === "waiting" ? from : indexAt(samples, (slot.met ?? Infinity) - 0.05);
  const measured = samples.columns.get(`force_${AXIS_NAMES[axis]}`).subarray(from, to);
  if (measured.length >= 12) return median(measured);
  const data = samples.demonstrated[slot.index];
  const length = slot.skill.demonstrated_s[1] - slot.skill.demonstrated_s[0] - 0.1;
  const before =
    data?.[`force_${AXIS_NAMES[axis]}`]?.filter((_, k) => data.time_s[k] < length) ?? [];
  return before.length ? median(before) : 0;
}

const median = (values) => Float64Array.from(values).sort()[values.length >> 1];
