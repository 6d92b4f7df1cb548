/**
 * Of a path with many segments the scene draws what the timeline has in view: dozens of passes over
 * the same place say nothing together. A few are seen better whole, whatever one zooms to.
 */

/** Up to so many kept segments the whole path is drawn. */
const FEW = 10;
/** The scene follows once the hand has let go and the view has come to rest. */
const SETTLE_MS = 300;

/**
 * @param {import("../lib/store.js").Store} store
 * @param {import("../model/types.js").Send} send
 */
export function drawWhatIsInView(store, send) {
  let told = "";
  let timer = 0;
  store.later(["view", "document", "holding"], ({ view, document: doc, holding }) => {
    clearTimeout(timer);
    if (!view || !doc || holding) return;
    const { from, to } = seenInScene(view, doc);
    const now = `${doc.id} ${from} ${to}`;
    if (now === told || (told === "" && from === doc.start_s && to === doc.end_s)) return;
    timer = setTimeout(() => {
      if (send({ type: "in_view", recording: doc.id, from_s: from, to_s: to })) told = now;
    }, SETTLE_MS);
  });
}

/**
 * @param {import("../model/types.js").View} view
 * @param {import("../model/types.js").Doc} doc
 * @returns {{from: number, to: number}}
 */
export function seenInScene(view, doc) {
  const many = doc.segments.filter(({ kept }) => kept).length > FEW;
  return many ? view : { from: doc.start_s, to: doc.end_s };
}
