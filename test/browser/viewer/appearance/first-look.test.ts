import { expect } from '@esm-bundle/chai';
import { finishVolume } from '../../../../src/formats/finish-volume.ts';
import { readMosaic } from '../../../../src/formats/images/mosaic.ts';
import { detectNifti, readVersion1 } from '../../../../src/formats/nifti/nifti-header.ts';
import { readRareHeader } from '../../../../src/formats/nifti/nifti-rare-headers.ts';
import { parseTransferFunction } from '../../../../src/optics/transfer/parse-transfer-function.ts';
import { resolveTransferFunction } from '../../../../src/optics/transfer/resolve-transfer-function.ts';
import { evaluate } from '../../../../src/optics/transfer/transfer-function.ts';
import { plainAppearance } from '../../../../src/viewer/model/plain-appearance.ts';
import { resolveAppearance } from '../../../../src/viewer/appearance/resolve-appearance.ts';
import { axialIndexToWorld, cartesianGrid, edgeLengths } from '../../../../src/volume/grid.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import type { Samples, Volume } from '../../../../src/volume/volume.ts';
import { roomyLimits } from '../../../helpers/decode.ts';
import { evenAzimuths, radarVolume } from '../../../helpers/synthetic-radar.ts';

const size: Vector3 = [24, 20, 16];
const count = size[0] * size[1] * size[2];

/** Noise that is the same in each run, -1..1. */
function noise(i: number): number {
  const x = Math.sin(i * 12.9898) * 43758.5453;
  return 2 * (x - Math.floor(x)) - 1;
}

/** Distance from the middle, 1 at the nearest faces. */
function radiusAt(i: number): number {
  const place = [i % size[0], Math.floor(i / size[0]) % size[1], Math.floor(i / (size[0] * size[1]))];
  return Math.hypot(...place.map((x, axis) => (2 * x + 1) / size[axis] - 1));
}

interface Given {
  slope?: number;
  intercept?: number;
  unit?: string;
  isLabels?: boolean;
  intent?: number;
  window?: [number, number];
}

/** The volume that comes of samples, as a load gives it. */
function finish(
  samples: Samples,
  { slope = 1, intercept = 0, unit = '', ...rest }: Given = {},
  limits = roomyLimits,
): Promise<Volume> {
  const grid = cartesianGrid(size, axialIndexToWorld(size, [1, 1, 1]));
  return finishVolume({ grid, samples, slope, intercept, unit, format: 'test', ...rest }, limits);
}

const sampled = (valueAt: (i: number) => number): Float32Array<ArrayBuffer> =>
  Float32Array.from({ length: count }, (_, i) => valueAt(i));

/** Air, soft tissue and a bone in it. */
const headCt = (i: number): number => {
  const r = radiusAt(i);
  return Math.round((r > 0.8 ? -1000 : r > 0.7 ? 900 : 40) + 15 * noise(i));
};

