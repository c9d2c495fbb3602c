import { expect } from '@esm-bundle/chai';
import { windowFromHistogram } from '../../../src/optics/transfer/window.ts';
import { finishVolume, minForCoarse, minForMeans, maxCoarse } from '../../../src/formats/finish-volume.ts';
import { loadVolume } from '../../../src/worker/load.ts';
import type { CoarseVolume } from '../../../src/worker/load.ts';
import { cartesianGrid, corners } from '../../../src/volume/grid.ts';
import type { Matrix4, Vector3 } from '../../../src/volume/matrix.ts';
import type { Samples, Volume } from '../../../src/volume/volume.ts';
import { niftiBytes } from '../../helpers/nifti-bytes.ts';
import { roomyLimits } from '../../helpers/decode.ts';

const oblique: Matrix4 = [-1.5, 0.2, 0.1, 30, 0.3, 2, -0.4, -20, 0.05, 0.25, 3.5, 10, 0, 0, 0, 1];

/** A volume of a little more than `minForCoarse` bytes: a ramp along i, brighter with k. */
const dimensions: Vector3 = [161, 165, 162];
function makeRamp(): Uint8Array<ArrayBuffer> {
  const [nx, ny, nz] = dimensions;
  const samples = new Uint8Array(nx * ny * nz);
  for (let row = 0; row < ny * nz; row++) {
    const base = Math.floor((80 * row) / (ny * nz));
    for (let i = 0; i < nx; i++) samples[row * nx + i] = base + ((i * 160) >> 8);
  }
  return samples;
}

function decoded(samples: Samples, size: Vector3 = dimensions): Parameters<typeof finishVolume>[0] {
  return { grid: cartesianGrid(size, oblique), samples, slope: 2, intercept: -10, unit: 'HU', format: 'made' };
}

/** Bytes of all buffers that can be reached from a value, each counted once. */
function countHeldBytes(value: unknown, seen = new Set<unknown>()): number {
  if (typeof value !== 'object' || value === null || seen.has(value)) return 0;
  seen.add(value);
  if (ArrayBuffer.isView(value)) return countHeldBytes(value.buffer, seen);
  if (value instanceof ArrayBuffer) return value.byteLength;
  return Object.values(value).reduce((sum: number, part) => sum + countHeldBytes(part, seen), 0);
}

describe('the coarse volume of a large one', () => {
  const samples = makeRamp();
  let whole: Volume;
  let volume: CoarseVolume['volume'];
  let of: CoarseVolume['of'];

  before(async () => {
    whole = await finishVolume(decoded(samples), roomyLimits, (coarse) => ({ volume, of } = coarse));
  });

  it('is small, and says what it is', () => {
    expect(samples.byteLength).to.be.above(minForCoarse);
    expect(volume.coarse).to.equal(true);
    expect(volume.grid.dimensions).to.deep.equal([81, 83, 81]);
    expect(volume.grid.dimensions.reduce((product, n) => product * n, 1)).to.equal(volume.samples.length);
    expect(whole.coarse).to.equal(undefined);
  });

  it('lies where the large one lies', () => {
    corners(volume.grid).forEach((corner, c) =>
      corner.forEach((x, axis) => expect(x).to.be.closeTo(corners(whole.grid)[c][axis], 1e-9)),
    );
  });

  it('has the values of every other voxel', () => {
    const [nx, ny] = dimensions;
    for (const [i, j, k] of [
      [0, 0, 0],
      [80, 82, 80],
      [3, 40, 7],
    ]) {
      expect(volume.samples[(k * 83 + j) * 81 + i]).to.equal(samples[(2 * k * ny + 2 * j) * nx + 2 * i]);
    }
  });

  it('of a very large one is as small, and of means', async () => {
    const long: Vector3 = [4096, 4096, 3];
    const wide = Uint8Array.from({ length: 4096 * 4096 * 3 }, (_, i) => 200 * (i % 2));
    let made: CoarseVolume | undefined;
    await finishVolume(decoded(wide, long), roomyLimits, (it) => (made = it));
    expect(wide.byteLength).to.be.above(minForMeans);
    expect(made!.volume.samples[12345]).to.be.closeTo(100, 35);
    expect(made!.volume.samples.byteLength).to.be.within(maxCoarse / 4, maxCoarse);
  });

  it('gets the same colours: range, counts and so the window are those of the large one', () => {
    expect(volume.range).to.deep.equal(whole.range);
    expect(Array.from(volume.histogram.counts)).to.deep.equal(Array.from(whole.histogram.counts));
    expect(windowFromHistogram(volume.histogram)).to.deep.equal(windowFromHistogram(whole.histogram));
    expect(volume.hasNoData).to.equal(whole.hasNoData);
  });

  it('comes with all of the large one except what takes memory', () => {
    const { samples: _samples, macrocells: _macrocells, ...rest } = whole;
    expect(of).to.deep.equal(rest);
  });

  it('is not made of a small one', async () => {
    let made = 0;
    await finishVolume(decoded(new Uint8Array(1000), [10, 10, 10]), roomyLimits, () => made++);
    expect(made).to.equal(0);
  });

  it('is made of what the device holds where that is less', async () => {
    let reduced: CoarseVolume | undefined;
    const limits = { ...roomyLimits, maxVoxelsPerAxis: 164 };
    const smaller = await finishVolume(decoded(new Uint16Array(samples)), limits, (it) => (reduced = it));
    expect(smaller.reduced).to.deep.equal({ from: dimensions, to: [161, 83, 162] });
    expect(reduced!.of.reduced).to.deep.equal(smaller.reduced);
    expect(reduced!.volume.samples.byteLength).to.be.at.most(maxCoarse);
  });
});

