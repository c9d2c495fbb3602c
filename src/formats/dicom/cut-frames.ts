// Some frames of a file as a file of their own, which a browser keeps without a copy of the others.
import type { FramesOfFile } from '../base/scan-data.ts';
import { unsupportedFile } from '../base/file-problem.ts';
import { fragmentsOf, frameBytes, isInPairs } from './decode-frame.ts';
import type { Picture } from './picture.ts';

/**
 * @param picture - with its pixels
 * @returns what makes a file of some of its frames, in their order. It says of itself what the whole one does: also how many frames
 * that has. Of a deflated file it is what was unpacked.
 * @throws {VolumeViewError} `format/corrupt` where the file does not say where a frame begins, `format/unsupported` where two frames share a pair of bytes
 */
export function cutFrames(picture: Picture): (frames: readonly number[]) => FramesOfFile {
  const { set, pixels } = picture;
  const whole = new Blob([set.bytes]);
  const take = ({ byteOffset, byteLength }: Uint8Array): Blob => {
    const start = byteOffset - set.bytes.byteOffset;
    return whole.slice(start, start + byteLength);
  };
  const head = whole.slice(0, pixels.start);
  const { bytes } = pixels;
  const size = frameBytes(picture);
  if (isInPairs(picture) && size % 2 === 1)
    throw unsupportedFile(
      picture.what,
      'has several times in frames of an odd number of bytes, in words of big endian; convert it: gdcmconv --raw in.dcm out.dcm',
    );
  return (frames) => ({
    frames,
    file: new Blob([
      head,
      ...(bytes
        ? joinRuns(frames).map(([first, end]) => take(bytes.subarray(first * size, end * size)))
        : [startItem(0), ...frames.flatMap((frame) => asItem(fragmentsOf(picture, frame)))]),
    ]),
  });

  function asItem(fragments: readonly Uint8Array[]): (Blob | Uint8Array<ArrayBuffer>)[] {
    return [startItem(fragments.reduce((sum, { length }) => sum + length, 0)), ...fragments.map(take)];
  }
}

/** Frames that lie one after another, from the first one up to another. */
function joinRuns(frames: readonly number[]): [first: number, end: number][] {
  const runs: [first: number, end: number][] = [];
  for (const frame of frames) {
    const last = runs.at(-1);
    if (last?.[1] === frame) last[1]++;
    else runs.push([frame, frame + 1]);
  }
  return runs;
}

/** The eight bytes before a piece of packed pixels. Source: DICOM PS3.5, 7.5 and A.4 */
function startItem(length: number): Uint8Array<ArrayBuffer> {
  const view = new DataView(new ArrayBuffer(8));
  view.setUint16(0, 0xfffe, true);
  view.setUint16(2, 0xe000, true);
  view.setUint32(4, length, true);
  return new Uint8Array(view.buffer);
}
