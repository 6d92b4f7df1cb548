/** The world a replay runs in, its run, what became of each skill, its margin, and trials. */

import { el } from "../../lib/dom.js";
import { button, choice, group, row, slider, toggle } from "./fields.js";
import { createOutcomes } from "./outcomes.js";
import { createMargin } from "./margin.js";
import { createTrials } from "./trials.js";

/** What a world may differ in: the setting's name, how the page calls it, and its unit for people. */
/** @type {[string, string, string, number, string][]} */
const WORLD = [
  ["part_height_m", "Part height", "mm", 1e3, "The table with all on it is higher than it was."],
  ["part_aside_m", "Part aside", "mm", 1e3, "The part to be met lies aside."],
  ["friction", "Friction", "", 1, "Coefficient of sliding friction of all parts."],
  ["sensor_noise", "Sensor noise", "×", 1, "The wrist sensor's noise, as a multiple of its own."],
];

const STEER = { running: "Pause", paused: "Go on", over: "Again" };

/** What the world made from the recording is called. */
const RECORDING = "recording";

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createReplayTab(store, actions) {
  const world = el("div");
  const run = createRun(store, actions);
  const outcomes = createOutcomes(store, actions);
  const workcell = choice("Scene", "The workcell the plan runs in.", (name) =>
    actions.replaySettings({ workcell: name }),
  );
  const endBy = choice(
    "End by",
    "contact: skills that met a contact end at it again. configuration: all skills end at their " +
      "demonstrated pose, whatever is touched.",
    (end) => actions.replaySettings({ end_by: end }),
  );
  /** @type {ReturnType<typeof worldSlider>[]} */
  let sliders = [];

  store.on(["replaySettings"], ({ replaySettings: settings }) => {
    if (!settings) return;
    if (!sliders.length) {
      sliders = WORLD.filter(([name]) => name in settings.ranges).map((one) =>
        worldSlider(one, settings.ranges, actions),
      );
      world.replaceChildren(...sliders.map(({ node }) => node));
    }
    workcell.show(
      settings.choices.map(({ name }) => ({
        value: name,
        text: name === RECORDING ? "made from it" : name,
      })),
      settings.workcell,
    );
    endBy.show(
      settings.ends.map((end) => ({ value: end, text: end })),
      settings.end_by,
    );
    for (const one of sliders) one.show(one.factor * settings[one.name], null);
  });
  return el(
    "div",
    { class: "panel-body" },
    group("Workcell", {}, workcell.node, world, endBy.node),
    run,
    outcomes,
    createMargin(store, actions),
    createTrials(store, actions),
  );
}

/** @param {[string, string, string, number, string]} setting */
function worldSlider([name, title, unit, factor, hint], ranges, actions) {
  const [low, high] = ranges[name].map((bound) => factor * bound);
  const step = unit === "mm" ? 0.5 : 0.05;
  const made = slider({
    title: unit ? `${title}, ${unit}` : title,
    hint,
    low,
    high,
    step: "any",
    share: (value) => (value - low) / (high - low),
    value: (share) => Number((Math.round((low + share * (high - low)) / step) * step).toFixed(3)),
    told: (value, held) => held || actions.replaySettings({ [name]: value / factor }),
  });
  return { ...made, name, factor };
}

/**
 * Speed, and the buttons that steer.
 * @param {import("../../lib/store.js").Store} store
 */
function createRun(store, actions) {
  const speed = slider({
    title: "Speed",
    hint: "× real time.",
    low: 0.1,
    high: 4,
    step: "any",
    share: (value) => Math.log(value / 0.1) / Math.log(40),
    value: (share) => Number((0.1 * 40 ** share).toPrecision(2)),
    told: (value, held) => held || actions.replaySettings({ speed: value ?? 1 }),
  });
  const first = button("Run", {
    look: "primary",
    symbol: "play",
    hint: "Replay the plan (P)",
    run: () => steer(store, actions),
  });
  const step = button("Step", {
    symbol: "step",
    hint: "Go on until the skill that runs has ended.",
    run: actions.replay.next,
  });
  const stop = button("Stop", {
    look: "danger",
    symbol: "stop",
    hint: "Stop at once (Esc)",
    run: actions.replay.stop,
  });
  const push = toggle(
    "Push the tool",
    "Arrows at the tool: drag them, and a spring pulls the tool along while it runs.",
    actions.push,
  );
  store.on(
    ["replaySettings"],
    ({ replaySettings: settings }) => settings && speed.show(settings.speed, 1),
  );
  store.later(
    ["replay", "document", "readOnly", "greeted"],
    ({ replay, document: doc, lookingOnly }) => {
      first.lastElementChild.textContent = STEER[replay?.phase] ?? "Run";
      first.disabled = step.disabled = lookingOnly || !doc;
      stop.disabled = lookingOnly || !replay || replay.phase === "over";
    },
  );
  store.later(["pushOffered"], ({ pushOffered }) => push.show(pushOffered));
  return group("Run", {}, speed.node, row(first, step, stop), push.node);
}

function steer({ state }, actions) {
  if (state.replay?.phase === "over") actions.replay.again();
  else if (state.replay) actions.replay.toggle();
  else actions.replay.run();
}
