/**
 * What the page calls the values that travel (messages/, made of the server's structs), and what it
 * makes of them. Times are seconds.
 *
 * @typedef {import("../messages/messages").Message} Message
 * @typedef {import("../messages/document_messages").DocumentMessage} Doc
 * @typedef {import("../messages/document_messages").BoundaryMessage} Boundary
 * @typedef {import("../messages/document_messages").SegmentMessage} Segment
 * @typedef {import("../messages/document_messages").CandidateMessage} Candidate
 * @typedef {import("../messages/document_messages").PlanEntryMessage} PlanEntry
 * @typedef {Omit<import("../messages/document_messages").PlayheadMessage, "type">} Playhead
 * @typedef {import("../messages/list_messages").RecordingLine} Recording
 * @typedef {import("../messages/replay_messages").ReplayMessage} Replay
 * @typedef {import("../messages/replay_messages").SkillMessage} Skill
 * @typedef {import("../messages/edits").Edit} Edit
 * @typedef {Boundary["origin"]} Origin
 *
 * A request as a part of the page makes it: which recording and revision it is about is added.
 * @typedef {import("../messages/requests").Request} Request
 * @typedef {Request extends infer R ? R extends {recording: string}
 *   ? Omit<R, "recording"|"revision"> & {recording?: string} : R : never} Asked
 * @typedef {(message: Asked) => boolean} Send
 *
 * @typedef {{key: string, times: Float64Array, values: Float64Array}} Series
 * @typedef {{name: string, series: Series[]}} TrackSignals
 * @typedef {{from: number, to: number, tracks: Map<string, TrackSignals>}} Signals
 *
 * @typedef {{from: number, to: number}} View  the stretch of time in view
 */

export {};
