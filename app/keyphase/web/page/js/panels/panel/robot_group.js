/** Which tool follows the recording, and where the robot stands. */

import { button, choice, group, toggle } from "./fields.js";

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createRobotGroup(store, actions) {
  const arm = choice("Tool", "The tool that follows the recording.", (name) =>
    actions.robot({ arm: name }),
  );
  const move = toggle(
    "Move the robot",
    "Show arrows and arcs at the robot's base; where it is dragged to is kept.",
    (moving) => actions.robot({ moving }),
  );
  const place = button("Place automatically", {
    hint: "Forget where the robot was dragged to: leave it, or put it where it reaches more.",
    run: () => actions.robot({ place: "automatically" }),
  });
  const node = group("Robot", { open: false }, arm.node, move.node, place);
  store.later(["robot", "lookingOnly"], ({ robot, lookingOnly }) => {
    node.hidden = !robot;
    if (!robot) return;
    arm.show(
      robot.arms.map((name) => ({ value: name, text: name })),
      robot.arm,
    );
    move.show(robot.moving);
    for (const one of [arm, move]) one.disable(lookingOnly);
    place.disabled = lookingOnly;
  });
  return node;
}
