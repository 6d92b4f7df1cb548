/**
 * The curves of the stretch in view. The whole recording is fetched once, coarse; the stretch in
 * view follows, fine, a moment after it stops moving. Panning therefore never shows nothing.
 *
 * @typedef {import("./types.js").Signals} Signals
 * @typedef {import("./types.js").View} View
 */

const SETTLE_MS = 40;
/** How much is fetched to either side of the view, so that a short pan needs no request. */
const MARGIN = 0.5;
const LENS_TRACKS = ["force", "error", "speed"];

/**
 * @param {ArrayBuffer} frame
 * @returns {{request: number, id: string, signals: Signals}}
 */
export function parseSignals(frame) {
  const length = new DataView(frame).getUint32(0, true);
  /** @type {import("../messages/signals_frame").SignalsHeader} */
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(frame, 4, length)));
  let offset = 4 + length;
  /** @param {number} rows */
  const take = (rows) => {
    const values = new Float64Array(frame.slice(offset, offset + 8 * rows));
    offset += 8 * rows;
    return values;
  };
  /** @type {import("./types.js").Signals["tracks"]} */
  const tracks = new Map();
  for (const { name, series } of header.tracks) {
    const read = series.map(({ key, rows }) => ({ key, times: take(rows), values: take(rows) }));
    tracks.set(name, { name, series: read });
  }
  const signals = { from: header.from_s, to: header.to_s, tracks };
  return { request: header.request, id: header.id, signals };
}

/**
 * @param {import("../lib/store.js").Store} store
 * @param {import("./types.js").Send} send
 * @param {() => string[]} tracksShown names of the tracks that need curves
 */
export function createSignals(store, send, tracksShown) {
  let number = 0;
  let timer = 0;
  /** @type {Map<number, {id: string, as: "whole"|"fine"|"lens"}>} */
  const pending = new Map();
  let fetchedFor = "";

  function request(from, to, width, as, tracks) {
    const { document: doc } = store.state;
    number += 1;
    pending.set(number, { id: doc.id, as });
    const sent = send({ type: "signals", request: number, tracks, from_s: from, to_s: to, width });
    if (!sent) pending.delete(number);
  }

  function fetchWhole() {
    const { document: doc, plotWidth } = store.state;
    if (!doc || !plotWidth) return;
    const tracks = tracksShown();
    const key = `${doc.id} ${tracks.join()} ${store.state.connected}`;
    if (key === fetchedFor) return;
    fetchedFor = key;
    request(doc.start_s, doc.end_s, Math.ceil(plotWidth), "whole", tracks);
  }

  function fetchView() {
    const { document: doc, view, plotWidth } = store.state;
    if (!doc || !view || !plotWidth) return;
    const margin = MARGIN * (view.to - view.from);
    const from = Math.max(doc.start_s, view.from - margin);
    const to = Math.min(doc.end_s, view.to + margin);
    if (from === doc.start_s && to === doc.end_s && isWhole(view, doc)) return;
    request(
      from,
      to,
      Math.ceil((plotWidth * (to - from)) / (view.to - view.from)),
      "fine",
      tracksShown(),
    );
  }

  return {
    /** Asks for what the view needs, once it has come to rest. */
    follow() {
      fetchWhole();
      clearTimeout(timer);
      timer = setTimeout(fetchView, SETTLE_MS);
    },
    /** Fetches everything again: another recording, or parameters that change a curve. */
    refresh() {
      fetchedFor = "";
      this.follow();
    },
    /** The short stretch under the lens, one request at a time. */
    look(window, width) {
      const waiting = [...pending.values()].some(({ as }) => as === "lens");
      if (!waiting && window.to > window.from)
        request(window.from, window.to, width, "lens", LENS_TRACKS);
    },
    /** @param {ArrayBuffer} frame */
    receive(frame) {
      const { request: answered, id, signals } = parseSignals(frame);
      const asked = pending.get(answered);
      pending.delete(answered);
      if (!asked || id !== store.state.document?.id) return;
      store.set({ [asked.as]: signals });
    },
  };
}

/** @param {import("./types.js").Doc} doc */
function isWhole(view, doc) {
  return view.from <= doc.start_s && view.to >= doc.end_s;
}

/**
 * The best curves at hand for a view.
 * @param {import("../lib/store.js").State} state
 * @param {string} track
 * @returns {import("./types.js").TrackSignals|undefined}
 */
export function curvesOf(state, track) {
  const { fine, whole, view } = state;
  const fits = fine && fine.from <= view.from && fine.to >= view.to && fine.tracks.has(track);
  const finer = fits && whole && fine.to - fine.from < 0.999 * (whole.to - whole.from);
  return (finer || (fits && !whole) ? fine : whole)?.tracks.get(track);
}

/**
 * The value of a series at a time, interpolated; NaN outside.
 * @param {import("./types.js").Series} series
 * @param {number} time
 */
export function valueAt({ times, values }, time) {
  const right = upperBound(times, time);
  if (right === 0 || times.length === 0) return NaN;
  if (right === times.length) return time === times[right - 1] ? values[right - 1] : NaN;
  const share = (time - times[right - 1]) / (times[right] - times[right - 1]);
  return values[right - 1] + share * (values[right] - values[right - 1]);
}

/** Index of the first element greater than `value`. */
export function upperBound(times, value) {
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] > value) high = middle;
    else low = middle + 1;
  }
  return low;
}
