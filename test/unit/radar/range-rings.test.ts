import { expect } from '@esm-bundle/chai';
import { clipLine } from '../../../src/radar/clip-line.ts';
import type { Rectangle } from '../../../src/radar/clip-line.ts';
import { readRings } from '../../../src/viewer/cuts/read-rings.ts';
import { axialIndexToWorld, cartesianGrid } from '../../../src/volume/grid.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { cutRegion } from '../../../src/volume/region.ts';
import { VolumeViewError } from '../../../src/core/errors.ts';
import { polarScenes, radarVolume } from '../../helpers/synthetic-radar.ts';

const square: Rectangle = [
  [-1, 1],
  [-1, 1],
];

describe('a line above a rectangle', () => {
  it('is cut where it enters and leaves, heights with it', () => {
    expect(
      clipLine(
        [
          [-3, 0, 0],
          [3, 0, 6],
        ],
        square,
      ),
    ).to.deep.equal([
      [
        [-1, 0, 2],
        [1, 0, 4],
      ],
    ]);
    expect(
      clipLine(
        [
          [0, 0, 0],
          [0.5, 0, 0],
          [0.5, 3, 0],
        ],
        square,
      ),
    ).to.deep.equal([
      [
        [0, 0, 0],
        [0.5, 0, 0],
        [0.5, 1, 0],
      ],
    ]);
    expect(
      clipLine(
        [
          [-2, 0.5, 0],
          [0, 0.5, 0],
          [0, 2, 0],
          [0.5, 2, 0],
          [0.5, -2, 0],
        ],
        square,
      ),
    ).to.deep.equal([
      [
        [-1, 0.5, 0],
        [0, 0.5, 0],
        [0, 1, 0],
      ],
      [
        [0.5, 1, 0],
        [0.5, -1, 0],
      ],
    ]);
  });

  it('outside gives nothing, and inside stays as it is', () => {
    expect(
      clipLine(
        [
          [2, -5, 0],
          [2, 5, 0],
        ],
        square,
      ),
    ).to.deep.equal([]);
    expect(
      clipLine(
        [
          [-3, 0, 0],
          [0, 3, 0],
        ],
        square,
      ),
    ).to.deep.equal([]);
    const inside: Vector3[] = [
      [0, 0, 0],
      [0.5, 0.5, 1],
      [-0.5, 0.5, 1],
    ];
    expect(clipLine(inside, square)).to.deep.equal([inside]);
  });
});

describe('range rings around a radar', () => {
  const volume = radarVolume(polarScenes['five sweeps']);
  const radiiOf = (rings: ReturnType<typeof readRings>): (number | null)[] => rings!.labels.map(({ radius }) => radius);

  it('are round distances up to its reach, or those asked for', () => {
    expect(radiiOf(readRings('auto', volume, null))).to.deep.equal([5000, 10_000, 15_000, 20_000, null]);
    expect(radiiOf(readRings(8, volume, null))).to.deep.equal([8000, 16_000, null]);
    expect(readRings('none', volume, null) === null).to.equal(true);
    for (const spacing of [0.1, 25])
      expect(() => readRings(spacing, volume, null), `${spacing}`).to.throw(VolumeViewError, 'rings got');
  });

  it('are there where nothing is said, with spokes between them as a ground; of other volumes there are none', () => {
    const [said, unsaid] = (['auto', null] as const).map((setting) => readRings(setting, volume, null)!);
    expect(radiiOf(unsaid)).to.deep.equal(radiiOf(said));
    expect(unsaid.lines.length - said.lines.length).to.equal(11);
    const [inner, outer] = unsaid.lines.at(-3)!;
    expect(Math.hypot(...inner)).to.be.closeTo(5000, 1e-6);
    expect(Math.hypot(...outer)).to.be.closeTo(20_000, 1e-6);
    const grid = cartesianGrid([2, 2, 2], axialIndexToWorld([2, 2, 2], [1, 1, 1]));
    expect(readRings(null, { grid }, null) === null).to.equal(true);
  });

  it('lie in the region, with the labels, as fine as it is small', () => {
    const region = cutRegion(volume.grid, [2000, 3000, 0, 6000, 7000, 2000])!;
    const { lines, labels } = readRings('auto', volume, region)!;
    expect(labels.map(({ radius }) => radius)).to.deep.equal([4000, 5000, 6000, 7000, 8000, 9000]);
    for (const [x, y] of [...lines.flat(), ...labels.map(({ at }) => at)]) {
      expect(x).to.be.within(2000 - 1e-6, 6000 + 1e-6);
      expect(y).to.be.within(3000 - 1e-6, 7000 + 1e-6);
    }
    expect(radiiOf(readRings(50, radarVolume({ sweeps: [{ elevation: 1, gates: 100 }] }), region))).to.deep.equal([]);
  });

  it('of a sector have their labels where it lies', () => {
    const { labels } = readRings(10, radarVolume({ sweeps: [{ elevation: 1, azimuths: [299, 300, 301] }] }), null)!;
    for (const { radius, at } of labels) {
      if (radius === null) continue;
      expect((Math.atan2(at[0], at[1]) * 180) / Math.PI, String(radius)).to.be.closeTo(-60, 1);
      expect(Math.hypot(at[0], at[1])).to.be.closeTo(radius, 1e-6);
    }
  });
});
