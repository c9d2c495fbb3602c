// What <volume-measure> says: lengths, angles and volumes, how exactly they are known, and statistics of what is inside.
import { expect } from '@esm-bundle/chai';
import { beamToLocal, localToBeam } from '../../../src/radar/polar-geometry.ts';
import { edgesOfGate, sumUpGates } from '../../../src/radar/gates-inside.ts';
import { inPieces } from '../../../src/core/in-pieces.ts';
import { cartesianGrid } from '../../../src/volume/grid.ts';
import type { CartesianGrid } from '../../../src/volume/grid.ts';
import { add, scale } from '../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { measureAngle, measureBox, measureDistance, measureSphere } from '../../../src/volume/measures.ts';
import type { EdgesAt, Measured } from '../../../src/volume/measures.ts';
import { contains, solidOf } from '../../../src/volume/solid.ts';
import type { Solid } from '../../../src/volume/solid.ts';
import { Tally } from '../../../src/volume/statistics.ts';
import type { Statistics } from '../../../src/volume/statistics.ts';
import { sumUpVoxels } from '../../../src/volume/voxels-inside.ts';
import { decodeBytes, fetchFile, fetchFixture } from '../../helpers/decode.ts';
import { radarVolume } from '../../helpers/synthetic-radar.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

const oblong: EdgesAt = () => [
  [1, 0, 0],
  [0, 2, 0],
  [0, 0, 3],
];
const leaning: EdgesAt = () => [
  [0.9, 0.3, 0],
  [-0.2, 0.8, 0.1],
  [0.1, 0.2, 1.4],
];

function finish(work: Generator<void, Statistics>): Statistics {
  for (;;) {
    const { done, value } = work.next();
    if (done) return value;
  }
}

describe('what is measured between places', () => {
  it('of a box or a sphere without any extent is off by what its points may be', () => {
    const edges: EdgesAt = () => [
      [2, 0, 0],
      [0, 2, 0],
      [0, 0, 3],
    ];
    const [place, ends] = [[5, 5, 5], [2, 2, 3].map((edge) => 2 * Math.sqrt((2 * edge * edge) / 12))] as [
      Vector3,
      number[],
    ];
    const [box, sphere] = [measureBox, measureSphere].map((measure) => measure([place, place], edges));
    expect(box.value).to.equal(0);
    expect(box.uncertainty).to.be.closeTo(ends[0] * ends[1] * ends[2], 1e-12);
    const radius = 2 * Math.sqrt((2 * (4 + 4 + 9)) / 3 / 12);
    expect(sphere.value).to.equal(0);
    expect(sphere.uncertainty).to.be.closeTo((4 / 3) * Math.PI * radius ** 3, 1e-12);
  });

  it('is by closed form: 3-4-5, a right angle, a box and a sphere', () => {
    expect(
      measureDistance(
        [
          [1, 1, 1],
          [4, 5, 1],
        ],
        oblong,
      ).value,
    ).to.be.closeTo(5, 1e-12);
    expect(
      measureAngle(
        [
          [4, 1, 1],
          [1, 1, 1],
          [1, 1, 7],
        ],
        oblong,
      ).value,
    ).to.be.closeTo(90, 1e-12);
    expect(
      measureAngle(
        [
          [4, 1, 1],
          [1, 1, 1],
          [3, 3, 1],
        ],
        oblong,
      ).value,
    ).to.be.closeTo(45, 1e-12);
    expect(
      measureAngle(
        [
          [4, 1, 1],
          [1, 1, 1],
          [-3, 1, 1],
        ],
        oblong,
      ).value,
    ).to.be.closeTo(180, 1e-12);
    expect(
      measureAngle(
        [
          [1, 1, 1],
          [1, 1, 1],
          [3, 3, 1],
        ],
        oblong,
      ).value,
    ).to.equal(0);
    expect(
      measureBox(
        [
          [1, 1, 1],
          [-1, 4, 5],
        ],
        oblong,
      ).value,
    ).to.be.closeTo(24, 1e-12);
    expect(
      measureSphere(
        [
          [1, 1, 1],
          [1, 3, 1],
        ],
        oblong,
      ).value,
    ).to.be.closeTo((32 / 3) * Math.PI, 1e-12);
  });

  it('is known to twice sqrt(edge^2 / 12) of each end, along its way', () => {
    expect(
      measureDistance(
        [
          [0, 0, 0],
          [10, 0, 0],
        ],
        oblong,
      ).uncertainty,
    ).to.be.closeTo(2 * Math.sqrt(2 / 12), 1e-12);
    expect(
      measureDistance(
        [
          [0, 0, 0],
          [0, 0, 10],
        ],
        oblong,
      ).uncertainty,
    ).to.be.closeTo(2 * Math.sqrt((2 * 9) / 12), 1e-12);
    expect(
      measureDistance(
        [
          [0, 0, 0],
          [0, 0, 0],
        ],
        oblong,
      ).uncertainty,
      'no direction',
    ).to.be.closeTo(2 * Math.sqrt((2 * (1 + 4 + 9)) / 3 / 12), 1e-12);
    expect(
      measureSphere(
        [
          [0, 0, 0],
          [0, 5, 0],
        ],
        oblong,
      ).uncertainty,
    ).to.be.closeTo(4 * Math.PI * 25 * 2 * Math.sqrt((2 * 4) / 12), 1e-9);
  });

  it('scatters as much where places lie anywhere in their voxels', () => {
    const random = randomNumbers(3);
    const points: readonly Vector3[] = [
      [31, 2, 3],
      [1, 5, -20],
      [9, 44, 5],
    ];
    const cases: [string, (places: readonly Vector3[], edgesAt: EdgesAt) => Measured][] = [
      ['distance', measureDistance],
      ['angle', measureAngle],
      ['box', measureBox],
      ['sphere', measureSphere],
    ];
    for (const [name, measure] of cases) {
      const found = Array.from({ length: 4000 }, () => {
        const shaken = points.map((point) =>
          leaning(point).reduce((at, edge) => add(at, scale(edge, random() - 0.5)), point),
        );
        return measure(shaken, leaning).value;
      });
      const mean = found.reduce((sum, x) => sum + x, 0) / found.length;
      const deviation = Math.sqrt(found.reduce((sum, x) => sum + (x - mean) ** 2, 0) / found.length);
      expect(measure(points, leaning).uncertainty / (2 * deviation), name).to.be.closeTo(1, 0.05);
    }
  });
});

