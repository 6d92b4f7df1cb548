/** Dragging a line over the evidence. */

import { automaticValue } from "../../model/parameters.js";

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} timeline
 * @param {any} actions
 * @param {string} parameter
 * @param {import("../hand/gestures.js").Point} start
 * @returns {import("../hand/gestures.js").Gesture}
 */
export function dragLine(store, timeline, actions, parameter, start) {
  const { document: doc } = store.state;
  const before = doc.parameters[parameter];
  const automatic = automaticValue(doc, {}, parameter);
  const offset = timeline.lineY(parameter) - start.y;
  const tell = ({ y, event }, held) =>
    actions.setParameter(parameter, timeline.lineValue(automatic, y + offset), held, event, "line");
  return {
    cursor: "ns-resize",
    move: (point) => tell(point, true),
    end: (point, moved) => moved && tell(point, false),
    cancel: () => actions.setParameter(parameter, before, false),
  };
}
