/**
 * What travels between page and server (docs/protocol.md), as types. Times are seconds.
 *
 * @typedef {"position"|"force"|"both"|"user"} Origin
 *
 * @typedef {{name: string, value: number, unit: string, axis: string|null}} Step
 * @typedef {{sentences: string[], height: number|null, times_threshold: number|null,
 *   position_s: number|null, steps: Step[]}} Why
 * @typedef {{time_s: number, origin: Origin, interval_s: [number, number], confidence: number,
 *   contact_change: boolean, was_s: number|null, accepted: boolean, at_m: number[]|null, why: Why}} Boundary
 * @typedef {{start_s: number, end_s: number, label: string, proposed: boolean, kept: boolean,
 *   idle: boolean, color: number, end_condition: Object<string, *>, short: string[],
 *   middle_m: number[]}} Segment
 * @typedef {{time_s: number, kind: "contact"|"motion", probability: number, given: boolean,
 *   why_not: string}} Candidate
 * @typedef {{time_s: number, bin_time_s: number, height: number, rejection: string}} Peak
 * @typedef {{time_s: number, segment: number, repeat: number, connect_mm: number|null}} PlanEntry
 *
 * @typedef {{revision: number, cause: ?{event: number, client: string}, id: string, name: string,
 *   folder: string, start_s: number, end_s: number, rate_hz: number, channels: string[],
 *   force_channels: number, edits: number, notices: string[], parameters: Object<string, *>,
 *   threshold: number|null, automatic_threshold: number|null,
 *   motion_threshold?: number|null, automatic_motion_threshold?: number|null, boundaries: Boundary[],
 *   segments: Segment[], peaks: Peak[], candidates?: Candidate[], gaussians: Object[], plan: PlanEntry[],
 *   proposed_drops: number[], inapplicable: {edit: Object, text: string}[],
 *   selected: number|null, undo: string|null, redo: string|null, saved_at: string|null,
 *   greatest_step_N?: number|null,
 *   labels: {name: string, color: string}[],
 *   state: "automatic"|"touched"|"done", locked: string|null, changed: boolean,
 *   elsewhere?: {name: string, steps: number, done: boolean}|null}} Doc
 *
 * @typedef {{id: string, name: string, color: string}} OtherPage  who else is at a recording
 * @typedef {{id: string, name: string, folder?: string, pages?: OtherPage[],
 *   state: "automatic"|"touched"|"done",
 *   confidence: number|null, strip: {share: number, color: number|null}[],
 *   error: string|null}} Recording
 *
 * @typedef {{key: string, times: Float64Array, values: Float64Array}} Series
 * @typedef {{name: string, series: Series[]}} TrackSignals
 * @typedef {{from: number, to: number, tracks: Map<string, TrackSignals>}} Signals
 *
 * @typedef {{time_s: number, playing: boolean, speed: number, loop: boolean}} Playhead
 * @typedef {{from: number, to: number}} View  the stretch of time in view
 *
 * @typedef {{type: string} & Object<string, *>} Message
 */

export {};
