// Random views of volumes in bricks, of which some are there: what the element says that the others hide, and what they do hide, by the float64 reference.
import { ResidentDetail } from '../../src/bricks/resident-detail.ts';
import { blockOfResiduals, measureResiduals } from '../../src/bricks/residuals.ts';
import { framingDistance, orbitCamera, projectionMatrix, viewMatrix } from '../../src/optics/rays/camera.ts';
import { cartesianField } from '../../src/optics/rays/ray-field.ts';
import { setUpRays } from '../../src/optics/rays/rays.ts';
import type { RaySetup } from '../../src/optics/rays/rays.ts';
import { renderReference } from '../../src/optics/reference.ts';
import { parseTransferFunction } from '../../src/optics/transfer/parse-transfer-function.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import { boundingSphere, finestSpacing } from '../../src/volume/grid.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { BrickChoice } from '../../src/viewer/loading/brick-choice.ts';
import type { ChosenBricks } from '../../src/viewer/loading/brick-choice.ts';
import type { VolumeOptics } from '../../src/viewer/model/volume-info.ts';
import { atOnce } from '../../src/core/waiting.ts';
import { cutIntoBricks, readBrick } from '../helpers/bricks.ts';
import type { Bricked } from '../helpers/bricks.ts';
import { compareCovered } from '../helpers/covered-error.ts';
import type { CoveredError } from '../helpers/covered-error.ts';
import { randomNumbers, syntheticVolume } from '../helpers/synthetic.ts';

/** Voxels along each axis, of which a level of a quarter is always there. */
const edge = 192;

/** Values of `max-error`. */
const errors = [8, 4, 2, 1];

/** Rays across and down, of the true error. */
const across = 28;

/**
 * Steps of the pictures that are compared, in voxels. Pieces of rays begin and end elsewhere where bricks lie, so steps of a voxel leave a difference of up to 0.6 of 255
 * through narrow peaks, also where all values are the same; these leave 0.03.
 */
const stepOfTruth = 1 / 8;

/** A pattern with detail down to single voxels: octaves of waves that turn. */
function stone(x: number, y: number, z: number): number {
  let [sum, size] = [0, 0.5];
  for (let octave = 0, n = 7; octave < 6; octave++, n *= 2.1, size *= 0.55)
    sum +=
      size *
      Math.sin(n * x + 1.7 * Math.sin(n * 0.6 * y)) *
      Math.sin(n * y + 1.3 * octave) *
      Math.sin(n * z + n * 0.4 * x);
  return Math.min(1, Math.max(0, 0.5 + 0.7 * sum));
}

const blob = (x: number, y: number, z: number): number => Math.hypot(x - 0.5, y - 0.45, z - 0.55);

/** Values from 0 to 1 in the unit cube. */
const fields: Readonly<Record<string, (random: () => number) => (x: number, y: number, z: number) => number>> = {
  'detail at every scale': () => stone,
  'noise, only in a half': (random) => (x) => (x < 0.5 ? random() : 0.4),
  'a rough ball': (random) => (x, y, z) =>
    Math.min(1, Math.max(0, 0.5 - 9 * (blob(x, y, z) - 0.33) + 0.4 * (random() - 0.5))),
  'thin shells': () => (x, y, z) => 0.5 + 0.5 * Math.tanh(8 * Math.sin(55 * blob(x, y, z))),
  specks: (random) => () => (random() < 0.002 ? 0.6 + 0.4 * random() : 0.08),
  'smooth, with a fine stripe': () => (x, y, z) =>
    0.3 +
    0.3 * Math.sin(4 * x + 3 * y) * Math.sin(5 * z) +
    (Math.abs(y - 0.5 - 0.1 * Math.sin(9 * x)) < 0.006 ? 0.35 : 0),
};

const looks = [
  '0 #247 0, 255 #fd8 25%',
  '0 #fd8 0, 120 #fd8 0, 150 #fd8 100%, 255 #fff 100%',
  '0 #247 0, 70 #247 2%, 128 #fa6 30%, 200 #fff 80%, 255 #fff 80%',
  '0 #48c 0, 89 #48c 0, 90 #48c 60%, 91 #48c 0, 159 #f93 0, 160 #f93 60%, 161 #f93 0, 255 #fff 0',
];

/** What was said of a view and what was true, in 1/255. */
export interface DetailView {
  readonly field: string;
  readonly look: number;
  readonly maxError: number;
  /** Share of all bricks. */
  readonly share: number;
  readonly said: number;
  readonly true: CoveredError;
}

