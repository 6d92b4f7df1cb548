/** The plan: what will run, in which order, how each skill ends. Chips are dragged into order. */

import { segmentFill } from "../lib/colors.js";
import { byId, el, icon, redraw } from "../lib/dom.js";
import { plural } from "../lib/format.js";
import { DOUBT, howItEnds } from "../model/end_condition.js";
import { planStands } from "../model/held.js";
import { shorter } from "../model/label_forms.js";
import { chosenStretch } from "../model/segments.js";
import { attachChipKeys } from "./plan_keys.js";

const CLICK_PX = 4;
const MOST_CHIPS = 150;
const TAKE = "A take is being recorded: its plan comes when it is over.";
/** The end of the strip fades over so much, where it goes on. */
const FADES_PX = 20;

/**
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 */
export function createPlan(store, actions) {
  const summary = el("div");
  const chips = el("div", { class: "chips", role: "list" });
  const drops = el("div", { class: "plan-drops" });
  byId("plan").append(
    el("div", { class: "plan-title" }, el("b", { text: "Plan" }), summary),
    chips,
    drops,
  );

  const keys = attachChipKeys(chips, store, actions);
  store.on(
    ["document", "selected", "selectedTo", "small", "planDrag", "readOnly", "take"],
    (state) => {
      const { document: doc, planDrag, take } = state;
      if (!doc || take) {
        [summary, chips, drops].forEach((node) => node.replaceChildren());
        if (take) chips.append(el("span", { class: "plan-note", text: TAKE }));
        return;
      }
      summary.textContent = describe(doc, state.small);
      const order = planDrag ? planDrag.order : doc.plan.map((_, k) => k);
      const nodes = order.slice(0, MOST_CHIPS).flatMap((k, place) => {
        const entry = doc.plan[k];
        const chip = drawChip(entry, k, doc, state);
        const dragged = planDrag && place === planDrag.place;
        if (dragged) chip.classList.add("dragged");
        return [place ? between(entry, planDrag) : null, chip];
      });
      if (order.length > MOST_CHIPS)
        nodes.push(
          el("span", { class: "plan-note", text: `and ${order.length - MOST_CHIPS} more` }),
        );
      redraw(chips, "entry", nodes.filter(Boolean), keys.wanted());
      if (!doc.plan.length)
        chips.replaceChildren(
          el("span", { class: "plan-note", text: "No segment is kept: nothing would run." }),
        );
      drops.replaceChildren(...drawDrops(doc, state, actions));
    },
  );
  store.later(["selected", "recording"], () => showChosen(chips));
  chips.addEventListener("wheel", turnSideways, { passive: false });
  attachDragging(chips, store, actions);
}

/** The chip of the selected segment, where the strip has more than fit. @param {HTMLElement} chips */
function showChosen(chips) {
  const chip = /** @type {HTMLElement|null} */ (chips.querySelector(".chip.on"));
  if (!chip) return;
  const left = chip.offsetLeft - chips.offsetLeft;
  const isSeen =
    left >= chips.scrollLeft &&
    left + chip.offsetWidth <= chips.scrollLeft + chips.clientWidth - FADES_PX;
  if (!isSeen) chips.scrollLeft = left - (chips.clientWidth - chip.offsetWidth) / 2;
}

/** The strip only goes sideways, and so does the wheel over it. @param {WheelEvent} event */
function turnSideways(event) {
  const chips = /** @type {HTMLElement} */ (event.currentTarget);
  if (event.ctrlKey || chips.scrollWidth <= chips.clientWidth) return;
  event.preventDefault();
  chips.scrollLeft += event.deltaX || event.deltaY;
}

/** @param {import("../model/types.js").Doc} doc */
function describe(doc, small) {
  const skills = plural(doc.plan.length, "skill");
  const seconds = doc.plan.reduce(
    (sum, { segment }) => sum + doc.segments[segment].end_s - doc.segments[segment].start_s,
    0,
  );
  return small || !doc.plan.length ? skills : `${skills}, about ${seconds.toFixed(1)} s`;
}

/**
 * @param {import("../model/types.js").PlanEntry} entry
 * @param {number} k
 * @param {import("../model/types.js").Doc} doc
 * @param {import("../lib/store.js").State} state
 */
