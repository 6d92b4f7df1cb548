// Made by `make protocol` from the structs in app/keyphase: change those.

/** A file was written; `reads_back` are three lines of Python that read it, or "". */
export interface Saved {
  type: "saved";
  path: string;
  reads_back: string;
}

/**
 * Files that were not replaced, since keyphase did not write them as they are.
 * - kind: of the export that met them; ask again with `if_there` "replace" or "keep both"
 */
export interface InTheWayMessage {
  type: "in_the_way";
  recording: string;
  kind: string;
  files: InTheWay[];
}

/** A file that would be replaced, and why that is asked first, for people. */
export interface InTheWay {
  name: string;
  whose: string;
}

/** The formats in which a recording can be written. */
export interface OffersMessage {
  type: "offers";
  recording: string;
  items: OfferLine[];
}

/**
 * A format as the recording can be written in it.
 * - file: the name of what it would become, from the folder of the recording
 * - not_carried: what of this recording it leaves behind
 * - remarks: what else a person should know
 * - reads_back: three lines of Python that read it
 * - refusal: why it cannot be written, or ""
 * - install: the command that brings what is missing, or ""
 * - copies: it is a copy of what was recorded
 * - trims: idle ends can be left out
 */
export interface OfferLine {
  name: string;
  title: string;
  file: string;
  not_carried: string[];
  remarks: string[];
  reads_back: string;
  refusal: string;
  install: string;
  copies: boolean;
  trims: boolean;
}
