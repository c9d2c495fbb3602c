import { expect } from '@esm-bundle/chai';
import { contributionOf } from '../../../src/optics/cells/empty-space-distance.ts';
import { parseTransferFunction } from '../../../src/optics/transfer/parse-transfer-function.ts';
import { findSeenCells } from '../../../src/optics/cells/seen-cells.ts';
import { boundMissed, seekMissed, stateError } from '../../../src/quality/largest-error.ts';
import {
  cellsAtOnce,
  detailCodes,
  findDetail,
  measureMissable,
  seekDetail,
} from '../../../src/optics/cells/cell-detail.ts';
import type { SeenVolume } from '../../../src/optics/cells/cell-detail.ts';
import { buildMacrocells } from '../../../src/volume/macrocells.ts';
import { offLine } from '../../../src/volume/grid.ts';
import type { Waiting } from '../../../src/core/waiting.ts';
import type { VolumeData } from '../../../src/volume/volume.ts';
import { randomNumbers, syntheticVolume } from '../../helpers/synthetic.ts';

function see(field: (x: number, y: number, z: number) => number, text: string): SeenVolume {
  const volume = syntheticVolume({ dimensions: [24, 24, 24], spacing: [1, 1, 1], field });
  const transferFunction = parseTransferFunction(text, [0, 1]);
  return {
    volume,
    transferFunction,
    cells: findSeenCells(volume.macrocells, [contributionOf(transferFunction)], volume),
    opticalScale: 1,
  };
}

const covered = { rms: 0.3, p99: 0.5, p999: 0.8, max: 0.9, order: 2, discretization: 0.1, coverage: 0.5, covered: 900 };

describe('what could be missed in cells', () => {
  it('is no more than is said quickly, and what follows from it is as without that', () => {
    const random = randomNumbers(11);
    const seen = see(
      (x, y) => (0.5 * x + 0.3 * Math.sin(9 * y) + 0.4 * random() ** 6) % 1,
      '0 #246 0, 0.3 #f80 20%, 0.35 #f80 0, 0.7 white 60%, 1 white 90%',
    );
    for (const kind of ['among', 'offLine'] as const) {
      const missable = measureMissable(seen, kind);
      for (const samples of detailCodes)
        seen.cells.forEach((_, cell) => expect(missable(cell, samples, true)).to.be.at.least(missable(cell, samples)));
    }
    const offLineOnly = measureMissable(seen, 'offLine');
    for (const lost of [0.001, 0.02, 0.04, 0.2]) {
      const plain = Array.from(seen.cells, (isSeen, cell) => {
        const code = detailCodes.findIndex((samples) => offLineOnly(cell, samples) <= lost);
        return isSeen ? (code < 0 ? detailCodes.length - 1 : code) : 0;
      });
      expect(Array.from(findDetail(seen, lost))).to.deep.equal(plain);
    }
    const among = measureMissable(seen, 'among');
    expect(boundMissed(seen, 1)).to.equal(
      Math.max(...Array.from(seen.cells, (isSeen, cell) => (isSeen ? among(cell, 1) : 0))),
    );
  });
});

describe('what cells need and could miss, of many cells', () => {
  it('is found in pauses, and is the same as at once', () => {
    const random = randomNumbers(8);
    const count = 3 * cellsAtOnce + 100;
    const low = Float32Array.from({ length: count }, () => random());
    const high = low.map((x) => x + (1 - x) * random() ** 3);
    const roughness = low.map((x, cell) => (high[cell] - x) * random());
    const { volume, ...seen } = see((x) => x, '0 #246 0, 0.3 #f80 20%, 0.35 #f80 0, 0.7 white 60%, 1 white 90%');
    const many: SeenVolume = {
      ...seen,
      volume: {
        ...volume,
        slope: 1,
        intercept: 0,
        macrocells: { dimensions: [count, 1, 1], size: 4, low, high, roughness },
      },
      cells: Uint8Array.from(low, () => Number(random() < 0.8)),
    };
    const inPauses = <T>(work: Waiting<T>): { value: T; pauses: number } => {
      for (let pauses = 0; ; pauses++) {
        const { done, value } = work.next();
        if (done) return { value, pauses };
      }
    };
    const detail = inPauses(seekDetail(many, 0.1));
    expect(detail.pauses).to.equal(3);
    expect(detail.value).to.deep.equal(findDetail(many, 0.1));
    expect(new Set(detail.value).size, 'codes').to.equal(detailCodes.length);
    const missed = inPauses(seekMissed(many, 1, detail.value));
    expect(missed.pauses).to.equal(3);
    expect(missed.value)
      .to.equal(boundMissed(many, 1, detail.value))
      .and.to.be.above(0.01);
  });
});

