/** What stands left of the rows that never scroll: their names, counts and buttons. */

import { el } from "../lib/dom.js";
import { fold } from "../model/rows.js";
import { createLaneNames } from "./lanes/arms.js";
import { createComparisonGutter } from "./lanes/comparison.js";
import { createGutter } from "./gutter.js";

/**
 * @param {HTMLElement} pane
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 * @returns {Map<string, any>} by the row's key
 */
export function createHeadGutters(pane, store, actions) {
  const rows = [
    { key: "overview", title: "Whole recording", foldable: false },
    { key: "ruler", title: "Time, s", foldable: false },
    { key: "boundaries", title: "Boundaries" },
    { key: "skills", title: "Skills", foldable: false },
    { key: "segments", title: "Segments" },
    { key: "lanes", title: "", foldable: false },
    { key: "events", title: "Events", foldable: false },
    { key: "cameras", title: "Camera" },
    { key: "comparison", title: "Compared", foldable: false },
  ];
  const gutters = new Map(
    rows.map((row) => [row.key, createGutter(row, (key) => fold(store, key))]),
  );
  for (const { node } of gutters.values()) pane.append(node);
  const segments = gutters.get("segments");
  const accept = el("button", {
    type: "button",
    class: "link",
    on: { click: actions.acceptNames },
  });
  segments.body.append(accept);
  let told = { segments: null, small: false, readOnly: false };
  segments.describe = (doc) => {
    const { small, readOnly } = store.state;
    if (told.segments === doc.segments && told.small === small && told.readOnly === readOnly)
      return;
    told = { segments: doc.segments, small, readOnly };
    const kept = doc.segments.filter((segment) => segment.kept).length;
    segments.small.textContent = small
      ? String(doc.segments.length)
      : `${doc.segments.length}, ${kept} kept`;
    const proposed = doc.segments.filter((segment) => segment.kept && segment.proposed).length;
    accept.hidden = proposed === 0 || readOnly;
    accept.textContent = `Accept ${proposed} ${proposed === 1 ? "name" : "names"}`;
  };
  const lanes = gutters.get("lanes");
  lanes.describe = createLaneNames(lanes, actions);
  const compared = gutters.get("comparison");
  compared.describe = createComparisonGutter(compared, store, actions);
  return gutters;
}
