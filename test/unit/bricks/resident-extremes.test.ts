// What is stated where rays show one value each, the largest or the first local one, as an element does it: all that is known is what some bricks have taught.
import { expect } from '@esm-bundle/chai';
import { measureResiduals } from '../../../src/bricks/residuals.ts';
import { ResidentDetail } from '../../../src/bricks/resident-detail.ts';
import { atOnce } from '../../../src/core/waiting.ts';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../src/optics/rays/camera.ts';
import { interpolate } from '../../../src/optics/rays/interpolate.ts';
import { crossVolume, rayThrough, setUpRays } from '../../../src/optics/rays/rays.ts';
import { parseTransferFunction } from '../../../src/optics/transfer/parse-transfer-function.ts';
import { estimateBricks } from '../../../src/viewer/loading/brick-estimate.ts';
import type { BrickEstimate } from '../../../src/viewer/loading/brick-estimate.ts';
import type { VolumeOptics } from '../../../src/viewer/model/volume-info.ts';
import { cutIntoBricks, readBrick } from '../../helpers/bricks.ts';
import { randomNumbers, syntheticVolume } from '../../helpers/synthetic.ts';

const edge = 128;
const camera = orbitCamera({ theta: 0.4, phi: 1.2, radius: 390 }, [0, 0, 0], 0.6);
const view = { view: viewMatrix(camera), projection: projectionMatrix(0.6, 1, 1, 2) };

/** Rays across and down, of the true error; samples in a voxel. */
const [across, samples] = [24, 2];

type Field = (random: () => number) => (x: number, y: number, z: number) => number;

const fields: Readonly<Record<string, Field>> = {
  'specks of one voxel': (random) => () => (random() < 0.002 ? 0.6 + 0.4 * random() : 0.08),
  noise: (random) => () => random(),
  'waves of every length': () => (x, y, z) => {
    let [sum, count] = [0, 0];
    for (let wave = 2.9; wave < 2 * edge; wave *= 2.03, count++) {
      const k = (2 * Math.PI * edge) / wave;
      sum += Math.sin(k * x + 0.3 + count) * Math.sin(k * y + 1.1 + 2 * count) * Math.sin(k * z + 2.3 + 3 * count);
    }
    return 0.5 + (0.45 * sum) / count;
  },
};

/** A volume in levels of 128, 64 and 32 voxels. */
function sceneOf(field: Field, hasTable: boolean, threshold?: number) {
  const whole = syntheticVolume({ dimensions: [edge, edge, edge], field: field(randomNumbers(3)), slope: 255 });
  const { volume, pyramid } = cutIntoBricks(whole, 3, () => false);
  const bricks = volume.finer;
  const detail = new ResidentDetail(bricks.volume, bricks);
  if (hasTable) detail.take(measureResiduals(pyramid, 32), [0, 1, 2]);
  const rays = setUpRays(whole.grid, view.view, view.projection)!;
  const optics: VolumeOptics = {
    transferFunction: parseTransferFunction('0 #000 100%, 255 #fff 100%', [0, 255]),
    window: [0, 255],
    referenceLength: edge / 4,
    opacityFactor: 1,
    lightFactor: 1,
    projection: 'max',
    intensityThreshold: threshold,
    shading: 'unlit',
    surfaces: null,
  };
  let turn = 0;
  const estimate = (): BrickEstimate =>
    atOnce(estimateBricks({ volume, bricks, detail }, { view, optics }, { turn: turn++ }))!;
  /** With what is in doubt looked at, until so many bricks are there. */
  const fill = (count: number): BrickEstimate => {
    for (;;) {
      const found = estimate();
      for (const brick of found.probes) detail.measure(brick, readBrick(pyramid, brick), true);
      if (found.probes.length > 0) continue;
      if (bricks.count >= count) return found;
      for (const { brick } of found.gains.rank(count - bricks.count, 1, () => false)) {
        const values = readBrick(pyramid, brick);
        detail.measure(brick, values);
        bricks.add(brick, values);
      }
      bricks.current(volume);
    }
  };
  /** The value that a ray shows. */
  const ended = (values: Iterable<number>): number => {
    let most = -Infinity;
    for (const value of values) {
      if (threshold !== undefined && most >= threshold && value < most) break;
      most = Math.max(most, value);
    }
    return most;
  };
  const trueError = (): number => {
    let [sum, count] = [0, 0];
    for (let n = 0; n < across ** 2; n++) {
      const [column, row] = [n % across, Math.floor(n / across)];
      const ray = rayThrough(rays, ((column + 0.5) / across) * 2 - 1, 1 - ((row + 0.5) / across) * 2);
      const [enter, exit] = crossVolume(rays, ray);
      if (!(exit > enter)) continue;
      const steps = Math.ceil((exit - enter) * ray.lengthPerT * rays.diameter * samples);
      const places = Array.from({ length: steps }, (_, i) => {
        const t = enter + ((i + 0.5) / steps) * (exit - enter);
        return [0, 1, 2].map((axis) => ray.point[axis] + t * ray.direction[axis]) as [number, number, number];
      });
      const shown = ended(places.map((place) => detail.valueAt(...place)));
      const is = ended(places.map((place) => interpolate(whole.samples, whole.grid.dimensions, place)));
      sum += 3 * (is - shown) ** 2;
      count += 4;
    }
    return Math.sqrt(sum / count);
  };
  return { fill, trueError };
}

describe('What bricks hide of rays that show one value each', () => {
  const ways: readonly (readonly [string, boolean, number?])[] = [
    ['the largest one', false],
    ['the largest one, with a table of the writer', true],
    ['the first maximum from 150 on', false, 150],
  ];
  for (const [name, field] of Object.entries(fields))
    for (const [way, hasTable, threshold] of ways)
      it(`is stated within a factor of two: ${name}, ${way}`, () => {
        const { fill, trueError } = sceneOf(field, hasTable, threshold);
        for (const count of [0, 16]) {
          const said = fill(count).error.rms;
          const true_ = trueError();
          expect(true_).to.be.above(4);
          expect(said / true_).to.be.within(1 / 2, 2, `${count} bricks: ${said} was said, ${true_} is true`);
        }
      });
});
