/** The plan on the time axis: the whole of it, the skills, and how each ended. */

import { segmentFill } from "../lib/colors.js";
import { svg } from "../lib/dom.js";
import { duration } from "../lib/format.js";
import { drawRing, fittingLabel } from "../timeline/band.js";
import { glyph } from "../timeline/glyphs.js";
import { textWidth } from "../lib/text_width.js";
import { outcomeText } from "./schedule.js";

/** What the running skill has before it; its words stand on that in both themes. */
const AHEAD_OPACITY = 0.62;
const WAITING_OPACITY = 0.35;

/** @param {import("./schedule.js").Slot} slot */
export const slotFill = ({ skill }) =>
  skill.segment === null ? "var(--hatch-line)" : segmentFill({ color: skill.color });

/** The colour in which an end is drawn. @param {import("./schedule.js").Slot} slot */
export const endColor = ({ good, skill }) =>
  !good
    ? "var(--bad)"
    : skill.outcome === "contact"
      ? "var(--origin-force)"
      : "var(--origin-position)";

/**
 * The skills in small.
 * @param {import("./schedule.js").Slot[]} slots
 * @param {import("../lib/scale.js").Scale} scale
 */
export function drawWholePlan(slots, scale, { y, height }) {
  const strip = slots.map((slot) =>
    svg("rect", {
      x: scale.x(slot.start) + 0.5,
      y: y + height - 7,
      width: Math.max(1, scale.x(slot.end) - scale.x(slot.start) - 1),
      height: 4,
      rx: 1,
      style: { fill: slotFill(slot), opacity: slot.progress === "waiting" ? 0.4 : 1 },
    }),
  );
  return [svg("rect", { y, width: scale.width, height, class: "overview-ground" }), ...strip];
}

/**
 * A mark where each skill's end condition was met, and a line down over the tracks.
 * @param {import("./schedule.js").Slot[]} slots
 * @param {import("../lib/scale.js").Scale} scale
 */
export function drawEnds(slots, scale, { y, height }, bottom) {
  const middle = y + height / 2;
  let free = 0;
  return slots
    .filter(
      ({ progress, skill }) =>
        progress === "done" && (skill.segment !== null || skill.outcome !== "reached"),
    )
    .map((slot) => {
      const x = scale.x(slot.met);
      const color = endColor(slot);
      const text = outcomeText(slot.skill);
      const width = textWidth(text, "600 11px");
      const mark = slot.good
        ? glyph(slot.skill.outcome === "contact" ? "force" : "position", {
            x,
            y: middle,
            filled: slot.skill.outcome === "contact",
          })
        : svg("path", {
            d: `M${x - 4} ${middle - 4}l8 8m0 -8l-8 8`,
            class: "glyph",
            style: { stroke: color, fill: "none" },
          });
      const before = x - 10 - width > free;
      free = x + (before ? 8 : 16 + width);
      return svg(
        "g",
        { class: "end", data: { end: slot.index, outcome: slot.skill.outcome } },
        svg("path", {
          d: `M${x} ${middle}V${bottom}`,
          class: "boundary-line",
          style: { stroke: color },
        }),
        mark,
        svg("text", {
          x: before ? x - 10 : x + 10,
          y: middle + 3.6,
          class: "end-text",
          "text-anchor": before ? "end" : "start",
          style: { fill: color },
          text,
        }),
      );
    });
}

/**
 * Done skills are solid, the running one is striped up to now, waiting ones are pale.
 * @param {import("./schedule.js").Slot[]} slots
 * @param {import("../lib/scale.js").Scale} scale
 */
export function drawSkills(slots, scale, row, now) {
  const box = { top: row.y + 3, height: row.height - 6 };
  const nodes = [
    svg("rect", { y: row.y, width: scale.width, height: row.height, class: "band-ground" }),
  ];
  let ring = null;
  for (const slot of slots) {
    // What of it is in view, so that its text is, too.
    const left = Math.max(scale.x(slot.start) + 1, 0);
    const right = Math.min(scale.x(slot.end) - 1, scale.width);
    if (left >= scale.width || right <= 0) continue;
    const place = { ...box, left, width: Math.max(1, right - left) };
    nodes.push(drawSkill(slot, place, scale, now));
    if (slot.progress === "running") ring = drawRing(place);
  }
  return ring ? [...nodes, ring] : nodes;
}

