/** Playback and the edits one makes most, between scene and timeline. */

import { doubtsElsewhere } from "../model/recordings/recording_list.js";
import { timeLeft, unsureBoundaries } from "../model/unsure.js";
import { byId, el, icon } from "../lib/dom.js";
import { moment, time as timeText } from "../lib/format.js";
import { SPEEDS } from "../model/playback.js";

/** The zoom slider's whole way: this many times closer. */
const CLOSEST = 1000;

/**
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 * @param {{tracks: (event: Event) => void}} menus
 */
export function createTransport(store, actions, menus) {
  const unsure = createUnsure(actions);
  const bar = byId("transport");
  bar.append(
    ...createPlaying(store, actions),
    el("span", { class: "rule" }),
    ...createEdits(store, actions),
    el("span", { class: "rule" }),
    createSnap(store, actions),
    el("span", { class: "space" }),
    unsure.node,
    el("span", { class: "rule wide" }),
    createZoom(store, actions).node,
    el("button", {
      type: "button",
      class: "boxed wide",
      title: "The whole recording (F)",
      text: "Fit",
      on: { click: actions.fit },
    }),
    el(
      "button",
      {
        type: "button",
        class: "boxed",
        title: "Which tracks to show",
        "aria-haspopup": "menu",
        on: { click: menus.tracks },
      },
      icon("layers"),
      el("span", { class: "wide", text: "Tracks" }),
    ),
  );
  store.later(["document"], ({ document: doc }) => {
    for (const button of bar.querySelectorAll("button")) button.disabled = !doc;
  });
  store.later(["document", "current", "recordings", "secondsPerDoubt"], unsure.draw);
}

const tool = (name, title, run, extra = "") =>
  el(
    "button",
    { type: "button", class: `tool ${extra}`, title, "aria-label": title, on: { click: run } },
    icon(name),
  );

/**
 * Where it plays, whether, how fast, and the time.
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 */
function createPlaying(store, actions) {
  const play = tool("play", "Play (Space)", actions.togglePlay);
  play.className = "play";
  const loop = tool("loop", "Play again and again", actions.toggleLoop, "wide");
  store.on(["playhead"], ({ playhead }) => {
    play.replaceChildren(icon(playhead.playing ? "pause" : "play"));
    play.title = playhead.playing ? "Pause (Space)" : "Play (Space)";
    play.setAttribute("aria-label", playhead.playing ? "Pause" : "Play");
    loop.classList.toggle("on", playhead.loop);
    loop.setAttribute("aria-pressed", String(playhead.loop));
  });
  return [
    tool("first", "To the start (Home)", actions.toStart),
    tool("back", "Previous boundary (,)", () => actions.step(-1)),
    play,
    tool("forward", "Next boundary (.)", () => actions.step(1)),
    tool("last", "To the end (End)", actions.toEnd),
    loop,
    createSpeed(store, actions),
    createClock(store),
  ];
}

/** @param {import("../lib/store.js").Store} store @param {any} actions */
function createSpeed(store, actions) {
  const text = el("span", { text: "1×" });
  const select = /** @type {HTMLSelectElement} */ (
    el(
      "select",
      {
        "aria-label": "Speed",
        on: { change: ({ target }) => actions.setSpeed(Number(target.value)) },
      },
      ...SPEEDS.map((speed) => el("option", { value: speed, text: `${speed}×` })),
    )
  );
  store.on(["playhead"], ({ playhead }) => {
    text.textContent = `${playhead.speed}×`.replace("-", "−");
    select.value = String(playhead.speed);
  });
  return el("div", { class: "boxed speed wide" }, text, icon("down", "small"), select);
}

/** @param {import("../lib/store.js").Store} store */
function createClock(store) {
  const now = document.createTextNode("0.000 ");
  const whole = el("span", { text: "" });
  store.on(["clock"], ({ clock }) => (now.textContent = `${timeText(clock)} `));
  store.later(["document"], ({ document: doc }) => {
    whole.textContent = doc ? `/ ${moment(doc.end_s)}` : "";
  });
  return el("div", { class: "clock", id: "clock" }, now, whole);
}

