/** The plan in a replay: what has run and how it ended, what runs, what waits. */

import { segmentFill } from "../lib/colors.js";
import { byId, el, icon } from "../lib/dom.js";
import { duration } from "../lib/format.js";
import { shorter } from "../model/label_forms.js";
import { placeText, slotsOf } from "./schedule.js";
import { nowOf } from "./timeline.js";

/** @param {import("../lib/store.js").Store} store */
export function createReplayPlan(store) {
  const place = el("div");
  const chips = el("div", { class: "chips", role: "list" });
  const verdict = el("div", { class: "plan-verdict", role: "status" });
  byId("replay-plan").append(
    el("div", { class: "plan-title" }, el("b", { text: "Plan" }), place),
    chips,
    verdict,
  );
  /** @type {HTMLElement|null} */
  let running = null;

  store.on(["replay", "small"], (state) => {
    const { replay } = state;
    if (!replay) return;
    place.textContent = placeText(replay);
    const slots = slotsOf(replay, nowOf(state));
    running = null;
    chips.replaceChildren(
      ...slots.flatMap((slot, k) => {
        if (slot.skill.segment === null) return k ? [connecting(slot)] : [];
        const node = chip(slot);
        if (slot.progress === "running") running = node.querySelector("small");
        const arrow =
          slots.slice(0, k).some(({ skill }) => skill.segment !== null) &&
          slots[k - 1].skill.segment !== null;
        return arrow ? [el("span", { class: "arrow" }, icon("right", "small")), node] : [node];
      }),
    );
    drawVerdict(verdict, replay);
    showRunning(chips);
    tell(state);
  });
  store.on(["samples"], tell);

  /** @param {import("../lib/store.js").State} state */
  function tell(state) {
    if (!running || !state.replay) return;
    const slot = slotsOf(state.replay, nowOf(state)).find(({ progress }) => progress === "running");
    if (slot)
      running.textContent = `● ${state.replay.phase} · ${duration(Math.max(0, nowOf(state) - slot.start))}`;
  }
}

/** What runs, where the strip has more than fit. @param {HTMLElement} chips */
function showRunning(chips) {
  const on = /** @type {HTMLElement|null} */ (chips.querySelector(".chip.on"));
  if (!on) return;
  const left = on.offsetLeft - chips.offsetLeft;
  if (left < chips.scrollLeft || left + on.offsetWidth > chips.scrollLeft + chips.clientWidth)
    chips.scrollLeft = left - (chips.clientWidth - on.offsetWidth) / 2;
}

/** @param {import("./schedule.js").Slot} slot */
function chip(slot) {
  const { skill, progress } = slot;
  return el(
    "div",
    {
      class: `chip ${progress === "running" ? "on" : ""} ${progress}`,
      role: "listitem",
      title: `${skill.label}, ${skill.until}`,
      data: { outcome: skill.outcome ?? progress },
    },
    el("div", {
      class: "chip-number",
      style: { background: segmentFill(skill) },
      text: skill.segment + 1,
    }),
    el("div", { class: "chip-text" }, el("b", { text: shorter(skill) }), how(slot)),
  );
}

/** @param {import("./schedule.js").Slot} slot */
function how({ skill, progress, good }) {
  if (progress === "waiting") return el("small", { text: "waits" });
  if (progress === "running") return el("small", { class: "running" });
  const measured =
    skill.outcome === "contact"
      ? `${skill.peak_N.toFixed(1)} N`
      : duration(skill.end_s - skill.start_s);
  return el(
    "small",
    { class: good ? "good" : "bad" },
    icon(good ? "check" : "close"),
    `${skill.outcome} · ${measured}`,
  );
}

/** @param {import("./schedule.js").Slot} slot */
function connecting({ skill }) {
  return el(
    "div",
    { class: "connect", title: "A connecting move" },
    el("span", { text: "connect" }),
    el("i"),
    el("span", { text: `${Math.round(1000 * skill.way_m)} mm` }),
  );
}

/** @param {HTMLElement} node @param {import("../model/types.js").Replay} replay */
function drawVerdict(node, { phase, succeeded, outcome, goal }) {
  node.classList.toggle("good", phase === "over" && succeeded === true);
  node.classList.toggle("bad", phase === "over" && succeeded !== true);
  const text = phase === "over" ? (outcome ?? "stopped before it moved") : goal;
  node.classList.toggle("goal", phase !== "over");
  node.title = text;
  node.replaceChildren(
    ...(phase === "over" ? [icon(succeeded ? "check" : "close")] : []),
    el("span", { text: text.charAt(0).toUpperCase() + text.slice(1) }),
  );
}
