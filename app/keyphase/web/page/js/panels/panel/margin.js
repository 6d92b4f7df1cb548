/** The margin: how far the world may differ until the plan fails. */

import { createBeside } from "./beside.js";

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createMargin(store, actions) {
  return createBeside(store, {
    title: "Margin",
    key: "margin",
    start: "Try the margin",
    hint:
      "How much higher, lower, aside, turned, rougher the world may be until the plan fails, " +
      "beside the same by pose alone and as one skill.",
    begin: () => actions.margin("begin"),
    cancel: () => actions.margin("cancel"),
    far: (run) => `${run.done} of ${run.count} directions`,
  });
}
