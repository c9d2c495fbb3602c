import { expect } from '@esm-bundle/chai';
import { Budget } from '../../../../src/formats/base/budget.ts';
import { openVideo } from '../../../../src/formats/video/open-video.ts';
import { countFrames } from '../../../../src/formats/video/video-table.ts';
import { expectError, fetchFixture } from '../../../helpers/decode.ts';

// What follows after it was opened needs a browser: test/browser/formats/video.

const open = (bytes: Uint8Array<ArrayBuffer>) => openVideo(bytes, Budget.ofFile(bytes.length), true);

/** 'opened', or the code of the error. */
const answerTo = (bytes: Uint8Array<ArrayBuffer>): Promise<string> =>
  open(bytes).then(
    () => 'opened',
    (error: { code?: string }) => error.code ?? 'none',
  );

const codes = ['opened', 'format/corrupt', 'format/unsupported', 'format/too-large'];

/** A file with other numbers in a table of an MP4. @param at - bytes after the name of the box */
async function withNumber(box: string, at: number, number: number): Promise<Uint8Array<ArrayBuffer>> {
  const bytes = (await fetchFixture('video/h264-later-first.mp4')).slice();
  const name = Array.from(box, (letter) => letter.charCodeAt(0));
  const place = bytes.findIndex((_, i) => name.every((letter, k) => bytes[i + k] === letter));
  new DataView(bytes.buffer).setUint32(place + 4 + at, number);
  return bytes;
}

describe('damaged videos', () => {
  it('have an answer wherever they are cut', async () => {
    for (const name of ['vp9-lossy.webm', 'vp9.mp4']) {
      const whole = await fetchFixture(`video/${name}`);
      for (let length = 0; length < whole.length; length++)
        expect(await answerTo(whole.slice(0, length)), `${name}, ${length} bytes`).to.be.oneOf(codes);
    }
  }).timeout(60_000);

  it('do not loop over numbers that no file has', async () => {
    for (const [box, at] of [
      ['stsc', 12],
      ['stts', 8],
      ['ctts', 8],
    ] as const) {
      const error = await expectError(open(await withNumber(box, at, 0xfffffff0)));
      expect(error.code, box).to.equal('format/corrupt');
      expect(error.message).to.contain('in one of its tables');
    }
    expect(countFrames(await open(await fetchFixture('video/h264-later-first.mp4')))).to.equal(12);
  });

  it('have no more tracks than a film has: the table of each takes memory', async () => {
    const bytes = await fetchFixture('video/h264-later-first.mp4');
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    const placeOf = (box: string): number =>
      bytes.findIndex((_, i) => Array.from(box).every((letter, k) => bytes[i + 4 + k] === letter.charCodeAt(0)));
    const [movie, track] = [placeOf('moov'), placeOf('trak')];
    const [inMovie, inTrack] = [view.getUint32(movie), view.getUint32(track)];
    const withTracks = (count: number): Uint8Array<ArrayBuffer> => {
      const all = new Uint8Array(bytes.length + (count - 1) * inTrack);
      all.set(bytes.subarray(0, track));
      for (let i = 0; i < count; i++) all.set(bytes.subarray(track, track + inTrack), track + i * inTrack);
      all.set(bytes.subarray(track + inTrack), track + count * inTrack);
      new DataView(all.buffer).setUint32(movie, inMovie + (count - 1) * inTrack);
      return all;
    };
    expect(await answerTo(withTracks(32))).to.be.oneOf(['opened', 'format/corrupt']);
    const { code, message } = await expectError(open(withTracks(33)));
    expect([code, message]).to.deep.equal(['format/too-large', 'the video got 33 tracks; expected at most 32']);
  });

  it('have an answer with other bytes in them, 2,000 times at random', async () => {
    let state = 41;
    const random = (below: number): number => {
      state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
      return Math.floor((state / 2 ** 32) * below);
    };
    const files = await Promise.all(
      ['seek.webm', 'vp9-lossy.webm', 'vp9.mp4', 'h264-later-first.mp4', 'av1-lossy.mp4'].map((name) =>
        fetchFixture(`video/${name}`),
      ),
    );
    for (let turn = 0; turn < 2000; turn++) {
      const bytes = files[random(files.length)].slice();
      for (let changes = 1 + random(6); changes > 0; changes--) {
        const at = random(Math.min(1200, bytes.length));
        bytes.fill([0, 255, random(256)][random(3)], at, at + 1 + random(2) * 3);
      }
      const cut = random(10) === 0 ? bytes.slice(0, random(bytes.length)) : bytes;
      expect(await answerTo(cut), `turn ${turn}`).to.be.oneOf(codes);
    }
  }).timeout(60_000);
});
