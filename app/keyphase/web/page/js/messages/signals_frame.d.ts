// Made by `make protocol` from the structs in app/keyphase: change those.

/**
 * The head of a binary frame: which request it answers, and which curves follow.
 * - request: number of the request
 * - id: the recording
 * - from_s, to_s: the stretch that was asked for
 */
export interface SignalsHeader {
  type: "signals";
  request: number;
  id: string;
  from_s: number;
  to_s: number;
  tracks: TrackHeader[];
}

/** The curves of one track, in the order in which they follow. */
export interface TrackHeader {
  name: string;
  series: SeriesHeader[];
}

/** One curve: its name, and how many times and values follow. */
export interface SeriesHeader {
  key: string;
  rows: number;
}
