/** What the scene shows, one switch each. */

import { el } from "../../lib/dom.js";
import { group, toggle } from "./fields.js";

const PARTS = [
  ["robot", "Robot", "The robot, its tool at the playhead."],
  ["labels", "Names", "Names of the segments."],
  ["forces", "Contact forces", "The change of force at each contact change."],
  ["gaussians", "Gaussians", "Ellipsoids of one standard deviation."],
  ["parts", "Parts", "The parts of the workcell it was recorded in."],
  ["frame", "Tool frame", "The tool at the playhead."],
  ["grid", "Ground", "The grid below the path."],
  ["spread", "Spread", "How far the finished recordings of this task lie apart along its way."],
  ["shadows", "Shadows", "Slow where there is no graphics card."],
];

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createShownParts(store, actions) {
  const toggles = PARTS.map(([what, title, hint]) => ({
    what,
    ...toggle(title, hint, (visible) => actions.show(what, visible)),
  }));
  store.later(["shown", "lookingOnly"], ({ shown, lookingOnly }) => {
    for (const one of toggles) {
      one.show(shown[one.what] ?? false);
      one.disable(lookingOnly);
    }
  });
  return group(
    "Show",
    { open: true },
    el("div", { class: "toggles" }, ...toggles.map(({ node }) => node)),
  );
}