describe('a large volume out of the worker', () => {
  const files: [string, Samples][] = [
    ['8 bits', makeRamp()],
    ['16 bits', Uint16Array.from(makeRamp(), (x) => 250 * x)],
  ];
  for (const [what, samples] of files) {
    it(`of ${what} comes after its coarse one, with its samples once and nothing else of size`, async () => {
      const made: Volume = await finishVolume({ ...decoded(samples), slope: 1, intercept: 0 }, roomyLimits);
      const url = URL.createObjectURL(new Blob([niftiBytes(made)]));
      const order: string[] = [];
      const reported: CoarseVolume[] = [];
      const { signal } = new AbortController();
      const onCoarse = (it: CoarseVolume | null): void => void (order.push('coarse'), reported.push(it!));
      const volume = await loadVolume({ url, limits: roomyLimits }, { signal, onProgress: () => {}, onCoarse });
      order.push('volume');
      URL.revokeObjectURL(url);
      expect(order).to.deep.equal(['coarse', 'volume']);
      expect(reported[0].volume.range).to.deep.equal(volume.range);
      expect(volume.samples.constructor).to.equal(samples.constructor);
      // What differs is not printed: millions of numbers help nobody.
      expect(
        volume.samples.length === samples.length && volume.samples.every((x, i) => x === samples[i]),
        'the samples',
      ).to.equal(true);
      // The file's own bytes, and so its header too.
      expect(volume.samples.buffer.byteLength - samples.byteLength).to.be.within(0, 352);
      const cells = countHeldBytes(volume.macrocells);
      expect((countHeldBytes(volume) - cells) / samples.byteLength).to.be.within(1, 1.005);
      expect(cells / samples.byteLength, 'macrocells').to.be.below(0.1);
    });
  }
});

describe('a radar out of the worker', () => {
  it('is reported as soon as its file is known for one, then all of it except its macrocells, in memory of its own, and then the volume', async () => {
    const reported: (CoarseVolume | null)[] = [];
    const phases: string[] = [];
    const { signal } = new AbortController();
    const volume = await loadVolume(
      { url: '/demos/data/storm-radar-1510.json', limits: roomyLimits },
      {
        signal,
        onProgress: ({ phase }) => void phases.push(`${reported.length} ${phase}`),
        onCoarse: (it) => void reported.push(it),
      },
    );
    expect(reported.length).to.equal(2);
    expect(reported[0], 'before its picture is fetched').to.equal(null);
    expect(phases).to.include('1 fetch');
    const { volume: foretold, of } = reported[1]!;
    expect(foretold.coarse).to.equal(true);
    expect(foretold.grid).to.deep.equal(volume.grid);
    expect(
      foretold.samples.length === volume.samples.length && foretold.samples.every((x, i) => x === volume.samples[i]),
      'the samples',
    ).to.equal(true);
    expect(foretold.macrocells.dimensions).to.deep.equal(volume.macrocells.dimensions);
    expect(
      foretold.macrocells.low.every((low, cell) => low > foretold.macrocells.high[cell]),
      'macrocells hold nothing',
    ).to.equal(true);
    expect(volume.macrocells.low.some((low, cell) => low <= volume.macrocells.high[cell])).to.equal(true);
    expect({ ...of, samples: null, macrocells: null }).to.deep.equal({ ...volume, samples: null, macrocells: null });
    expect('samples' in of).to.equal(false);
  });
});