/** @param count - of views, the same in every run @param hasTable - whether the writer of the pyramid says what its levels hide, as `volume-view-prepare` does */
export async function* measureViews(count: number, hasTable = false): AsyncGenerator<DetailView> {
  const names = Object.keys(fields);
  const random = randomNumbers(11);
  const perField = Math.ceil(count / names.length);
  for (const name of names) {
    const field = fields[name](randomNumbers(3));
    const whole = syntheticVolume({ dimensions: [edge, edge, edge], field, slope: 255 });
    for (let n = 0; n < perField; n++) yield await measureView(name, whole, random, hasTable);
  }
}

async function measureView(field: string, whole: Volume, random: () => number, hasTable: boolean): Promise<DetailView> {
  const { center, radius } = boundingSphere(whole.grid);
  const fieldOfView = 0.6;
  const orbit = {
    theta: 6.3 * random(),
    phi: 0.3 + 2.5 * random(),
    radius: framingDistance(radius, fieldOfView, 1) * (0.45 + 0.55 * random()),
  };
  const camera = orbitCamera(orbit, center, fieldOfView);
  const view = { view: viewMatrix(camera), projection: projectionMatrix(fieldOfView, 1, 1, 2) };
  const rays = setUpRays(whole.grid, view.view, view.projection)!;
  const look = Math.floor(looks.length * random());
  const transferFunction = parseTransferFunction(looks[look], [0, 255]);
  const optics: VolumeOptics = {
    transferFunction,
    window: [0, 255],
    referenceLength: edge / 4,
    opacityFactor: 1,
    lightFactor: 1,
    projection: null,
    shading: 'unlit',
    surfaces: null,
  };
  const bricked = cutIntoBricks(whole, 3, () => false);
  const detail = new ResidentDetail(bricked.volume.finer.volume, bricked.volume.finer);
  if (hasTable) detail.take(measureResiduals(bricked.pyramid, blockOfResiduals(whole.grid.dimensions)), [0, 1, 2]);
  const { finer } = bricked.volume;
  const choice = new BrickChoice(finer, detail);
  const maxError = errors[Math.floor(errors.length * random())];
  const wish = { key: 'view', maxError, slots: Infinity, isAsking: false, isRefused: () => false };
  // As `BrickView` does it: probes come first, level by level; then what brings most, until what is expected is within the share of `max-error`.
  let chosen: ChosenBricks;
  for (;;) {
    const found = atOnce(await choice.estimate(bricked.volume, { key: wish.key, view, optics }))!;
    chosen = choice.choose(found, wish);
    for (const brick of chosen.probes) detail.measure(brick, readBrick(bricked.pyramid, brick), true);
    if (chosen.probes.length > 0) continue;
    detail.forgetProbes();
    if (chosen.again) continue;
    if (chosen.missing.length === 0) break;
    for (const { brick } of chosen.missing) {
      const samples = readBrick(bricked.pyramid, brick);
      detail.measure(brick, samples);
      finer.add(brick, samples);
    }
    finer.current(bricked.volume);
  }
  const said = chosen.error.rms;
  const draw = (volume: Volume): Float64Array =>
    drawInFloat64(volume, { transferFunction, rays, stepLength: stepOfTruth * finestSpacing(whole.grid) });
  return {
    field,
    look,
    maxError,
    share: shareOf(bricked),
    said,
    true: compareCovered(draw(bricked.volume), draw(whole), 255),
  };
}

const shareOf = ({ volume: { finer } }: Bricked): number =>
  finer.count / finer.layout.levels.reduce((sum, { bricks: [x, y, z] }) => sum + x * y * z, 0);

function drawInFloat64(
  volume: Volume,
  {
    transferFunction,
    rays,
    stepLength,
  }: { readonly transferFunction: TransferFunction; readonly rays: RaySetup; readonly stepLength: number },
): Float64Array {
  const { grid, samples, slope, intercept } = volume;
  const dimensions: Vector3 = grid.dimensions;
  return renderReference(
    {
      grid,
      samples,
      slope,
      intercept,
      transferFunction,
      referenceLength: edge / 4,
      opacityFactor: 1,
      lightFactor: 1,
      stepLength,
      field: cartesianField({ ...volume, dimensions }),
    },
    rays,
    across,
    across,
  );
}
