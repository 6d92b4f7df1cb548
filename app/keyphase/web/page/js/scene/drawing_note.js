/**
 * Says over the scene that a recording is being drawn, from when it is looked at until its path and
 * its own robot stand there. What is drawn at once says nothing: the words would only flash.
 */

import { isDressed, isStanding } from "./viser_client.js";
import { byId } from "../lib/dom.js";

/** What has come by then is not announced. */
const PATIENCE_MS = 150;
/** How often we look whether it stands. */
const LOOK_MS = 100;
/** If by then the scene has not said so, its connection is gone, and the page says that elsewhere. */
const GIVE_UP_MS = 60_000;

/**
 * @param {import("../lib/store.js").Store} store
 * @param {() => Window|null} inside viser's window
 */
export function createDrawingNote(store, inside) {
  const note = byId("drawing-note");
  let looking = 0;
  let begun = 0;

  function begin() {
    clearInterval(looking);
    note.textContent = "";
    begun = performance.now();
    looking = setInterval(look, LOOK_MS);
    look();
  }

  function look() {
    const { document: doc, record, replay } = store.state;
    const waited = performance.now() - begun;
    const isOver = !doc || isStanding(inside(), doc.id) || waited > GIVE_UP_MS;
    if (isOver) clearInterval(looking);
    // Before the scene is dressed, and without 3D, other words stand in its place.
    const says =
      !isOver && waited >= PATIENCE_MS && isDressed(inside()) && !record?.workcell && !replay;
    const text = says ? `drawing ${doc.name}…` : "";
    if (note.textContent !== text) note.textContent = text;
  }

  store.on(["recording"], begin);
}
