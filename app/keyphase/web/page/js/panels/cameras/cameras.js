/** The cameras beside the scene: which are seen, their pictures, and where each lies on the clock. */

import { chosenCameras, hasFootage, offsetOf } from "../../model/footage/frames.js";
import { byId, el, icon } from "../../lib/dom.js";
import { plural } from "../../lib/format.js";
import { createPlayer } from "./player.js";

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createCameras(store, actions) {
  const pane = byId("cameras");
  const choices = el("div", { class: "camera-choices", role: "group", "aria-label": "Cameras" });
  const views = el("div", { class: "camera-views" });
  const reasons = el("ul");
  const count = el("summary");
  const refused = /** @type {HTMLDetailsElement} */ (
    el("details", { class: "camera-refused" }, count, reasons)
  );
  pane.append(
    el(
      "header",
      {},
      choices,
      el(
        "button",
        {
          type: "button",
          class: "tool",
          title: "Hide the cameras (H)",
          "aria-label": "Hide the cameras",
          on: { click: actions.toggleCameras },
          data: { icon: "close" },
        },
        icon("close"),
      ),
    ),
    views,
    refused,
  );
  askWhenOpen(store, actions.send);
  /** @type {Map<string, ReturnType<typeof createView>>} by the camera's id */
  const open = new Map();

  function choose(state) {
    const shown = hasFootage(state);
    pane.hidden = !shown;
    const chosen = shown ? chosenCameras(state) : [];
    for (const [id, view] of open) {
      if (chosen.some((one) => one.id === id)) continue;
      view.player.close();
      open.delete(id);
    }
    for (const camera of chosen)
      if (!open.has(camera.id)) open.set(camera.id, createView(camera, store, actions));
    const nodes = chosen.map(({ id }) => open.get(id)?.node ?? "");
    if (
      nodes.some((node, k) => views.children[k] !== node) ||
      views.children.length !== nodes.length
    )
      views.replaceChildren(...nodes);
    choices.replaceChildren(
      ...(state.cameras?.cameras ?? []).map((one) => choice(one, chosen, actions)),
    );
    const unseen = state.cameras?.refused ?? [];
    reasons.replaceChildren(...unseen.map((text) => el("li", { text })));
    count.textContent = `${plural(unseen.length, "video")} cannot be shown`;
    refused.hidden = !unseen.length;
    // Where there is nothing else to see the reasons are; beside a picture they wait to be asked.
    refused.open = !state.cameras?.cameras.length;
  }
  store.on(["cameras", "camerasShown", "camerasChosen", "recording"], choose);
  store.on(
    ["clock", "pointer", "playhead", "document", "cameras", "camerasShown", "camerasChosen"],
    (state) => {
      for (const view of open.values()) view.show(state);
    },
  );
}

/** A button that shows a camera or not. */
function choice({ name, id }, chosen, actions) {
  const on = chosen.some((one) => one.id === id);
  return el("button", {
    type: "button",
    class: `camera-choice ${on ? "on" : ""}`,
    "aria-pressed": String(on),
    text: name,
    title: name,
    on: { click: () => actions.toggleCamera(name) },
  });
}

/** The server looks for videos when it is asked, once a recording is open. */
function askWhenOpen(store, send) {
  let asked = null;
  /** What a page still shows whose server may have been started anew, and has it not open yet. */
  let left = null;
  store.on(["connected"], ({ document: doc }) => {
    asked = null;
    left = doc;
  });
  store.later(["document"], ({ document: doc, connected }) => {
    if (!doc || !connected || doc === left || asked === doc.id) return;
    asked = doc.id;
    send({ type: "cameras", recording: doc.id });
  });
}

/**
 * One camera: its picture, which frame that is, its offset.
 * @param {import("../../model/footage/frames.js").Camera} camera
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
function createView(camera, store, actions) {
  const frame = el("span", { class: "camera-frame", text: "…" });
  const why = el("p", { class: "camera-why", hidden: true });
  const player = createPlayer(
    camera,
    (shown) => (frame.textContent = `frame ${shown} of ${camera.frames}`),
    (text) => {
      why.textContent = `This browser cannot play ${camera.name}: ${text}`;
      why.hidden = false;
    },
    (sought) => {
      const others = [...store.state.sought].filter((id) => id !== camera.id);
      store.set({ sought: new Set(sought ? [...others, camera.id] : others) });
    },
  );
  const offset = offsetField(camera, store, actions);
  const node = el(
    "figure",
    { class: "camera", data: { camera: camera.name } },
    el("div", { class: "camera-picture" }, player.node, why),
    el(
      "figcaption",
      {},
      el("b", { text: camera.name }),
      frame,
      el("span", { class: "space" }),
      offset.node,
    ),
  );
  return {
    node,
    player,
    /** The frame under the pointer while it hovers, else that of the playhead. */
    show(state) {
      const { document: doc, playhead, pointer, clock } = state;
      const laid = offsetOf(doc, camera);
      offset.show(laid);
      if (playhead.playing && playhead.speed > 0) player.follow(laid, clock, playhead.speed);
      else player.rest(laid, pointer ?? clock);
    },
  };
}

/** How much later the video is laid than its file says, in ms. */
function offsetField(camera, store, actions) {
  const input = /** @type {HTMLInputElement} */ (
    el("input", {
      type: "number",
      class: "number",
      step: "any",
      title: "How much later than its file says this video is laid; ( and ) move it by a frame",
      "aria-label": `Offset of ${camera.name} in ms`,
      on: { change: () => actions.setCameraOffset(camera, Number(input.value) / 1000) },
    })
  );
  store.later(["readOnly"], ({ readOnly }) => (input.disabled = readOnly));
  input.disabled = store.state.readOnly;
  return {
    node: el("label", { class: "camera-offset" }, "offset", input, "ms"),
    /** @param {number} seconds */
    show(seconds) {
      const text = String(Math.round(seconds * 1e6) / 1e3);
      if (document.activeElement !== input && input.value !== text) input.value = text;
    },
  };
}
