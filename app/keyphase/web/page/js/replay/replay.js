/** Replay in the page: turns it from the demonstration to the replay and back. */

import { sceneFrames } from "../scene/viser_client.js";
import { byId, el, svg } from "../lib/dom.js";
import { createScenePace } from "../scene/scene_pace.js";
import { createReplayPlan } from "./plan.js";
import { withRows } from "./samples.js";
import { endText, placeText } from "./schedule.js";
import { createReplayTimeline } from "./timeline.js";
import { createReplayTransport } from "./transport.js";

const PLACES = ["timeline", "transport", "plan"];

/**
 * What a person can ask of a replay, as one function each.
 * @param {import("../lib/store.js").Store} store
 * @param {import("../model/types.js").Send} send
 */
export function createReplayActions(store, send) {
  const ask = (what) => () => send({ type: "replay", do: what });
  return {
    run: ask("run"),
    again: ask("again"),
    next: ask("next"),
    stop: ask("stop"),
    leave: ask("leave"),
    keep: ask("keep"),
    toggle: () =>
      send({ type: "replay", do: store.state.replay?.phase === "running" ? "pause" : "run" }),
    hold: () => send({ type: "replay", do: store.state.replay?.held ? "release" : "hold" }),
    setSpeed: (speed) => send({ type: "replay", do: "speed", speed }),
  };
}

/**
 * @param {import("../lib/store.js").Store} store
 * @param {ReturnType<typeof createReplayActions>} actions
 * @returns {Object<string, (message: any) => void>} what to do with messages
 */
export function createReplay(store, actions) {
  createReplayTimeline(store);
  createReplayTransport(store, actions);
  createReplayPlan(store);
  createReplayHud(store);
  paceScene(store);
  const status = byId("replay-status");
  // What can be done with a replay stands in its tab; closed, what was there before it is back.
  let tabBefore = store.state.tab;
  store.on(["replay"], ({ replay, replayShown, tab }) => {
    const shown = replay !== null;
    if (shown === replayShown) return;
    document.documentElement.dataset.mode = shown ? "replay" : "";
    for (const id of PLACES) byId(`replay-${id}`).hidden = !shown;
    store.set({ replayShown: shown, tab: shown ? "replay" : tab === "replay" ? tabBefore : tab });
    tabBefore = tab;
  });
  store.later(["replay"], ({ replay }) => {
    if (replay)
      status.replaceChildren(
        "Replay of ",
        el("b", { text: replay.name }),
        el("span", { class: "wide", text: ending(replay) }),
      );
  });
  return {
    samples: (message) => store.set({ samples: withRows(store.state.samples, message) }),
  };
}

/** While something plays or is replayed the scene leaves time to the timeline. */
function paceScene({ state }) {
  const pace = createScenePace(
    sceneFrames,
    () => state.replay?.phase === "running" || state.playhead.playing,
  );
  const frame = /** @type {HTMLIFrameElement} */ (byId("viser"));
  // After all others that watch the frame, so that what it draws with is seen as it is.
  frame.addEventListener("load", () => setTimeout(() => pace.watch(frame.contentWindow)));
}

/** When the skill that runs will be over. @param {import("../model/types.js").Replay} replay */
function ending({ skills, current }) {
  return current === null ? "" : `${skills[current].label}: ${skills[current].until}`;
}

/**
 * What is replayed where, and how far and how fast it is, over the scene; and the legend of it.
 * @param {import("../lib/store.js").Store} store
 */
function createReplayHud(store) {
  const what = byId("replay-what");
  const how = byId("replay-how");
  store.on(["replay"], ({ replay }) => {
    what.replaceChildren(...(replay ? [el("b", { text: "● Replay" }), ` ${replay.words}`] : []));
  });
  store.on(["replay", "samples"], ({ replay, samples }) => {
    how.textContent = replay ? said(replay, samples).join(" · ") : "";
  });
  byId("replay-legend").append(
    el("span", {}, line("var(--idle)", 2), "demonstration"),
    el("span", {}, line("var(--segment-2)", 3), "replay"),
    el(
      "span",
      {},
      svg(
        "svg",
        { width: 26, height: 8 },
        svg("path", { d: "M0 4h20", "stroke-width": 3, style: { stroke: "var(--origin-force)" } }),
        svg("path", { d: "M18 0l8 4-8 4z", style: { fill: "var(--origin-force)" } }),
      ),
      "measured force",
    ),
  );
}

/**
 * How far and how fast it is; once it is over, first how it ended.
 * @param {import("../model/types.js").Replay} replay
 * @param {import("./samples.js").Samples|null} samples
 */
function said(replay, samples) {
  const { phase, held } = replay;
  if (phase === "over") return [endText(replay), placeText(replay)];
  if (phase !== "running") return [placeText(replay), phase];
  return [
    placeText(replay),
    ...(samples?.factor ? [`${samples.factor.toFixed(2)}× real time`] : []),
    ...(held ? ["held"] : []),
  ];
}

const line = (color, width) =>
  svg(
    "svg",
    { width: 16, height: 8 },
    svg("path", { d: "M0 4h16", "stroke-width": width, style: { stroke: color } }),
  );