/**
 * @param {import("./schedule.js").Slot} slot
 * @param {import("../lib/scale.js").Scale} scale
 */
function drawSkill(slot, place, scale, now) {
  const { left, top, width, height } = place;
  const rect = (across, fill, opacity = 1) =>
    svg("rect", {
      x: left,
      y: top,
      width: Math.max(0, across),
      height,
      rx: 3,
      style: { fill, opacity },
    });
  const group = svg("g", {
    class: `skill ${slot.progress}`,
    data: { skill: slot.index, progress: slot.progress },
  });
  const connecting = slot.skill.segment === null;
  const fill = connecting ? "url(#replay-hatch)" : segmentFill(slot.skill);
  if (slot.progress === "running" && !connecting) {
    const done = Math.min(width, scale.x(now) - left);
    group.append(
      rect(width, fill, AHEAD_OPACITY),
      rect(done, fill),
      rect(done, "url(#running-stripes)"),
    );
  } else group.append(rect(width, fill, slot.progress === "waiting" ? WAITING_OPACITY : 1));
  group.append(...(connecting ? connectingText(slot, place) : skillText(slot, place, now)));
  return group;
}

/** @param {import("./schedule.js").Slot} slot */
function skillText(slot, { left, top, width, height }, now) {
  const { skill } = slot;
  const number = String(skill.segment + 1);
  const numberWidth = textWidth(number, "700 12px");
  if (width < numberWidth + 8) return [];
  const textLeft = left + 9 + numberWidth + 7;
  const room = left + width - textLeft - 6;
  const label = fittingLabel(skill, room, "600 12px");
  const two = height >= 30 && label !== "";
  const base = two ? top + 15 : top + height / 2 + 4;
  const on = slot.progress === "waiting" ? "on-pane" : "";
  const nodes = [
    svg("text", {
      x: label ? left + 9 : left + Math.min(9, (width - numberWidth) / 2),
      y: base,
      class: `segment-number ${on}`,
      text: number,
    }),
  ];
  if (label)
    nodes.push(svg("text", { x: textLeft, y: base, class: `segment-label ${on}`, text: label }));
  if (two) nodes.push(...secondLine(stateText(slot, now), textLeft, top + 29, room, on));
  return nodes;
}

/**
 * "running 1.14 s", "contact 8.4 N", "waiting".
 * @param {import("./schedule.js").Slot} slot
 */
export function stateText(slot, now) {
  if (slot.progress === "done") return outcomeText(slot.skill);
  return slot.progress === "running"
    ? `running ${duration(Math.max(0, now - slot.start))}`
    : "waiting";
}

function secondLine(text, x, y, room, on) {
  return textWidth(text, "11px") <= room
    ? [svg("text", { x, y, class: `segment-second ${on}`, text })]
    : [];
}

/** @param {import("./schedule.js").Slot} slot */
function connectingText(slot, { left, top, width, height }) {
  const plate = textWidth("connect", "11.5px") + 14;
  const middle = top + height / 2;
  if (width < plate + 4) return [];
  const at = left + Math.min(6, (width - plate) / 2);
  const nodes = [
    svg("rect", { x: at, y: middle - 9, width: plate, height: 18, rx: 3, class: "segment-plate" }),
    svg("text", { x: at + 7, y: middle + 4, class: "segment-plate-label", text: "connect" }),
  ];
  if (width > plate + 60)
    nodes.push(
      svg("text", {
        x: left + width - 8,
        y: middle + 4,
        class: "segment-plate-second",
        "text-anchor": "end",
        text: duration(slot.end - slot.start),
      }),
    );
  return nodes;
}

/**
 * The stretch of the running skill, tinted in its colour over all tracks.
 * @param {import("./schedule.js").Slot[]} slots
 * @param {import("../lib/scale.js").Scale} scale
 */
export function drawCurrent(slots, scale, top, bottom) {
  return slots
    .filter(({ progress, skill }) => progress === "running" && skill.segment !== null)
    .map((slot) =>
      svg("rect", {
        x: scale.x(slot.start),
        y: top,
        width: Math.max(0, scale.x(slot.end) - scale.x(slot.start)),
        height: Math.max(0, bottom - top),
        style: { fill: segmentFill(slot.skill), opacity: 0.1 },
      }),
    );
}