interface Expected {
  readonly name: string;
  readonly kind: Solid['kind'];
  readonly points: readonly Vector3[];
  readonly affine: readonly number[];
  readonly count: number;
  readonly mean: number;
  readonly deviation: number;
  readonly min: number;
  readonly largest: number;
  readonly cut: number;
}

/** By nibabel and NumPy, see test/fixtures/make-measure-values.py. */
const expected = JSON.parse(new TextDecoder().decode(await fetchFixture('measure-values.json'))) as Expected[];

describe('statistics of the voxels inside', () => {
  for (const name of ['mni152-t1.nii.gz', 'ct-phantom.nii.gz']) {
    it(`are nibabel's, with the file's affine and an oblique one: ${name}`, async () => {
      const volume = await decodeBytes(await fetchFile(`/demos/data/${name}`), name);
      const own = volume.grid as CartesianGrid;
      const cases = expected.filter((one) => one.name === name);
      for (const { kind, points, affine, ...numbers } of cases) {
        const found = finish(
          sumUpVoxels({ ...volume, grid: cartesianGrid(own.dimensions, affine) }, solidOf(kind, points)),
        );
        const what = `${kind} ${affine.slice(0, 4).join(' ')}`;
        expect([found.count, found.cut, found.withoutData, found.least, found.largest], what).to.deep.equal([
          numbers.count,
          numbers.cut,
          0,
          numbers.min,
          numbers.largest,
        ]);
        expect(found.mean, what).to.be.closeTo(numbers.mean, 1e-9);
        expect(found.deviation, what).to.be.closeTo(numbers.deviation, 1e-9);
        expect(found.standardError, what).to.be.closeTo(numbers.deviation / Math.sqrt(numbers.count), 1e-9);
      }
      expect(cases.length).to.be.at.least(4);
    });
  }

  /** 4 x 3 x 2 voxels of 1, 2 and 3 mm, each value its number; no data in two of them. */
  const samples = Float32Array.from({ length: 24 }, (_, i) => (i === 5 || i === 17 ? NaN : i));
  const small = {
    samples,
    slope: 2,
    intercept: 1,
    grid: cartesianGrid([4, 3, 2], [1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 1]),
  };

  it('leave out and count what has no data, and take in a centre on the surface', () => {
    const all = finish(
      sumUpVoxels(
        small,
        solidOf('box', [
          [0, 0, 0],
          [3, 4, 3],
        ]),
      ),
    );
    expect([all.count, all.withoutData, all.least, all.largest, all.cut]).to.deep.equal([22, 2, 1, 47, 24]);
    expect(all.mean).to.be.closeTo(2 * ((276 - 22) / 22) + 1, 1e-12);
    const around = finish(
      sumUpVoxels(
        small,
        solidOf('box', [
          [3.5, 5, 4.5],
          [-0.5, -1, -1.5],
        ]),
      ),
    );
    expect([around.count, around.cut], 'whole voxels').to.deep.equal([22, 0]);
    const ball = finish(
      sumUpVoxels(
        small,
        solidOf('sphere', [
          [1, 2, 0],
          [1, 4, 0],
        ]),
      ),
    );
    expect(
      [ball.count + ball.withoutData, ball.cut],
      '4 of its row, and 1 of each beside it; the middle one is whole',
    ).to.deep.equal([6, 5]);
  });

  it('of one voxel have no deviation, and of none say so', () => {
    const one = finish(
      sumUpVoxels(
        small,
        solidOf('sphere', [
          [2, 2, 3],
          [2.1, 2, 3],
        ]),
      ),
    );
    expect([one.count, one.mean, one.deviation, one.standardError]).to.deep.equal([1, 2 * 18 + 1, null, null]);
    for (const points of [
      [
        [20, 20, 20],
        [30, 30, 30],
      ],
      [
        [0.2, 0.2, 0.2],
        [0.3, 0.3, 0.3],
      ],
    ] as const) {
      const none = finish(sumUpVoxels(small, solidOf('box', points)));
      expect(none).to.deep.equal({
        count: 0,
        withoutData: 0,
        mean: null,
        deviation: null,
        standardError: null,
        least: null,
        largest: null,
        cut: 0,
      });
    }
  });

  it('lose nothing where small differences stand on large numbers', () => {
    const tally = new Tally();
    tally.add([1e9 + 4, 1e9 + 7], 0, 2);
    tally.add([1e9 + 13, 1e9 + 16], 0, 2);
    const { mean, deviation } = tally.finish({ slope: 1, intercept: 0 });
    expect([mean, deviation]).to.deep.equal([1e9 + 10, Math.sqrt(30)]);
  });

  it('come in pieces, and not at all where they are no longer wanted', async () => {
    const calls: number[] = [];
    function* count(): Generator<void, string> {
      for (let i = 0; i < 3; i++) {
        calls.push(i);
        yield;
      }
      return 'done';
    }
    expect(await inPieces(count(), () => true)).to.equal('done');
    expect(await inPieces(count(), () => calls.length < 5)).to.equal(null);
    expect(calls).to.deep.equal([0, 1, 2, 0, 1]);
  });
});

