/** The order in which the kept segments run. */

import { middle } from "../model/segments.js";

/**
 * @param {import("../lib/store.js").Store} store
 * @param {{edit: (change: import("../model/types.js").Edit) => void,
 *   onSegment: (action: (segment: import("../model/types.js").Segment, index: number) => void) => void}} given
 *   makes an edit; does something with the segment that is meant
 */
export function createPlanActions(store, { edit, onSegment }) {
  const own = {
    reorder: (order) => edit({ kind: "plan", order }),
    repeat: () =>
      onSegment((segment, index) => {
        const order = store.state.document.plan.map((entry) => entry.time_s);
        const at = store.state.document.plan.findLastIndex((entry) => entry.segment === index);
        order.splice(at < 0 ? order.length : at + 1, 0, middle(segment));
        own.reorder(order);
      }),
    takeOut: () =>
      onSegment((_, index) => {
        const at = store.state.document.plan.findLastIndex((entry) => entry.segment === index);
        if (at >= 0)
          own.reorder(
            store.state.document.plan.filter((_, k) => k !== at).map((entry) => entry.time_s),
          );
      }),
    shift: (direction) =>
      onSegment((_, index) => {
        const order = store.state.document.plan.map((entry) => entry.time_s);
        const at = store.state.document.plan.findIndex((entry) => entry.segment === index);
        const to = at + direction;
        if (at < 0 || to < 0 || to >= order.length) return;
        [order[at], order[to]] = [order[to], order[at]];
        own.reorder(order);
      }),
  };
  return own;
}
