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

/** What has to be recorded for a part, which has no switch else. @type {Object<string, string>} */
const NEEDS = { forces: "force" };

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createShownParts(store, actions) {
  const toggles = PARTS.map(([what, title, hint]) => ({
    what,
    ...toggle(title, hint, (visible) => actions.show(what, visible)),
  }));
  store.later(["shown", "lookingOnly", "document"], ({ shown, lookingOnly, document: doc }) => {
    for (const one of toggles) {
      const needed = NEEDS[one.what];
      one.node.hidden = Boolean(doc && needed && !doc.channels.includes(needed));
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
