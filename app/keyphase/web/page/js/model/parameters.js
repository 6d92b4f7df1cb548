/**
 * The parameters a person may change, by the way of segmenting, and how their sliders run.
 *
 * @typedef {"linear"|"decades"|"odds"} Course  how a slider's way is divided; thresholds over a
 *   probability run in its log-odds, those over the normalized error in decades
 * @typedef {{kind: "number", name: string, title: string, hint: string, low: number, high: number,
 *   step: number, course: Course}} NumberField
 * @typedef {{kind: "choice", name: string, title: string, hint: string,
 *   options: {value: string, text: string}[]}} ChoiceField
 * @typedef {NumberField|ChoiceField} Field
 * @typedef {{title: string, channel?: string, fields: Field[]}} Group  `channel`: what a recording
 *   must have for the group to do anything
 */

/** As many Gaussians can be chosen; more can be given by a file. */
const MOST_GAUSSIANS = 15;

/** @returns {NumberField} */
const number = (name, title, [low, high, step], hint, course = "linear") => ({
  kind: "number",
  name,
  title,
  hint,
  low,
  high,
  step,
  course: /** @type {Course} */ (course),
});

/** @returns {ChoiceField} */
const choice = (name, title, options, hint) => ({ kind: "choice", name, title, options, hint });
const option = (value, text) => ({ value, text });

const VARIANT = choice(
  "variant",
  "Method",
  [option("evidence", "evidence"), option("paper", "as published")],
  "evidence: one probability for every boundary. as published: the two methods of the paper.",
);

const DISTANCE = number(
  "min_distance_s",
  "Min. distance, s",
  [0, 2, 0.01],
  "Least time between two contact changes.",
);

const TOLERANCE = number(
  "merge_tolerance_s",
  "Tolerance, s",
  [0, 1, 0.01],
  "How far apart a force and a position boundary may be and still be one.",
);

/** @type {[number, number, number]} */
const PROBABILITIES = [0.00015, 0.99985, 0.00005];

/** How a threshold over a probability runs. */
export const PROBABILITY = number("", "", PROBABILITIES, "", "odds");

/** @type {Object<string, Group[]>} */
const GROUPS = {
  evidence: [
    {
      title: "Force",
      channel: "force",
      fields: [
        number(
          "force_threshold",
          "Threshold",
          PROBABILITIES,
          "Probability from which a contact change is one; more gives fewer boundaries.",
          "odds",
        ),
        number(
          "least_step_N",
          "Least step, N",
          [0, 20, 0.1],
          "A contact change alters the force by at least this much; by itself as much as the force " +
            "wanders while the tool rests and touches nothing.",
        ),
        DISTANCE,
      ],
    },
    {
      title: "Position",
      fields: [
        number(
          "motion_threshold",
          "Threshold",
          PROBABILITIES,
          "Probability from which a change of the motion is a boundary; more gives fewer.",
          "odds",
        ),
        choice(
          "turns",
          "Turns",
          [option("none", "none"), option("clear", "clear ones"), option("all", "all")],
          "Which turns of the path, taken without a halt, are boundaries.",
        ),
      ],
    },
    { title: "Combination", channel: "force", fields: [TOLERANCE] },
  ],
  paper: [
    {
      title: "Force",
      channel: "force",
      fields: [
        number(
          "force_threshold",
          "Threshold",
          [0.1, 1e5, 0.001],
          "Normalized error a peak must exceed; more gives fewer boundaries.",
          "decades",
        ),
        number(
          "force_ratio",
          "Ratio",
          [0, 100, 0.5],
          "How many times its running 2 s median a peak of the error must exceed.",
        ),
        DISTANCE,
        number(
          "persistence",
          "Persistence",
          [0, 20, 0.1],
          "How far the force must stay changed after a peak, in noise levels; bumps do not stay.",
        ),
      ],
    },
    {
      title: "Position",
      fields: [
        choice(
          "gaussians",
          "Gaussians",
          [
            option("", "automatic"),
            ...Array.from({ length: MOST_GAUSSIANS }, (_, k) => option(String(k + 1), `${k + 1}`)),
          ],
          "How many Gaussians the movement is described by; automatic: by the BIC.",
        ),
        choice(
          "mixture",
          "Mixture",
          [option("keyphase", "keyphase"), option("scikit-learn", "scikit-learn")],
          "keyphase: contiguous Gaussians without random starts. scikit-learn: as in the paper.",
        ),
        choice(
          "estimator",
          "Boundary at",
          [option("equal-distance", "equal distance"), option("weight-crossing", "equal weight")],
          "Where between two Gaussians a boundary lies: equally far from both in time, or where " +
            "the later one begins to weigh more.",
        ),
      ],
    },
    { title: "Combination", channel: "force", fields: [TOLERANCE] },
  ],
};

/** How the segments are found; it decides which other parameters there are. */
export const METHOD = VARIANT;

/**
 * The groups of parameters that do something for this recording.
 * @param {import("./types.js").Doc} doc
 * @returns {Group[]}
 */
export function parameterGroups({ parameters, channels }) {
  const groups = GROUPS[parameters.variant] ?? GROUPS.paper;
  return groups.filter(({ channel }) => !channel || channels.includes(channel));
}

/** Where on a slider's way (0 to 1) a value stands. @param {NumberField} field */
export function shareOf({ low, high, course }, value) {
  const run = COURSES[course].to;
  const share = (run(value) - run(low)) / (run(high) - run(low));
  return Math.min(Math.max(share, 0), 1);
}

/** The value at a place on the slider's way, as exact as a hand can place it. @param {NumberField} field */
export function valueAtShare({ low, high, step, course }, share) {
  const { to, from } = COURSES[course];
  const value = from(to(low) + share * (to(high) - to(low)));
  if (course === "linear") return Number((Math.round(value / step) * step).toPrecision(12));
  // Three digits of how far it is from the nearer end, which a probability has two of.
  if (course === "odds" && value > 0.5)
    return Number((1 - Number((1 - value).toPrecision(3))).toFixed(9));
  return Number(value.toPrecision(3));
}

const COURSES = {
  linear: { to: (value) => value, from: (value) => value },
  decades: { to: (value) => Math.log10(Math.max(value, 1e-12)), from: (value) => 10 ** value },
  odds: {
    to: (value) => {
      const inside = Math.min(Math.max(value, 1e-6), 1 - 1e-6);
      return Math.log(inside / (1 - inside));
    },
    from: (value) => 1 / (1 + Math.exp(-value)),
  },
};

/**
 * The automatic value of a parameter: what the recording gave where it is found anew for each,
 * else the default.
 * @param {import("./types.js").Doc} doc
 * @param {Object<string, *>} defaults
 * @param {string} name
 */
export function automaticValue(doc, defaults, name) {
  if (name === "force_threshold") return doc.automatic_threshold;
  if (name === "motion_threshold") return doc.automatic_motion_threshold;
  if (name === "least_step_N") return doc.automatic_least_step_N;
  return defaults[name] ?? null;
}

/**
 * What is in force: as it is being held, as it was set, or as it was found.
 * @param {import("./types.js").Doc} doc
 * @param {Object<string, *>} held
 * @param {string} name
 */
export function valueInForce(doc, held, name) {
  if (name in held) return held[name] ?? automaticValue(doc, {}, name);
  if (name === "force_threshold") return doc.threshold;
  if (name === "motion_threshold") return doc.motion_threshold;
  if (name === "least_step_N") return doc.parameters[name] ?? doc.automatic_least_step_N;
  return doc.parameters[name] ?? null;
}
