/** The panel at the right: parameters, recording, replay and export, one tab each. */

import { byId, el } from "../../lib/dom.js";
import { createExportTab } from "./export_tab.js";
import { createRecordTab } from "./record_tab.js";
import { createReplayTab } from "./replay_tab.js";
import { createSegmentTab } from "./segment_tab.js";

const STEPS = { ArrowLeft: -1, ArrowRight: 1 };

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createPanel(store, actions) {
  const tabs = [
    { key: "segment", title: "Segment", body: createSegmentTab(store, actions) },
    { key: "record", title: "Record", body: createRecordTab(store, actions) },
    { key: "replay", title: "Replay", body: createReplayTab(store, actions) },
    { key: "export", title: "Export", body: createExportTab(store, actions) },
  ].map((tab) => ({ ...tab, head: head(tab), page: pageOf(tab) }));
  const heads = el("div", { class: "tabs", role: "tablist", "aria-label": "Panel" });
  heads.append(...tabs.map((tab) => tab.head));
  byId("panel").append(heads, ...tabs.map((tab) => tab.page));

  const show = (key) => store.set({ tab: key });
  for (const { key, head: node } of tabs) node.addEventListener("click", () => show(key));
  heads.addEventListener("keydown", (event) => {
    const at = tabs.findIndex(({ key }) => key === store.state.tab);
    const to =
      { Home: 0, End: tabs.length - 1 }[event.key] ??
      (STEPS[event.key] ? at + STEPS[event.key] : null);
    if (to === null) return;
    event.preventDefault();
    event.stopPropagation();
    const next = tabs.at(to % tabs.length);
    show(next.key);
    next.head.focus();
  });
  function draw({ tab: shown, lookingOnly }) {
    for (const { key, head: node, page } of tabs) {
      const on = key === shown;
      node.setAttribute("aria-selected", String(on));
      node.tabIndex = on ? 0 : -1;
      page.hidden = !on;
      node.hidden = lookingOnly && key !== "segment";
    }
  }
  draw(store.state);
  store.on(["tab", "lookingOnly"], draw);
}

function head({ key, title }) {
  return el("button", {
    type: "button",
    role: "tab",
    id: `tab-${key}`,
    "aria-controls": `tab-page-${key}`,
    text: title,
  });
}

function pageOf({ key, body }) {
  return el(
    "div",
    {
      class: "tab-page",
      role: "tabpanel",
      id: `tab-page-${key}`,
      "aria-labelledby": `tab-${key}`,
      tabindex: -1,
    },
    body,
  );
}
