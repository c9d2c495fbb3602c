import { expect } from '@esm-bundle/chai';
import { Budget } from '../../../../src/formats/base/budget.ts';
import { openVideo } from '../../../../src/formats/video/open-video.ts';
import { playFrame } from '../../../../src/formats/video/play-frame.ts';
import { readFrame } from '../../../../src/formats/video/read-frame.ts';
import { countFrames } from '../../../../src/formats/video/video-table.ts';
import type { VideoTable } from '../../../../src/formats/video/video-table.ts';
import { expectError, fetchFixture } from '../../../helpers/decode.ts';

/** What ffmpeg's decoder gives, see make-video-fixtures.py; the version stands in the file. */
interface Expected {
  readonly version: string;
  readonly width: number;
  readonly height: number;
  readonly files: Readonly<
    Record<string, { readonly bits: number; readonly frames: readonly { sha256: string; start: number[] }[] }>
  >;
}

const expected = JSON.parse(new TextDecoder().decode(await fetchFixture('video-fixtures.json'))) as Expected;

const budgetOf = (video: VideoTable): Budget => Budget.ofFile(video.bytes);

async function open(
  name: string,
  change = (bytes: Uint8Array<ArrayBuffer>) => bytes,
  canDecode = true,
): Promise<VideoTable> {
  const bytes = change(await fetchFixture(`video/${name}`));
  return openVideo(bytes, Budget.ofFile(bytes.length), canDecode);
}

async function hash(data: ArrayBufferView<ArrayBuffer>): Promise<string> {
  const bytes = new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
  return Array.from(new Uint8Array(await crypto.subtle.digest('SHA-256', bytes)), (byte) =>
    byte.toString(16).padStart(2, '0'),
  ).join('');
}

