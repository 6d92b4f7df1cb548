/** What steers a replay: pause, speed, skill by skill, hold, stop; and what is left when it is over. */

import { byId, el, icon } from "../lib/dom.js";
import { time as timeText } from "../lib/format.js";
import { slotsOf } from "./schedule.js";
import { nowOf } from "./timeline.js";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4];

/** @param {import("../lib/store.js").Store} store @param {ReturnType<import("./replay.js").createReplayActions>} actions */
export function createReplayTransport(store, actions) {
  const play = el("button", { type: "button", class: "play", on: { click: actions.toggle } });
  const speedText = el("span", { text: "1×" });
  const speed = el(
    "select",
    {
      "aria-label": "Speed of the replay",
      on: { change: ({ target }) => actions.setSpeed(Number(target.value)) },
    },
    ...SPEEDS.map((value) => el("option", { value, text: `${value}×` })),
  );
  const now = document.createTextNode("");
  const whole = el("span");
  const { next, hold, stop, again, keep, leave } = createSteering(actions);
  const fit = el("button", {
    type: "button",
    class: "boxed",
    title: "Show all of the replay (F)",
    on: { click: () => store.set({ replayView: null }) },
    text: "Fit",
  });
  const world = el("span", { class: "wide quiet" });
  byId("replay-transport").append(
    play,
    el("div", { class: "boxed speed wide" }, speedText, icon("down", "small"), speed),
    el("div", { class: "clock" }, now, whole),
    el("span", { class: "rule" }),
    next,
    hold,
    stop,
    again,
    keep,
    leave,
    el("span", { class: "space" }),
    world,
    fit,
  );

  store.on(["samples", "replay"], (state) => {
    const { replay } = state;
    if (!replay) return;
    const at = nowOf(state);
    now.textContent = `${timeText(at)} `;
    whole.textContent = `/ ${Math.max(slotsOf(replay, at).at(-1).end, at).toFixed(2)} s`;
  });
  store.on(["replay", "readOnly"], ({ replay, lookingOnly }) => {
    if (!replay) return;
    const running = replay.phase === "running";
    const over = replay.phase === "over";
    play.replaceChildren(icon(running ? "pause" : "play"));
    play.title = running ? "Pause (Space)" : over ? "Run again (Space)" : "Go on (Space)";
    play.setAttribute("aria-label", running ? "Pause" : over ? "Run again" : "Go on");
    speedText.textContent = `${Number(replay.speed.toPrecision(3))}×`;
    /** @type {HTMLSelectElement} */ (speed).value = String(replay.speed);
    hold.classList.toggle("on", replay.held);
    hold.setAttribute("aria-pressed", String(replay.held));
    for (const button of [next, hold, stop]) button.hidden = over;
    for (const button of [again, keep, leave]) button.hidden = !over;
    for (const button of [play, next, hold, stop, again, keep, leave])
      /** @type {HTMLButtonElement} */ (button).disabled = lookingOnly;
    world.textContent = replay.world;
  });
}

/** The buttons that steer. @param {ReturnType<import("./replay.js").createReplayActions>} actions */
function createSteering(actions) {
  const boxed = (name, text, title, run, extra = "", key = "") =>
    el(
      "button",
      { type: "button", class: `boxed ${extra}`, title, on: { click: run } },
      icon(name),
      text,
      key ? el("kbd", { text: key }) : "",
    );
  return {
    next: boxed("step", "Next skill", "Go on until the skill has ended (.)", actions.next),
    hold: boxed("hand", "Hold", "Hold the tool where it is; the skill waits (H)", actions.hold),
    stop: boxed("stop", "Stop", "Stop at once (Esc)", actions.stop, "danger", "Esc"),
    again: boxed("play", "Run again", "Replay the plan from its start", actions.again),
    keep: boxed(
      "file",
      "Open its recording",
      "Keep the replay as a recording and open it",
      actions.keep,
    ),
    leave: boxed("close", "Close", "Back to the demonstration (Esc)", actions.leave, "", "Esc"),
  };
}