function drawChip(entry, k, doc, state) {
  const { small } = state;
  const [first, last] = chosenStretch(state) ?? [0, -1];
  const on = entry.segment >= first && entry.segment <= last;
  const segment = doc.segments[entry.segment];
  const repeated = entry.repeat > 0;
  const contact = segment.end_condition.kind === "contact";
  const doubted = segment.end_condition.agrees === false;
  const how = repeated ? "repeated" : howItEnds(segment.end_condition);
  const short = shorter(segment);
  const name = small && doc.plan.length > 4 ? short.split(" ")[0] : short;
  return el(
    "div",
    {
      class: `chip ${on ? "on" : ""} ${doubted ? "doubted" : ""}`,
      role: "listitem",
      tabindex: 0,
      title: `${segment.label}, ${how}.${doubted ? ` ${DOUBT}` : ""} Drag to reorder, Ctrl drag to repeat, Delete takes it out.`,
      data: { entry: k },
    },
    el("div", {
      class: "chip-number",
      style: { background: segmentFill(segment) },
      text: entry.segment + 1,
    }),
    el(
      "div",
      { class: "chip-text" },
      el("b", { text: name }),
      repeated ? el("span", { class: "repeat", text: `×${entry.repeat + 1}` }) : "",
      el(
        "small",
        {},
        icon(doubted ? "warning" : contact ? "contact" : "goal"),
        doubted && !repeated ? `${how}, its demonstration does not` : how,
      ),
    ),
    el("span", { class: "grip" }, icon("grip")),
  );
}

/**
 * An arrow, or a dashed connecting move where the next skill starts somewhere else.
 * @param {import("../model/types.js").PlanEntry} entry
 * @param {any} planDrag
 */
function between(entry, planDrag) {
  if (planDrag || entry.connect_mm === null)
    return el("span", { class: "arrow" }, icon("right", "small"));
  return el(
    "div",
    { class: "connect", title: "A connecting move" },
    el("span", { text: "connect" }),
    el("i"),
    el("span", { text: `${Math.round(entry.connect_mm)} mm` }),
  );
}

/** @param {import("../model/types.js").Doc} doc */
function drawDrops(doc, { small, readOnly }, actions) {
  const proposed = doc.proposed_drops;
  if (!proposed.length || readOnly) return [];
  const many = proposed.length > (small ? 4 : 8);
  const chips = many
    ? []
    : proposed.map((index) =>
        el("div", { class: "drop-chip" }, el("b", { text: index + 1 }), small ? "" : "idle"),
      );
  const text = small ? `Drop ${proposed.length}` : `Drop all ${proposed.length}`;
  return [
    el("span", { class: "wide", text: "Proposed to drop" }),
    ...chips,
    el(
      "button",
      {
        type: "button",
        class: "boxed",
        id: "drop-idle",
        title: "Drop all idle segments (I)",
        on: { click: actions.dropIdle },
      },
      text,
      el("kbd", { text: "I" }),
    ),
  ];
}

/**
 * Drag a chip to reorder; with Ctrl it is repeated; dragged out of the strip it is taken out.
 * @param {import("../lib/store.js").Store} store
 */
function attachDragging(chips, store, actions) {
  chips.addEventListener("pointerdown", (event) => {
    const chip = /** @type {HTMLElement} */ (event.target).closest(".chip");
    const { document: doc, readOnly } = store.state;
    if (!chip || event.button !== 0) return;
    const entry = Number(/** @type {HTMLElement} */ (chip).dataset.entry);
    const start = { x: event.clientX, y: event.clientY };
    const stands = planStands(doc);
    let moved = false;
    chips.setPointerCapture(event.pointerId);

    const move = (at) => {
      moved ||= Math.hypot(at.clientX - start.x, at.clientY - start.y) > CLICK_PX;
      if (!moved || readOnly || !stands(store.state.document)) return;
      store.set({ planDrag: dropAt(chips, doc, entry, at) });
    };
    const end = (at) => {
      chips.removeEventListener("pointermove", move);
      chips.removeEventListener("pointerup", end);
      chips.removeEventListener("pointercancel", end);
      const { planDrag } = store.state;
      store.set({ planDrag: null });
      if (!stands(store.state.document)) return undefined;
      if (!moved) return actions.select(doc.plan[entry].segment);
      if (planDrag && at.type === "pointerup")
        actions.reorder(planDrag.order.map((k) => doc.plan[k].time_s));
      return undefined;
    };
    chips.addEventListener("pointermove", move);
    chips.addEventListener("pointerup", end);
    chips.addEventListener("pointercancel", end);
  });
}

/** @param {import("../model/types.js").Doc} doc */
function dropAt(chips, doc, entry, { clientX, clientY, ctrlKey, metaKey }) {
  const repeat = ctrlKey || metaKey;
  const all = doc.plan.map((_, k) => k);
  const rest = repeat ? all : all.filter((k) => k !== entry);
  const box = chips.getBoundingClientRect();
  if (!repeat && (clientY < box.top - 40 || clientY > box.bottom + 40))
    return { order: rest, place: -1 };
  const centres = [...chips.querySelectorAll(".chip:not(.dragged)")].map((chip) => {
    const { left, width } = chip.getBoundingClientRect();
    return left + width / 2;
  });
  const place = Math.min(centres.filter((centre) => centre < clientX).length, rest.length);
  return { order: rest.toSpliced(place, 0, entry), place };
}
