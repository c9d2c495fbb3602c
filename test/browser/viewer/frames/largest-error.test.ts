// The largest error that is stated of a picture at rest is not exceeded where surfaces, or gradients alone, make values show.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../../src/optics/rays/camera.ts';
import type { Camera } from '../../../../src/optics/rays/camera.ts';
import { outlinePatches } from '../../../../src/optics/transfer/patches.ts';
import type { Patch } from '../../../../src/optics/transfer/patches.ts';
import type { RayStyle } from '../../../../src/optics/rays/ray-style.ts';
import type { TransferFunction } from '../../../../src/optics/transfer/transfer-function.ts';
import { allSubsteps } from '../../../../src/optics/cells/substeps.ts';
import { autoSteps, stepLengthOf } from '../../../../src/quality/steps.ts';
import { QualityControl } from '../../../../src/viewer/frames/quality-control.ts';
import { boundingSphere } from '../../../../src/volume/grid.ts';
import { buildMacrocells } from '../../../../src/volume/macrocells.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { measureTrueError } from '../../../accuracy/compare-shown.ts';
import { errorScenes } from '../../../accuracy/error-scenes.ts';
import { casesOf } from '../../../helpers/cases.ts';
import { changePlan } from '../../../helpers/change-plan.ts';
import { settle } from '../../../helpers/at-rest.ts';
import { shareScene } from '../../../helpers/picture.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';
import { probe } from '../../../helpers/probe.ts';

/** A flat one: what is deeper than the specks need only takes time. */
const dimensions = [52, 6, 44] as const;

/** Specks of one voxel, all in two cells at corners that are far apart: what all other cells have is crossed at once, and few pixels of many show something. */
const places = [
  [50, 2, 2],
  [49, 3, 6],
  [2, 3, 41],
  [6, 2, 42],
] as const;

/** One value, but for a few voxels. */
function specks(): Volume {
  const volume = syntheticVolume({ dimensions, field: () => 0.4 });
  for (const [i, j, k] of places) volume.samples[i + dimensions[0] * (j + dimensions[1] * k)] = 200;
  return { ...volume, macrocells: buildMacrocells(volume.samples, dimensions) };
}

const noise = errorScenes().find(({ name }) => name === 'noise, smooth, 90 steps')!;

const band: Patch = { kind: 'box', values: [0.05, 0.95], gradients: [0.15, 0.25], color: [1, 0.5, 0.2], opacity: 0.99 };

interface Scene {
  readonly volume: Volume;
  readonly style: RayStyle;
  readonly transferFunction: TransferFunction;
  readonly camera: Camera;
  readonly size: { readonly width: number; readonly height: number };
  /** Whether full rays are good enough to tell the mean too. */
  readonly saysMean?: boolean;
}

const scenes: Record<string, () => Scene> = {
  'specks that show by their gradients': () => {
    const volume = specks();
    const camera = orbitCamera({ theta: 0.9, phi: 1.2, radius: 189 }, boundingSphere(volume.grid).center, 0.3);
    return {
      volume,
      style: { patches: [band] },
      transferFunction: outlinePatches([band], volume.range),
      camera,
      size: { width: 200, height: 200 },
      saysMean: true,
    };
  },
  'surfaces in noise': () => ({
    ...noise,
    style: {
      lit: true,
      surfaces: [
        { value: 0.42, color: [1, 0.6, 0.4], opacity: 0.4 },
        { value: 0.62, color: [0.8, 0.9, 1], opacity: 1 },
      ],
    },
    size: { width: 96, height: 72 },
  }),
};

describe('the largest error that a picture at rest states', () => {
  const shared = shareScene({});
  for (const [name, make] of casesOf(Object.entries(scenes), (_, i) => i === 1)) {
    it(`is not exceeded: ${name}`, async function () {
      this.timeout(240_000);
      const gpu = shared();
      const { volume, style, transferFunction, camera, size, saysMean } = make();
      changePlan(gpu, { picture: size });
      gpu.setVolume(volume);
      await gpu.setAppearance({
        style,
        optics: { transferFunction, referenceLength: 1, opacityFactor: 1, lightFactor: 1 },
      });
      changePlan(gpu, { camera });
      const control = new QualityControl();
      await settle(control, gpu, { volume, size });
      const shown = gpu.readPicture().data;
      changePlan(gpu, { substeps: allSubsteps });
      const full = probe(
        gpu,
        [stepLengthOf(volume.grid, 10 * autoSteps(volume.grid))],
        { stride: 1, first: [0, 0], ...size },
        size,
      )![0];
      const error = measureTrueError(shown, full);
      console.log(
        `${name}: stated ${control.error!.rms.toFixed(2)}, ${control.error!.max?.toFixed(1)}, true ${error.rms.toFixed(2)}, ${error.max.toFixed(1)}`,
      );
      expect(error.max, 'there is some').to.be.above(5);
      const { max, probed } = control.error!;
      if (style.surfaces) {
        expect(max, 'a ray that touches a surface may be off by all of it').to.equal(null);
        expect(probed, 'all pixels are').to.be.within(0.5 * error.max, 2 * error.max);
      } else expect(max).to.be.at.least(error.max);
      if (saysMean) expect(control.error!.rms / error.rms).to.be.within(0.5, 2);
    });
  }
});