describe('frames of a video', () => {
  for (const [name, { bits, frames }] of Object.entries(expected.files)) {
    it(`${name}: the brightness of each frame is that of ffmpeg's decoder, to the bit`, async () => {
      const video = await open(name);
      expect(countFrames(video)).to.equal(frames.length);
      // From the last to the first, so that none is right only because it follows another.
      for (let frame = frames.length - 1; frame >= 0; frame--) {
        const image = await readFrame(video, frame, { budget: budgetOf(video) });
        expect([image.width, image.height, 8 * image.data.BYTES_PER_ELEMENT]).to.deep.equal([
          expected.width,
          expected.height,
          bits,
        ]);
        expect(Array.from(image.data.subarray(0, 8)), `frame ${frame}`).to.deep.equal(frames[frame].start);
        expect(await hash(image.data), `frame ${frame}`).to.equal(frames[frame].sha256);
      }
    });
  }

  it('the frame asked for is the frame that comes, 200 times at random, and nothing stays open', async () => {
    const video = await open('seek.webm');
    const isOpen = new Set<VideoFrame>();
    const { close, copyTo } = VideoFrame.prototype;
    VideoFrame.prototype.copyTo = function (...args) {
      isOpen.add(this);
      return copyTo.apply(this, args);
    };
    VideoFrame.prototype.close = function () {
      isOpen.delete(this);
      close.call(this);
    };
    try {
      let state = 41;
      for (let turn = 0; turn < 200; turn++) {
        state = (state * 1103515245 + 12345) % 2 ** 31;
        const frame = (state >> 8) % 60;
        const { data } = await readFrame(video, frame, { budget: budgetOf(video) });
        expect([data[0], data.at(-1)], `turn ${turn}, frame ${frame}`).to.deep.equal([
          (frame * 37) % 256,
          (frame * 37) % 256,
        ]);
      }
      expect(isOpen.size).to.equal(0);
    } finally {
      Object.assign(VideoFrame.prototype, { close, copyTo });
    }
  }).timeout(10_000);

  it('a table that went to a page and back gives the same', async () => {
    const video = structuredClone(await open('h264-later-first.mp4'));
    const { data } = await readFrame(video, 7, { budget: budgetOf(video) });
    expect(await hash(data)).to.equal(expected.files['h264-later-first.mp4'].frames[7].sha256);
  });

  it('the player of the page gives the same numbers of a video of full range, others of one that does not say it, and words for both', async () => {
    for (const [name, most, words] of [
      ['vp9-lossless.webm', 1, /^details: .*WebCodecs/],
      ['av1-lossy.mp4', 1, /^details: .*WebCodecs/],
      ['h264-later-first.mp4', 1, /^details: .*WebCodecs/],
      ['vp9-limited.webm', 20, /^numbers .* up to 20 of 255/],
    ] as const) {
      const video = await open(name, undefined, false);
      const exact = await open(name);
      const off: number[] = [];
      for (const frame of [0, 11, 4]) {
        const played = await playFrame(video, frame, { budget: budgetOf(video) });
        const { data } = await readFrame(exact, frame, { budget: budgetOf(exact) });
        expect(played.left?.[0]).to.match(words);
        off.push(Math.max(...Array.from(data, (value, i) => Math.abs(value - played.data[i]))));
      }
      expect(Math.max(...off), `${name}: ${off.join(' ')}`).to.be.at.most(most);
    }
  });

  describe('are refused in words', () => {
    const codeOf = async (promise: Promise<unknown>): Promise<string> => (await expectError(promise)).code;

    it('a file that is none, an empty one, and one of another kind', async () => {
      expect(await codeOf(open('seek.webm', () => new Uint8Array(100)))).to.equal('format/unsupported');
      expect(await codeOf(open('seek.webm', () => new Uint8Array()))).to.equal('format/unsupported');
      const png = await fetchFixture('mosaic/gray-3x2.png');
      const error = await expectError(open('seek.webm', () => png));
      expect(error.message).to.match(/neither WebM nor MP4/);
    });

    it('a file that is cut: the frames before are shown, of the others words', async () => {
      for (const name of ['vp9-lossless.webm', 'vp9.mp4']) {
        const whole = await fetchFixture(`video/${name}`);
        for (let length = 8; length < whole.length; length += Math.ceil(whole.length / 60)) {
          let answer = 'opened';
          try {
            const video = await open(name, (bytes) => bytes.slice(0, length));
            for (let frame = 0; frame < countFrames(video); frame++)
              await readFrame(video, frame, { budget: budgetOf(video) });
          } catch (error) {
            answer = (error as { code?: string }).code ?? String(error);
          }
          expect(answer, `${name}, ${length} bytes`).to.be.oneOf([
            'opened',
            'format/corrupt',
            'format/unsupported',
            'format/too-large',
          ]);
        }
      }
    }).timeout(20_000);

    it('a codec that the browser lacks', async () => {
      const video = { ...(await open('seek.webm')), codec: 'hvc1.nothing' };
      const error = await expectError(readFrame(video, 0, { budget: budgetOf(video) }));
      expect(error.code).to.equal('format/unsupported');
      expect(error.message).to.contain('hvc1.nothing').and.to.contain('VP9');
    });

    it('frames of another size than the file says', async () => {
      const video = { ...(await open('seek.webm')), width: 32 };
      const error = await expectError(readFrame(video, 3, { budget: budgetOf(video) }));
      expect(error.code).to.equal('format/corrupt');
      expect(error.message).to.contain('64 x 48').and.to.contain('32 x 48');
    });

    it('no frame that can be decoded by itself', async () => {
      const video = await open('seek.webm');
      const error = await expectError(
        readFrame({ ...video, keys: new Uint8Array(video.keys.length) }, 3, { budget: budgetOf(video) }),
      );
      expect(error.code).to.equal('format/corrupt');
    });

    it('a load that is given up stops', async () => {
      const video = await open('seek.webm');
      const controller = new AbortController();
      const stop = readFrame(video, 11, {
        budget: budgetOf(video),
        onProgress: (done) => {
          if (done > 3) controller.abort();
          controller.signal.throwIfAborted();
        },
      });
      expect(await stop.catch((cause: unknown) => (cause as Error).name)).to.equal('AbortError');
    });
  });
});
