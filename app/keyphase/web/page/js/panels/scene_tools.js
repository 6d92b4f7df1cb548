/** Switches on the scene itself: the robot, and in a narrow window the panel and the list. */

import { hasFootage } from "../model/footage/frames.js";
import { byId, el, icon } from "../lib/dom.js";

/**
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 */
export function createSceneTools(store, actions) {
  const robot = tool("robot", "Robot", "Show the robot or not (B)", actions.toggleRobot);
  const panel = tool("panel", "Panel", "Parameters, record, replay and export", () =>
    store.set({ drawer: store.state.drawer === "panel" ? null : "panel" }),
  );
  const cameras = tool("camera", "Cameras", "Show the cameras or not (H)", actions.toggleCameras);
  const list = tool("queue", "Recordings", "The list of recordings", () =>
    store.set({ drawer: store.state.drawer === "queue" ? null : "queue" }),
  );
  list.classList.add("for-narrow");
  panel.classList.add("for-drawer");
  byId("scene").append(el("div", { class: "scene-tools" }, list, cameras, robot, panel));
  store.later(["shown", "lookingOnly", "document"], ({ shown, lookingOnly, document: doc }) => {
    robot.classList.toggle("on", Boolean(shown.robot));
    robot.setAttribute("aria-pressed", String(Boolean(shown.robot)));
    robot.hidden = lookingOnly || !doc;
  });
  store.on(["cameras", "camerasShown"], (state) => {
    cameras.hidden = !hasFootage({ ...state, camerasShown: true });
    cameras.classList.toggle("on", state.camerasShown);
    cameras.setAttribute("aria-pressed", String(state.camerasShown));
  });
  store.on(["drawer"], ({ drawer }) => {
    document.documentElement.dataset.drawer = drawer ?? "";
    panel.setAttribute("aria-expanded", String(drawer === "panel"));
    list.setAttribute("aria-expanded", String(drawer === "queue"));
  });
  store.on(["recording"], ({ drawer }) => drawer === "queue" && store.set({ drawer: null }));
}

function tool(symbol, name, title, run) {
  return el(
    "button",
    { type: "button", class: "boxed", title, "aria-label": name, on: { click: run } },
    icon(symbol),
  );
}
