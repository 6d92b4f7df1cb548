/** What became of each skill of a replay: how it ended, how long it took, its largest force. */

import { el } from "../../lib/dom.js";
import { shorter } from "../../model/label_forms.js";
import { button, row } from "./fields.js";

const GOOD = ["reached", "contact"];

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createOutcomes(store, actions) {
  const hint = el("p", {
    class: "hint",
    text: "Run replays the plan: every kept segment, in its order.",
  });
  const body = el("tbody");
  const heads = ["Skill", "Outcome", "Time", "Peak"].map((text) =>
    el("th", { scope: "col", text }),
  );
  const table = el("table", { class: "outcomes" }, el("thead", {}, el("tr", {}, ...heads)), body);
  const verdict = el("p", { class: "verdict" });
  const keep = button("Open its recording", {
    hint: "Keep the replay as a recording and open it.",
    run: actions.replay.keep,
  });
  const leave = button("Close the replay", {
    hint: "Back to the demonstration.",
    run: actions.replay.leave,
  });
  const after = row(keep, leave);
  store.later(["replay", "readOnly", "greeted"], ({ replay, lookingOnly }) => {
    hint.hidden = Boolean(replay);
    table.hidden = !replay;
    after.hidden = replay?.phase !== "over";
    verdict.hidden = !replay?.outcome;
    keep.hidden = replay?.succeeded === null;
    keep.disabled = leave.disabled = lookingOnly;
    if (!replay) return;
    body.replaceChildren(...replay.skills.flatMap((skill, index) => rowOf(replay, skill, index)));
    verdict.textContent = replay.outcome ?? "";
    verdict.className = `verdict ${replay.succeeded ? "good" : "bad"}`;
  });
  return el("div", {}, hint, table, verdict, after);
}

/** @param {import("../../model/types.js").Replay} replay @param {import("../../model/types.js").Skill} skill @param {number} index */
function rowOf({ current, phase }, skill, index) {
  const running = index === current && phase !== "over";
  if (!skill.outcome && !running) return [];
  const kind = running ? "now" : GOOD.includes(skill.outcome) ? "good" : "bad";
  const took = skill.end_s === null ? "" : `${(skill.end_s - skill.start_s).toFixed(2)} s`;
  const peak = skill.peak_N === null ? "" : `${skill.peak_N.toFixed(1)} N`;
  const name = skill.segment === null ? "connect" : `${skill.segment + 1} ${shorter(skill)}`;
  return [
    el(
      "tr",
      {},
      el("td", { text: name, title: skill.label }),
      el("td", {
        class: kind,
        text: running ? phase : skill.outcome,
        title: running ? phase : skill.outcome,
      }),
      el("td", { class: "amount", text: took }),
      el("td", { class: "amount", text: peak }),
    ),
  ];
}
