/** A video that was opened: where the packets of its frames lie. It is plain data, as a page keeps it and sends it back to the worker. */
export interface VideoTable {
  /** What WebCodecs calls the codec: 'vp09.00.10.08'. */
  readonly codec: string;
  /** What the codec's decoder has to know before the first packet. */
  readonly description?: Uint8Array<ArrayBuffer>;
  /** Pixels of every frame. */
  readonly width: number;
  readonly height: number;
  /** The packets one after another, in the order in which they are decoded; or, with `isFile`, the file. */
  readonly data: Blob;
  /** Set where there is no WebCodecs, and the page's own player has to show the file. */
  readonly isFile: boolean;
  /** Whether the file says that its numbers reach from 0 to 255. Only a player needs to know. */
  readonly isFullRange: boolean;
  /** Bytes of the file. */
  readonly bytes: number;
  /** Where each packet begins in `data`, and where the last one ends. */
  readonly starts: Float64Array<ArrayBuffer>;
  /** 1 for each packet that is decoded without those before it. */
  readonly keys: Uint8Array<ArrayBuffer>;
  /** The packet of each frame, in the order of time. */
  readonly packets: Uint32Array<ArrayBuffer>;
  /** When each frame is shown, seconds, ascending. */
  readonly times: Float64Array<ArrayBuffer>;
}

export const countFrames = ({ packets }: VideoTable): number => packets.length;

/** The packets that have to be decoded for a frame: from `first`, which needs none before it, to `last`, both included. */
export interface PacketRun {
  readonly first: number;
  readonly last: number;
}

/** @returns null where no packet before the frame can be decoded by itself */
export function findRun({ packets, keys }: VideoTable, frame: number): PacketRun | null {
  const last = packets[frame];
  const first = keys.lastIndexOf(1, last);
  return first < 0 ? null : { first, last };
}
