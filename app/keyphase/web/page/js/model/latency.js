/**
 * How long a person waits: from the input event that carried a value to the first frame of the
 * timeline that shows what the value did. The threshold line's own drag carries its number to the
 * server and back; a slider in viser's panel is matched by the value it showed when it was moved.
 *
 * Where the segments changed, the first frame of the 3D scene after that is timed as well.
 *
 * @typedef {"line"|"slider"|"edit"} Source
 * @typedef {{event: number, milliseconds: number, source: Source|"scene"}} Measurement
 */

const FORGET_MS = 5000;
const SCENE_WAIT_MS = 3000;
const SAME = 4e-3;

/** Whether a slider that shows `shown` set `value`; the threshold's slider counts in decades. */
function carries(shown, value) {
  return [shown, 10 ** shown].some((one) => Math.abs(one - value) <= SAME * Math.abs(value));
}

/**
 * @param {import("../lib/store.js").Store} store
 * @param {(message: import("./types.js").Message) => boolean} send
 * @param {() => number|undefined} sceneFrames how many frames the 3D scene has drawn
 */
export function createLatency(store, send, sceneFrames) {
  /** @type {Measurement[]} */
  const list = [];
  /** @type {Map<number, {at: number, source: Source}>} */
  const sent = new Map();
  /** @type {{at: number, value: number, event: number}[]} */
  let moved = [];
  let number = 0;
  let seen = { parameters: /** @type {Object<string, *>} */ ({}), id: "", segments: "" };

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

  /** The earliest input that carried this value and was not answered yet. */
  function inputFor(value) {
    const found = moved.find((input) => carries(input.value, value));
    if (found) moved = moved.filter((input) => input.at > found.at);
    return found;
  }

  return {
    list,
    /** Remembers an input of our own; its number travels with the message. */
    began(timeStamp, source) {
      number += 1;
      sent.set(number, { at: timeStamp, source });
      return number;
    },
    /** A slider of the panel showed a new value, on account of an input at `at`. */
    slid(value, at) {
      number += 1;
      moved = moved.filter((input) => at - input.at < FORGET_MS);
      moved.push({ at, value, event: number });
    },
    /** @param {import("./types.js").Doc} doc a document that is about to be drawn */
    arrived(doc, isOurs) {
      const { cause } = doc;
      const segments = doc.segments.map((one) => `${one.start_s} ${one.label} ${one.kept}`).join();
      const changed = segments !== seen.segments;
      const own = cause && isOurs(cause) ? sent.get(cause.event) : undefined;
      if (own) {
        sent.delete(cause.event);
        finish(cause.event, own.at, own.source, changed);
      } else if (!cause && doc.id === seen.id) {
        const names = Object.keys(doc.parameters).filter(
          (name) => doc.parameters[name] !== seen.parameters[name],
        );
        const input = names.length === 1 ? inputFor(Number(doc.parameters[names[0]])) : undefined;
        if (input) finish(input.event, input.at, "slider", changed);
      }
      seen = { parameters: doc.parameters, id: doc.id, segments };
    },
  };
}
