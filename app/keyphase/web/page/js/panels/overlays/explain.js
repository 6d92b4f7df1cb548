/** Opens the "why" beside the boundary the pointer rests on, or the one that was visited. */

import { byId } from "../../lib/dom.js";
import { createWhy } from "./why.js";

const OPENS_AFTER_MS = 180;
const CLOSES_AFTER_MS = 250;
const GAP_PX = 14;

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} timeline
 * @param {any} actions
 */
export function createExplain(store, timeline, actions) {
  const node = byId("why");
  const why = createWhy(node, {
    accept: actions.acceptAndGoOn,
    next: () => actions.visitUnsure(1),
    remove: actions.removeBoundary,
    move: (index, time) => moveTo(index, time),
  });
  let timer = 0;
  let inside = false;
  function moveTo(index, time) {
    actions.moveBoundary(store.state.document.boundaries[index].time_s, time);
    actions.seek(time);
  }

  const later = (change, delay) => {
    clearTimeout(timer);
    timer = setTimeout(() => store.set(change), delay);
  };
  node.addEventListener("pointerenter", () => {
    inside = true;
    clearTimeout(timer);
  });
  node.addEventListener("pointerleave", () => {
    inside = node.contains(document.activeElement);
    if (!inside) later({ explained: null }, CLOSES_AFTER_MS);
  });

  // A wheel turned over it is meant for the timeline, which it must not stop.
  node.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      timeline.surface.dispatchEvent(new WheelEvent("wheel", event));
    },
    { passive: false },
  );

  // Who types a time there has it open until the field is left.
  node.addEventListener("focusin", () => {
    inside = true;
    clearTimeout(timer);
  });
  node.addEventListener("focusout", () => (inside = node.matches(":hover")));

  store.on(["holding"], ({ holding, explained, current }) => {
    if (!holding || explained === current) return;
    clearTimeout(timer);
    inside = false;
    store.set({ explained: null });
  });
  store.on(["hovered"], ({ hovered, explained, drag, holding }) => {
    if (drag || holding) return;
    if (hovered !== null) later({ explained: hovered }, explained === null ? OPENS_AFTER_MS : 60);
    else if (!inside && explained !== null) later({ explained: null }, CLOSES_AFTER_MS);
    else clearTimeout(timer);
  });
  store.on(["explained", "document", "view", "layout", "drag", "renaming"], (state) => {
    const { document: doc, explained, drag } = state;
    const boundary = doc?.boundaries[explained];
    const seen =
      boundary &&
      state.view &&
      boundary.time_s >= state.view.from &&
      boundary.time_s <= state.view.to;
    if (!seen || drag || state.renaming !== null) return why.hide();
    why.show(doc, explained, state.readOnly);
    return place(node, timeline, boundary, state.small);
  });
}

/**
 * Beside the boundary below the band of segments; in a small window above them.
 * @param {import("../../model/types.js").Boundary} boundary
 */
function place(node, timeline, boundary, small) {
  const box = timeline.surface.getBoundingClientRect();
  const { rows } = timeline.layout();
  const x = box.left + timeline.scale().x(boundary.time_s);
  const { offsetWidth: width, offsetHeight: height } = node;
  const right = x + GAP_PX;
  const beside = right + width <= innerWidth - 8 ? right : x - GAP_PX - width;
  const above = Math.min(x - 24, innerWidth - width - 8);
  const below = box.top + rows.get("segments").y + rows.get("segments").height + 10;
  const fits = below + height <= innerHeight - 8;
  const top = small || !fits ? box.top + rows.get("boundaries").y - height - 1 : below;
  node.style.setProperty("left", `${Math.round(small || !fits ? Math.max(8, above) : beside)}px`);
  node.style.setProperty("top", `${Math.round(Math.max(8, top))}px`);
}