describe('the roughness of cells', () => {
  it('is the largest second difference that bends what is in them, or makes all of the range count', () => {
    const random = randomNumbers(5);
    const [nx, ny, nz] = [19, 17, 21];
    for (const noise of [0.002, 0.05, 1]) {
      const samples = Float32Array.from({ length: nx * ny * nz }, (_, at) => (at % nx) / nx + noise * random() ** 8);
      samples[300] = NaN;
      const { roughness, low, high, dimensions, size } = buildMacrocells(samples, [nx, ny, nz]);
      const at = (i: number, j: number, k: number): number =>
        samples[
          Math.min(nx - 1, Math.max(0, i)) +
            nx * (Math.min(ny - 1, Math.max(0, j)) + ny * Math.min(nz - 1, Math.max(0, k)))
        ];
      for (let cell = 0; cell < roughness.length; cell++) {
        const first = [
          cell % dimensions[0],
          Math.floor(cell / dimensions[0]) % dimensions[1],
          Math.floor(cell / (dimensions[0] * dimensions[1])),
        ].map((i) => size * i);
        let largest = 0;
        const isOwn = (place: number, axis: number): boolean => place >= first[axis] && place < first[axis] + size;
        for (let k = Math.max(0, first[2] - 1); k <= Math.min(nz - 1, first[2] + size); k++)
          for (let j = Math.max(0, first[1] - 1); j <= Math.min(ny - 1, first[1] + size); j++)
            for (let i = Math.max(0, first[0] - 1); i <= Math.min(nx - 1, first[0] + size); i++) {
              [
                [1, 0, 0],
                [0, 1, 0],
                [0, 0, 1],
              ].forEach(([x, y, z], axis) => {
                // Planes of voxels beside a cell bend nothing in it; lines of voxels beside it do.
                if (!isOwn([i, j, k][axis], axis)) return;
                const second = Math.abs(at(i - x, j - y, k - z) - 2 * at(i, j, k) + at(i + x, j + y, k + z));
                if (second > largest) largest = second;
              });
            }
        const range = high[cell] - low[cell];
        if (offLine * roughness[cell] >= 0.999 * range) expect(offLine * largest).to.be.at.least(0.599 * range);
        else expect(roughness[cell]).to.be.closeTo(largest, 1e-6);
      }
    }
  });
});

describe('how finely cells have to be sampled', () => {
  it('is coarse where data are smooth or things too faint to be seen, and fine where a voxel may stand out', () => {
    const ramp = '0 #fff 0, 1 #fff 60%';
    const codesOf = (field: (x: number, y: number, z: number) => number, text: string): number =>
      Math.max(...findDetail(see(field, text), 2 / 255));
    expect(codesOf((x) => 0.3 + 0.1 * Math.sin(3 * x), ramp)).to.be.at.most(1);
    const speck =
      (height: number) =>
      (x: number, y: number, z: number): number =>
        Math.max(Math.abs(x - 0.48), Math.abs(y - 0.48), Math.abs(z - 0.48)) < 0.02 ? 0.1 + height : 0.1;
    expect(codesOf(speck(0.9), ramp)).to.equal(3);
    expect(codesOf(speck(0.006), ramp)).to.be.at.most(1);
    expect(codesOf(speck(0.9), '0 #fff 0, 1 #fff 0.4%'), 'hardly opaque').to.equal(0);
    expect(
      codesOf((x) => x, '0 #fff 0, 0.5 #fff 0, 0.5 #fff 100%'),
      'a jump',
    ).to.equal(3);
  });
});

