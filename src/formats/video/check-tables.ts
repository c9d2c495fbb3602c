import { VolumeViewError } from '../../core/errors.ts';

/** Boxes of an MP4 that hold boxes, on the way to the tables of its frames. Source: ISO/IEC 14496-12 */
const holders = new Set(['moov', 'trak', 'mdia', 'minf', 'stbl']);

/** Depth of `holders` in each other, in a file that is sound. */
const maxDepth = 5;

/**
 * Tables with numbers of frames: bytes before the entries (version, flags, how many there are), bytes of an entry, where in it the number is, and
 * its maximum. mediabunny counts all frames of a chunk for each frame, and all frames of the other two once.
 */
const tables: Readonly<Record<string, readonly [skip: number, entry: number, at: number, max: number]>> = {
  stsc: [8, 12, 4, 2 ** 16],
  stts: [8, 8, 0, 2 ** 20],
  ctts: [8, 8, 0, 2 ** 20],
};

/** Tracks of a file: a film has a picture, some languages and some subtitles. mediabunny makes the table of each of them. */
const maxTracks = 32;

/**
 * Checks the numbers of an MP4 over which mediabunny 1.61 loops without a limit, and how many tables it makes. Damaged boxes end the walk:
 * mediabunny says what is wrong.
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`
 */
export function checkTables(bytes: Uint8Array<ArrayBuffer>): void {
  const tracks = walk(new DataView(bytes.buffer, bytes.byteOffset, bytes.length), [0, bytes.length], 0);
  if (tracks > maxTracks)
    throw new VolumeViewError(
      'format/too-large',
      `the video got ${tracks.toLocaleString('en')} tracks; expected at most ${maxTracks}`,
    );
}

/** @returns the number of tracks */
function walk(view: DataView, [start, end]: readonly [number, number], depth: number): number {
  let tracks = 0;
  for (let at = start; at + 8 <= end;) {
    const name = String.fromCharCode(...[4, 5, 6, 7].map((i) => view.getUint8(at + i)));
    const short = view.getUint32(at);
    const isLong = short === 1 && at + 16 <= end;
    const size = isLong ? Number(view.getBigUint64(at + 8)) : short === 0 ? end - at : short;
    const head = isLong ? 16 : 8;
    if (size < head) break;
    const inside = [at + head, Math.min(end, at + size)] as const;
    if (name === 'trak') tracks++;
    if (holders.has(name) && depth < maxDepth) tracks += walk(view, inside, depth + 1);
    if (Object.hasOwn(tables, name)) checkTable(view, inside, tables[name]);
    at += size;
  }
  return tracks;
}

function checkTable(
  view: DataView,
  [start, end]: readonly [number, number],
  [skip, entry, place, max]: (typeof tables)[string],
): void {
  let sum = 0;
  for (let at = start + skip; at + entry <= end; at += entry) {
    sum += view.getUint32(at + place);
    if (sum > max && (entry === 8 || view.getUint32(at + place) > max))
      throw new VolumeViewError(
        'format/corrupt',
        `the video got ${sum.toLocaleString('en')} frames in one of its tables; expected at most ${max.toLocaleString('en')}`,
      );
  }
}