describe('the first look', () => {
  it('knows Hounsfield units by their values, as they are and shifted, with what was not scanned below them', async () => {
    expect((await finish(sampled(headCt))).transferFunction).to.equal('ct-bone');
    const shifted = Uint16Array.from({ length: count }, (_, i) => headCt(i) + 1100);
    expect((await finish(shifted, { intercept: -1100 })).transferFunction).to.equal('ct-bone');
    expect((await finish(sampled((i) => (radiusAt(i) > 1.3 ? -3024 : headCt(i))))).transferFunction).to.equal(
      'ct-bone',
    );
  });

  it('takes no other values for Hounsfield units', async () => {
    const others = {
      'an MRI': (i: number) => Math.max(0, 600 * (1 - radiusAt(i)) + 20 * noise(i)),
      'a phase': (i: number) => 4096 * noise(i),
      'values of one sign': (i: number) => headCt(i) + 1100,
      'another range': (i: number) => headCt(i) / 10,
    };
    for (const [name, valueAt] of Object.entries(others))
      expect((await finish(sampled(valueAt))).transferFunction, name).not.to.equal('ct-bone');
  });

  it("leaves a unit, a manifest's look and an author's alone", async () => {
    expect((await finish(sampled(headCt), { unit: 'mm' })).transferFunction).to.equal(undefined);
    const volume = await finish(sampled(headCt), { window: [-100, 300] });
    expect(volume.window).to.deep.equal([-100, 300]);
    const appearance = await resolveAppearance(
      { ...plainAppearance, transferFunction: 'gray', window: [0, 80] },
      volume,
    );
    expect(appearance.transferFunction).to.deep.equal(await resolveTransferFunction('gray', [0, 80]));
  });

  it('shows nothing at 0 of what its file calls a statistic, whichever signs and window it has', async () => {
    const blob = (i: number): number => 9 * Math.exp(-9 * (radiusAt(i) - 0.4) ** 2);
    for (const [intent, valueAt, window, far] of [
      [5, blob, undefined, 9],
      [3, (i: number) => blob(i) - 4 * Math.exp(-4 * radiusAt(i)), [2.3, 6], 6],
      [2, (i: number) => -blob(i) / 10, undefined, 0.9],
    ] as const) {
      const volume = await finish(sampled(valueAt), { intent, ...(window && { window: [...window] }) });
      expect(volume.transferFunction, String(intent)).to.equal('diverging');
      expect(volume.window![0]).to.equal(-volume.window![1]);
      expect(volume.window![1]).to.be.closeTo(far, 0.02 * far);
      const stops = await resolveTransferFunction('diverging', volume.window!);
      expect(evaluate(stops, 0)[3]).to.equal(0);
    }
    // Of p values 0 is the strongest; and what is no statistic keeps the window of its file.
    expect(
      (
        await finish(
          sampled((i) => Math.min(1, radiusAt(i) / 2)),
          { intent: 22 },
        )
      ).transferFunction,
    ).to.equal(undefined);
    expect((await finish(sampled(blob), { intent: 0, window: [2, 5] })).window).to.deep.equal([2, 5]);
  });

  const labelAt = (i: number): number =>
    radiusAt(i) > 0.9 ? 0 : [3, 7, 12, 40][(i % size[0] > 11 ? 1 : 0) + (i > count / 2 ? 2 : 0)];

  it('gives labels colours of their own and nothing between them, with and without an intent code', async () => {
    for (const samples of [Uint8Array.from({ length: count }, (_, i) => labelAt(i)), sampled(labelAt)]) {
      for (const isLabels of [true, false]) {
        const volume = await finish(samples, { isLabels });
        expect(volume.isDiscrete).to.equal(true);
        const stops = parseTransferFunction(volume.transferFunction!, volume.window!);
        expect(evaluate(stops, 0)[3]).to.equal(0);
        const colors = [3, 7, 12, 40].map((label) => evaluate(stops, label).join());
        expect(new Set(colors).size).to.equal(4);
        expect(evaluate(stops, 3)[3]).to.be.above(0.1);
      }
    }
  });

  it('makes labels smaller by majority: no number comes that was not there', async () => {
    const volume = await finish(
      Uint8Array.from({ length: count }, (_, i) => labelAt(i)),
      {},
      { ...roomyLimits, maxVoxelsPerAxis: 10 },
    );
    expect(volume.isDiscrete).to.equal(true);
    expect(volume.reduced!.from).to.deep.equal(size);
    expect(volume.samples.length).to.be.below(count / 2);
    expect([...new Set(volume.samples)]).to.have.members([0, 3, 7, 12, 40]);
    expect(
      [...new Set([...volume.macrocells.low, ...volume.macrocells.high])].filter(
        (value) => ![0, 3, 7, 12, 40].includes(value),
      ),
    ).to.deep.equal([]);
  });

  it('takes many whole numbers in patches for labels where any may meet any', async () => {
    const block = (i: number): number =>
      Math.floor((i % size[0]) / 5) +
      5 * Math.floor((Math.floor(i / size[0]) % size[1]) / 5) +
      25 * Math.floor(i / size[0] / size[1] / 5);
    const volume = await finish(sampled((i) => (radiusAt(i) > 0.95 ? 0 : 1 + ((block(i) * 17) % 41))));
    expect(volume.isDiscrete).to.equal(true);
  });

  it('takes smooth values, few grays that are far apart and fractions for no labels', async () => {
    const others = {
      'a soft ball': (i: number) => Math.round(60 * Math.min(1, Math.max(0, 2.5 - 3 * radiusAt(i)))),
      'three grays': (i: number) => (radiusAt(i) > 0.9 ? 0 : radiusAt(i) > 0.5 ? 100 : 200),
      fractions: (i: number) => labelAt(i) / 3,
      'smooth tissue in 8 bits, which has patches too': (i: number) =>
        radiusAt(i) > 0.9 ? 0 : Math.round(90 + (i % size[0]) / 4 + 9 * (i / count)),
      'one value': () => 5,
    };
    for (const [name, valueAt] of Object.entries(others)) {
      const { isDiscrete, transferFunction } = await finish(sampled(valueAt));
      expect([isDiscrete, transferFunction], name).to.deep.equal([undefined, undefined]);
    }
  });

  it('shows a mask from half way between its two values on, thin ones denser than thick ones', async () => {
    const opacities = await Promise.all(
      [0.9, 0.15].map(async (radius) => {
        const volume = await finish(Uint8Array.from({ length: count }, (_, i) => (radiusAt(i) < radius ? 255 : 0)));
        expect(volume.isDiscrete).to.equal(undefined);
        const stops = parseTransferFunction(volume.transferFunction!, volume.window!);
        expect(evaluate(stops, 0.4 * 255)[3]).to.equal(0);
        return evaluate(stops, 255)[3];
      }),
    );
    expect(opacities[0]).to.be.above(0.005);
    expect(opacities[1]).to.be.above(2 * opacities[0]);
  });

  it('gives a map of both signs a scale of both', async () => {
    const { window, transferFunction } = await finish(
      sampled((i) => (radiusAt(i) > 0.6 ? 0 : 5 * Math.sin(i / 7) - 1)),
    );
    expect(transferFunction).to.equal('diverging');
    expect(window![0]).to.equal(-window![1]);
    const stops = await resolveTransferFunction('diverging', window!);
    const [blue, none, red] = [0.9 * window![0], 0, 0.9 * window![1]].map((value) => evaluate(stops, value));
    expect(blue[2]).to.be.above(blue[0]);
    expect(none[3]).to.equal(0);
    expect(red[0]).to.be.above(red[2]);
    expect(
      (await finish(sampled((i) => Math.max(-20, 900 * (1 - radiusAt(i)))))).transferFunction,
      'a little below 0',
    ).to.equal(undefined);
  });

  /** Uptake as of a tracer: noise in the air, a body, an organ in it, and in a few voxels 100 times as much as in the body. */
  const uptake = (i: number, hot = 60): number =>
    (radiusAt(i) > 1 ? 0.02 * Math.abs(noise(i)) : i % 400 === 0 ? hot : i % 30 === 0 ? 5 : 0.5) +
    0.1 * Math.abs(noise(i + 1));

  it('shows the body around what glows, as of a tracer in PET, in any unit', async () => {
    for (const [unit, samples] of Object.entries({
      SUV: sampled(uptake),
      'Bq/ml': sampled((i) => 9000 * uptake(i)),
      'whole numbers': Uint16Array.from({ length: count }, (_, i) => 500 * uptake(i)),
    })) {
      const { window, transferFunction, range } = await finish(samples);
      expect(window![0], unit).to.equal(0);
      const [body, organ, hot] = [0.5, 5, 60].map((value) => (value / 60) * (range[1] / window![1]));
      expect(organ, unit).to.be.within(0.6, 1.1);
      expect(hot, unit).to.be.above(5);
      const [ofAir, ofBody, ofOrgan] = [0.002 / 60, body, organ].map(
        (share) => evaluate(parseTransferFunction(transferFunction!, [0, 1]), share)[3],
      );
      expect(ofBody, unit).to.be.above(0.003);
      expect(ofAir, unit).to.be.below(0.05 * ofBody);
      expect(ofOrgan, unit).to.be.above(15 * ofBody);
    }
  });

  it('takes vessels, a few bright voxels, and maps of shares for no glow', async () => {
    const others = {
      vessels: (i: number) => (radiusAt(i) > 1 ? 0 : i % 90 === 0 ? 600 : 120) + 10 * Math.abs(noise(i)),
      'no numbers at all': () => NaN,
      'nothing but zeros': () => 0,
      'nothing but a spot': (i: number) => Math.max(0, 60 - 200 * radiusAt(i)),
      'shares of a small region': (i: number) => Math.max(0, 1 - radiusAt(i) / 0.3),
      'shares of tissue': (i: number) => Math.min(1, Math.max(0, 2.5 - 3 * radiusAt(i) + 0.2 * noise(i))),
      'an MRI with noise around it': (i: number) =>
        (radiusAt(i) > 0.9 ? 15 : i % 3000 === 0 ? 900 : 150) * (1 + 0.3 * noise(i)),
      'a series of an fMRI': (i: number) => Math.round((radiusAt(i) > 0.8 ? 20 : 700) * (1 + 0.2 * noise(i))),
    };
    for (const [name, valueAt] of Object.entries(others)) {
      const { transferFunction, window } = await finish(sampled(valueAt));
      expect(transferFunction, name).to.equal(undefined);
      expect(window!.every(Number.isFinite), name).to.equal(true);
    }
  });

  it('of maps of shares shows where they are high, of a small region too', async () => {
    for (const radius of [0.3, 1]) {
      const [low, high] = (await finish(sampled((i) => Math.max(0, 1 - radiusAt(i) / radius)))).window!;
      expect(low).to.be.within(0.1, 0.45);
      expect(high).to.be.within(0.5, 1);
    }
  });

  it('keeps the middle of the subject bright where a few voxels are far brighter', async () => {
    const [low, high] = (
      await finish(sampled((i) => (radiusAt(i) > 0.8 ? 0 : i % 50 === 0 ? 300 : 100 + 10 * noise(i))))
    ).window!;
    expect((100 - low) / (high - low)).to.be.within(0.4, 0.7);
  });

  it('says to the author of a mosaic without a spacing what to write, once', () => {
    const image = { width: 8, height: 8, data: new Uint8Array(64) };
    const mosaic = { columns: 2, rows: 2 };
    const { warn } = console;
    const lines: string[] = [];
    console.warn = (line: string) => lines.push(line);
    try {
      readMosaic(image, 'PNG', { mosaic, spacing: [1, 1, 3] });
      expect(lines).to.deep.equal([]);
      readMosaic(image, 'PNG', { mosaic });
      readMosaic(image, 'PNG', { mosaic });
    } finally {
      console.warn = warn;
    }
    expect(lines).to.have.length(1);
    expect(lines[0]).to.match(/spacing="X Y Z".*Z negative if they run from head to feet/);
  });

  it('reads the intent of both versions of NIfTI', async () => {
    for (const [length, at, mark] of [
      [348, 68, 'n+1\0'],
      [540, 504, 'n+2\0\r\n\x1a\n'],
    ] as const) {
      const bytes = new Uint8Array(544);
      const view = new DataView(bytes.buffer);
      view.setInt32(0, length, true);
      bytes.set(new TextEncoder().encode(mark), length === 348 ? 344 : 4);
      if (length === 348) view.setInt16(at, 1002, true);
      else view.setInt32(at, 1002, true);
      const header = length === 348 ? readVersion1(bytes, true) : await readRareHeader(bytes, detectNifti(bytes));
      expect(header.intent).to.equal(1002);
    }
  });
});

