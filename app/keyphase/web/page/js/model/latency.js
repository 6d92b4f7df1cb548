/**
 * How long a person waits: from the input event that carried a value to the first frame of the
 * timeline that shows what the value did. Every input has a number that travels to the server and
 * back with the document that it led to.
 *
 * Where the segments changed, the first frame of the 3D scene after that is timed as well.
 *
 * @typedef {"line"|"slider"|"edit"} Source
 * @typedef {{event: number, milliseconds: number, source: Source|"scene"}} Measurement
 */

const SCENE_WAIT_MS = 3000;

/**
 * @param {import("../lib/store.js").Store} store
 * @param {import("./types.js").Send} send
 * @param {() => number|undefined} sceneFrames how many frames the 3D scene has drawn
 */
export function createLatency(store, send, sceneFrames) {
  /** @type {Measurement[]} */
  const list = [];
  /** @type {Map<number, {at: number, source: Source}>} */
  const sent = new Map();
  let number = 0;
  let segmentsSeen = "";

  function finish(event, at, source, changed) {
    const drawn = sceneFrames();
    store.afterFrame(() => {
      const milliseconds = performance.now() - at;
      list.push({ event, milliseconds, source });
      send({ type: "latency", event, milliseconds });
      if (changed && drawn !== undefined) finishScene(event, at, drawn);
    });
  }

  function finishScene(event, at, drawn) {
    const milliseconds = performance.now() - at;
    if (sceneFrames() !== drawn) list.push({ event, milliseconds, source: "scene" });
    else if (milliseconds < SCENE_WAIT_MS)
      requestAnimationFrame(() => finishScene(event, at, drawn));
  }

  return {
    list,
    /** Remembers an input of our own; its number travels with the message. */
    began(timeStamp, source) {
      number += 1;
      sent.set(number, { at: timeStamp, source });
      return number;
    },
    /** @param {import("./types.js").Doc} doc a document that is about to be drawn */
    arrived(doc, isOurs) {
      const { cause } = doc;
      const segments = doc.segments.map((one) => `${one.start_s} ${one.label} ${one.kept}`).join();
      const changed = segments !== segmentsSeen;
      segmentsSeen = segments;
      const own = cause && isOurs(cause) ? sent.get(cause.event) : undefined;
      if (!own) return;
      // Moves that were overtaken by a newer one are not answered any more.
      for (const event of sent.keys()) if (event <= cause.event) sent.delete(event);
      finish(cause.event, own.at, own.source, changed);
    },
  };
}
