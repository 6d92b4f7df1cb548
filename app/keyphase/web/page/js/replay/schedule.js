/**
 * When each skill of a replay ran, runs, or will run if all goes as demonstrated.
 *
 * @typedef {"done"|"running"|"waiting"} Progress
 * @typedef {{index: number, start: number, end: number, met: number|null, progress: Progress,
 *   good: boolean, skill: import("../model/types.js").Skill}} Slot
 */

const GOOD = ["reached", "contact"];

/**
 * @param {import("../model/types.js").Replay} replay
 * @param {number} now replay time
 * @returns {Slot[]}
 */
export function slotsOf(replay, now) {
  let end = 0;
  return replay.skills.map((skill, index) => {
    const done = skill.outcome !== null;
    const progress = done ? "done" : index === replay.current ? "running" : "waiting";
    const start = done ? skill.start_s : end;
    end = done ? skill.end_s : Math.max(start + skill.expected_s, progress === "running" ? now : 0);
    return {
      index,
      start,
      end,
      met: done ? (skill.met_s ?? skill.end_s) : null,
      progress,
      good: GOOD.includes(skill.outcome),
      skill,
    };
  });
}

/**
 * The stretch of time that is shown: the whole plan and what has been of it.
 * @param {Slot[]} slots
 */
export function viewOf(slots, now) {
  const end = Math.max(slots.at(-1)?.end ?? 1, now, 0.5);
  return { from: 0, to: 1.02 * end };
}

/** The skills of the plan without connecting moves. @param {Slot[]} slots */
export const planned = (slots) => slots.filter(({ skill }) => skill.segment !== null);

/** "contact 8.4 N", "reached", "timeout". @param {import("../model/types.js").Skill} skill */
export function outcomeText({ outcome, peak_N: peak }) {
  return outcome === "contact" ? `contact ${peak.toFixed(1)} N` : outcome;
}

/**
 * Which planned skill is on and how many there are: "skill 4 of 4".
 * @param {import("../model/types.js").Replay} replay
 */
export function placeText(replay) {
  const { skills, current, phase } = replay;
  const count = skills.filter(({ segment }) => segment !== null).length;
  // One that was stopped has not come to its end.
  const ended = skills.filter(
    ({ segment, outcome }) => segment !== null && outcome !== null && outcome !== "stopped",
  ).length;
  if (phase === "over" || current === null) return `${ended} of ${count} skills ended`;
  const place = skills.slice(0, current + 1).filter(({ segment }) => segment !== null).length;
  return skills[current].segment === null
    ? `connecting to skill ${place + 1} of ${count}`
    : `skill ${place} of ${count}`;
}

/**
 * How a replay that is over ended, in a word or two; the whole of it stands beside its plan.
 * @param {import("../model/types.js").Replay} replay
 */
export function endText({ succeeded, outcome }) {
  if (succeeded) return "succeeded";
  if (outcome === null) return "stopped before it moved";
  return outcome.startsWith("stopped by you") ? "stopped by you" : "failed";
}