describe('the first look of a radar', () => {
  const sweeps = [0.5, 1.5, 3].map((elevation) => ({
    elevation,
    azimuths: evenAzimuths(90),
    gates: 60,
    gateLength: 1000,
  }));
  /** Of 20 kinds of gates, so many hold this value, dBZ, and the rest another one. */
  const scan = (share: number, high: number, low: number, moments?: [string, 'velocity'][]) =>
    radarVolume({
      ...(moments ? { moments } : {}),
      sweeps: sweeps.map((sweep) => ({
        ...sweep,
        stored: (_azimuth, gate, ray) =>
          ((gate + 7 * ray) % 20 < 20 * share ? high : low) * 2 + 64 + ((gate + ray) % 3),
      })),
    });

  it('is the usual scale for rain, and for clear air and clouds one of their own values', () => {
    expect(scan(0.5, 30, -10).transferFunction).to.equal('radar-dbz');
    const clear = scan(0.1, 20, -20);
    expect(clear.transferFunction).to.equal('turbo');
    expect(clear.window![0]).to.be.within(-21, -18);
    expect(clear.window![1]).to.be.within(18, 22);
  });

  it('is as far from 0 on both sides for velocities, and few fast gates do not make all others pale', () => {
    const { transferFunction, window } = scan(0.001, 30, 4, [['VRAD', 'velocity']]);
    expect(transferFunction).to.equal('radar-velocity');
    expect(window![0]).to.equal(-window![1]);
    expect(scan(0.5, 10, -10, [['VRAD', 'velocity']]).window![1]).to.be.within(9.5, 12.5);
  });

  it('is denser where echoes are thin and weak, and never thinner than the common one', async () => {
    const thin = scan(0.4, 8, -10);
    const thick = scan(1, 55, 55);
    const lengths = await Promise.all(
      [thin, thick].map(async (volume) => (await resolveAppearance(plainAppearance, volume)).referenceLength),
    );
    const common = Math.max(...edgeLengths(thin.grid)) / 100;
    expect(lengths[0]).to.be.below(0.5 * lengths[1]);
    for (const length of lengths) expect(length).to.be.within(common / 61, common * 1.01);
    expect((await resolveAppearance({ ...plainAppearance, referenceLength: 77 }, thin)).referenceLength).to.equal(77);
  });
});