describe('statistics of the gates of a radar inside', () => {
  const volume = radarVolume({
    sweeps: [
      { elevation: 1, gates: 40, gateLength: 500, firstGate: 250 },
      {
        elevation: 3,
        gates: 40,
        gateLength: 500,
        firstGate: 250,
        rayElevation: (azimuth) => 3 + Math.sin(azimuth) / 9,
      },
    ],
  });

  it('are of those whose middles are inside, by the 4/3 Earth, whatever heights are exaggerated', () => {
    const {
      grid: { sweeps, earthRadius },
      samples,
      slope,
      intercept,
    } = volume;
    for (const solid of [
      solidOf('box', [
        [-9000, 2000, 100],
        [4000, 15000, 700],
      ]),
      solidOf('sphere', [
        [5000, -6000, 200],
        [5000, -1000, 300],
      ]),
    ]) {
      const values: number[] = [];
      for (const { azimuths, elevation, elevations, firstGate, gateLength, gates, offset } of sweeps) {
        azimuths.forEach((azimuth, radial) => {
          for (let gate = 0; gate < gates; gate++) {
            const at = beamToLocal(
              { range: firstGate + gate * gateLength, azimuth, elevation: elevations?.[radial] ?? elevation },
              earthRadius,
            );
            if (contains(solid, at)) values.push(slope * samples[offset + radial * gates + gate] + intercept);
          }
        });
      }
      const mean = values.reduce((sum, x) => sum + x, 0) / values.length;
      const found = finish(sumUpGates(volume, solid));
      expect([found.count, found.withoutData, found.least, found.largest, found.cut]).to.deep.equal([
        values.length,
        0,
        Math.min(...values),
        Math.max(...values),
        null,
      ]);
      expect(found.mean).to.be.closeTo(mean, 1e-9);
      expect(found.deviation).to.be.closeTo(
        Math.sqrt(values.reduce((sum, x) => sum + (x - mean) ** 2, 0) / (values.length - 1)),
        1e-9,
      );
      expect(values.length).to.be.above(30);
    }
  });

  it('has edges a gate long, a radial wide and a beam high', () => {
    const at = beamToLocal({ range: 10_250, azimuth: 60, elevation: 3 }, volume.grid.earthRadius);
    const [along, around, up] = edgesOfGate(volume, at);
    const ends = [1, -1].map((side) => localToBeam(add(at, scale(along, side / 2)), volume.grid.earthRadius).range);
    expect(ends[0] - ends[1]).to.be.closeTo(500, 1);
    const sides = [1, -1].map((side) => localToBeam(add(at, scale(around, side / 2)), volume.grid.earthRadius).azimuth);
    expect(sides[1] - sides[0], '24 radials').to.be.closeTo(-15, 0.2);
    const sector = {
      ...volume,
      grid: {
        ...volume.grid,
        sweeps: [
          {
            ...volume.grid.sweeps[0],
            azimuths: Float64Array.from([0.5, 1.5, 2.5, 3.5, 355.5, 356.5, 357.5, 358.5, 359.5]),
          },
        ],
      },
    };
    expect(Math.hypot(...edgesOfGate(sector, at)[1]), 'a sector across north, a degree a radial').to.be.closeTo(
      Math.hypot(...around) / 15,
      1e-9,
    );
    const heights = [1, -1].map((side) => localToBeam(add(at, scale(up, side / 2)), volume.grid.earthRadius).elevation);
    expect(heights[0] - heights[1]).to.be.closeTo(volume.grid.beamWidth, 0.01);
  });
});