/**
 * The edits one makes most.
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 */
function createEdits(store, actions) {
  const named = (name, text, key, run) =>
    /** @type {HTMLButtonElement} */ (
      el(
        "button",
        { type: "button", class: "tool edit", title: `${text} (${key})`, on: { click: run } },
        icon(name),
        text,
        el("kbd", { class: "wide", text: key }),
      )
    );
  const drop = named("drop", "Drop", "X", () => actions.toggleDrop());
  const edits = [
    named("split", "Split", "T", actions.split),
    named("merge", "Merge", "M", actions.merge),
    drop,
    named("label", "Label", "L", () => actions.rename()),
  ];
  store.later(["document", "readOnly"], ({ readOnly, document: doc }) => {
    for (const button of edits) button.disabled = readOnly || !doc;
  });
  store.later(["document", "selected", "clock"], ({ document: doc, selected }) => {
    const segment = doc?.segments[selected];
    const text = segment && !segment.kept ? "Keep" : "Drop";
    if (drop.childNodes[1].textContent !== text) drop.childNodes[1].textContent = text;
  });
  return edits;
}

/** @param {import("../lib/store.js").Store} store @param {any} actions */
function createSnap(store, actions) {
  const snap = el(
    "button",
    {
      type: "button",
      class: "tool",
      title: "Snap to evidence while dragging (V); Alt switches it off",
      on: { click: actions.toggleSnap },
    },
    icon("snap"),
    el("span", { class: "wide", text: "Snap" }),
  );
  store.on(["snap"], ({ snap: on }) => {
    snap.classList.toggle("on", on);
    snap.setAttribute("aria-pressed", String(on));
  });
  return snap;
}

/** How many boundaries are unsure, which is the least certain, and the way through them. */
function createUnsure(actions) {
  const count = el("span", { class: "low" });
  const which = el("span", { class: "quiet wide" });
  const step = (name, title, direction) =>
    el(
      "button",
      {
        type: "button",
        class: "tool",
        title,
        "aria-label": title,
        on: { click: () => actions.visitUnsure(direction) },
      },
      icon(name),
    );
  const node = el(
    "div",
    { class: "boxed unsure" },
    count,
    which,
    step("left", "Previous unsure boundary (Shift N)", -1),
    step("right", "Next unsure boundary (N)", 1),
  );
  return {
    node,
    draw(state) {
      const { document: doc, current } = state;
      const unsure = unsureBoundaries(doc);
      const elsewhere = doubtsElsewhere(state);
      node.hidden = !doc || unsure.length + elsewhere === 0;
      if (node.hidden) return;
      count.textContent = unsure.length ? `${unsure.length} unsure` : `${elsewhere} elsewhere`;
      const index = unsure.includes(current) ? current : unsure[0];
      which.textContent = unsure.length
        ? `boundary ${index + 1}, ${doc.boundaries[index].confidence.toFixed(2)}`
        : "unsure";
      const left = timeLeft(unsure.length + elsewhere, state.secondsPerDoubt);
      if (left && unsure.length) which.textContent = left;
      node.title = elsewhere ? `${elsewhere} more in other recordings` : "";
    },
  };
}

/**
 * The zoom slider: logarithmic, from the whole recording to a thousandth of it.
 * @param {import("../lib/store.js").Store} store
 */
function createZoom(store, actions) {
  const input = /** @type {HTMLInputElement} */ (
    el("input", { type: "range", min: 0, max: 100, step: 1, value: 0, "aria-label": "Zoom" })
  );
  const node = el(
    "div",
    { class: "zoom wide" },
    el(
      "button",
      {
        type: "button",
        class: "tool",
        title: "Further (-)",
        "aria-label": "Zoom out",
        on: { click: () => actions.zoom(1 / 1.5) },
      },
      icon("minus"),
    ),
    input,
    el(
      "button",
      {
        type: "button",
        class: "tool",
        title: "Closer (+)",
        "aria-label": "Zoom in",
        on: { click: () => actions.zoom(1.5) },
      },
      icon("plus"),
    ),
  );
  const closeness = ({ document: doc, view }) => (doc.end_s - doc.start_s) / (view.to - view.from);
  input.addEventListener("input", () => {
    if (store.state.document)
      actions.zoom(CLOSEST ** (Number(input.value) / 100) / closeness(store.state));
  });
  store.later(["view", "document"], (state) => {
    if (!state.document || !state.view) return;
    const share = Math.min(100, (100 * Math.log(closeness(state))) / Math.log(CLOSEST));
    if (!input.matches(":active")) input.value = String(share);
    input.style.setProperty("--share", `${share}%`);
  });
  return { node };
}