describe('the bound of what probes could have missed', () => {
  it('is large where one voxel may be bright, small where the data are smooth, and nothing where nothing is seen', () => {
    const speck = (x: number, y: number, z: number): number =>
      Math.max(Math.abs(x - 0.48), Math.abs(y - 0.48), Math.abs(z - 0.48)) < 0.02 ? 1 : 0.1;
    const smooth = (x: number): number => 0.3 + 0.1 * Math.sin(3 * x);
    const ramp = '0 #fff 0, 1 #fff 60%';
    expect(boundMissed(see(speck, ramp), 1)).to.be.above(0.5);
    expect(boundMissed(see(smooth, ramp), 1)).to.be.below(0.03);
    expect(boundMissed(see(smooth, '0.9 #fff 0, 1 #fff 60%'), 1)).to.equal(0);
  });

  it('gets smaller with shorter steps, but not where the transfer function jumps', () => {
    const noise = randomNumbers(9);
    const rough = see(() => 0.4 + 0.2 * noise(), '0 #fff 0, 1 #fff 30%');
    expect(boundMissed(rough, 4)).to.be.below(0.6 * boundMissed(rough, 1));
    const finest = rough.cells.map(() => 3);
    expect(boundMissed(rough, 1, finest)).to.equal(boundMissed(rough, 8));
    expect(boundMissed(rough, 0.25, finest), 'no step has more than eight samples').to.equal(boundMissed(rough, 2));
    expect(
      boundMissed(
        see((x) => x, '0 #fff 0, 0.5 #fff 0, 0.5 #fff 100%'),
        4,
      ),
    ).to.be.above(0.99);
  });

  it('bounds what an author’s steps leave, also where they are longer than a voxel', () => {
    // One voxel with 10 % of opacity. A ray through it, in steps that are not cut, and with the integral of the tent it makes.
    const middle = 12.5 / 24;
    const voxel = see(
      (x, y, z) => (Math.max(Math.abs(x - middle), Math.abs(y - middle), Math.abs(z - middle)) < 0.01 ? 1 : 0),
      '0 #fff 0, 1 #fff 10%',
    );
    expect(Math.max(...voxel.volume.macrocells.high), 'the voxel is there').to.equal(255);
    const shown = (depth: number): number => 1 - 0.9 ** depth;
    for (const length of [0.5, 1, 2, 4, 6]) {
      let largest = 0;
      for (let start = 0; start < length; start += length / 64) {
        let depth = 0;
        for (let at = start - 8; at < 8; at += length) depth += length * Math.max(0, 1 - Math.abs(at));
        largest = Math.max(largest, Math.abs(shown(depth) - shown(1)));
      }
      expect(boundMissed(voxel, 1 / length), `steps of ${length} voxels`)
        .to.be.above(largest)
        .and.below(0.9);
    }
  });

  it('is not known of the colours of channels, which may change where their brightness does not', () => {
    const flat = see(() => 0.5, '0 #fff 10%, 1 #fff 10%');
    expect(boundMissed(flat, 1)).to.equal(0);
    const channels = { colors: new Uint8Array(), channels: [] } as unknown as VolumeData['channels'];
    const colored = { ...flat, volume: { ...flat.volume, channels } };
    expect(stateError(covered, boundMissed(colored, 1), 1).error.max).to.equal(null);
    expect(boundMissed({ ...colored, cells: flat.cells.map(() => 0) }, 1), 'nothing is visible').to.equal(0);
  });

  it('is what is stated as the largest error, and all that is stated where no probe met anything', () => {
    const speck = see((x) => (Math.abs(x - 0.48) < 0.02 ? 1 : 0), '0.2 #fff 0, 1 #fff 60%');
    const { error } = stateError(covered, boundMissed(speck, 1), 1);
    expect(error.max).to.be.above(100);
    expect(error.rms).to.equal(0.3);
    const nothing = { ...covered, covered: 0, coverage: 0, rms: 0, p99: 0, p999: 0, max: 0 };
    expect(stateError(nothing, boundMissed(speck, 1), 1).error.rms, 'no zero').to.be.above(100);
    expect(stateError(nothing, boundMissed({ ...speck, cells: speck.cells.map(() => 0) }, 1), 1).error).to.deep.equal({
      rms: 0,
      p99: 0,
      max: 0,
      probed: 0,
      rays: 0,
    });
  });

  it('is not stated where it is not known: what was probed is', () => {
    const jump = see((x) => x, '0 #fff 0, 0.5 #fff 0, 0.5 #fff 100%');
    expect(stateError(covered, boundMissed(jump, 4), 1).error).to.deep.equal({
      rms: 0.3,
      p99: 0.5,
      max: null,
      probed: 0.9,
      rays: 900,
    });
  });

  it('says that an error is kept by what probes met, and where they met nothing, by what they could have missed', () => {
    const nothing = { ...covered, covered: 0, coverage: 0, rms: 0, p99: 0, p999: 0, max: 0 };
    expect(stateError(covered, 0.9, 1).isKept).to.equal(true);
    expect(stateError({ ...covered, p999: 9 }, 0, 1).isKept).to.equal(false);
    expect(stateError(nothing, 0.9, 1).isKept).to.equal(false);
    expect(stateError(nothing, 0.003, 1).isKept).to.equal(true);
    expect(stateError(nothing, 0, 1).isKept, 'nothing is in sight').to.equal(true);
  });
});
