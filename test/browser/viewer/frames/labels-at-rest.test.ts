// Labels in the picture at rest: nothing small is lost, and the error that is stated holds.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../../src/optics/rays/camera.ts';
import { parseTransferFunction } from '../../../../src/optics/transfer/parse-transfer-function.ts';
import type { TransferFunction } from '../../../../src/optics/transfer/transfer-function.ts';
import { allSubsteps } from '../../../../src/optics/cells/substeps.ts';
import type { Substeps } from '../../../../src/optics/cells/substeps.ts';
import { cutSteps } from '../../../../src/quality/levels.ts';
import { autoSteps, stepLengthOf } from '../../../../src/quality/steps.ts';
import { QualityControl } from '../../../../src/viewer/frames/quality-control.ts';
import { boundingSphere } from '../../../../src/volume/grid.ts';
import { transformPoint } from '../../../../src/volume/matrix.ts';
import type { ShownLabels } from '../../../../src/volume/labels.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { measureThing, measureTrueError } from '../../../accuracy/compare-shown.ts';
import { findPixel } from '../../../accuracy/full-rays.ts';
import { casesOf } from '../../../helpers/cases.ts';
import { changePlan } from '../../../helpers/change-plan.ts';
import { settle } from '../../../helpers/at-rest.ts';
import { blocks, labelMap, mixedGroups, mixedAppearances, plainAppearance } from '../../../helpers/labels.ts';
import { shareScene } from '../../../helpers/picture.ts';
import { randomNumbers, syntheticVolume } from '../../../helpers/synthetic.ts';
import { probe } from '../../../helpers/probe.ts';

const size = 60;
const picture = { width: size, height: size };

/**
 * Of a thing's contrast in full rays, the least that the picture at rest has; and what counts as a thing, 1/255: ten of it may be lost, see
 * quality/levels.ts. A ray may just touch a label.
 */
const [minKept, minContrast] = [0.75, 40];

interface LabelScene {
  readonly name: string;
  readonly volume: Volume;
  readonly transferFunction: TransferFunction;
  readonly labels: ShownLabels;
  /** Where small things are, voxels. */
  readonly places: readonly Vector3[];
  readonly pixelsPerVoxel: number;
  /** Of the camera, from above. */
  readonly phi: number;
}

const random = randomNumbers(12);

/** Cubes of a label at random places of a smooth volume. */
function scatter(
  name: string,
  edge: number,
  appearance: Omit<LabelScene, 'name' | 'labels' | 'places'> & Pick<ShownLabels, 'styles' | 'functions'>,
): LabelScene {
  const { dimensions } = appearance.volume.grid;
  const corners = Array.from({ length: 40 }, () => dimensions.map((n) => 3 + Math.floor(random() * (n - 8))));
  const map = labelMap(
    dimensions,
    (...at) => Number(corners.some((corner) => corner.every((low, axis) => at[axis] >= low && at[axis] < low + edge))),
    2,
  );
  return {
    ...appearance,
    name,
    labels: { map, styles: appearance.styles, functions: appearance.functions },
    places: corners.map((corner) => corner.map((low) => low + (edge - 1) / 2) as unknown as Vector3),
  };
}

// Flat ones, of which specks are seen from above: what is less deep takes less long, and as many things are looked at.
const veil = syntheticVolume({ dimensions: [36, 36, 8], field: (x, y) => 0.4 + 0.05 * x - 0.04 * y });
const smooth = syntheticVolume({ dimensions: [40, 14, 32] });
const attached = { pixelsPerVoxel: 1.05, phi: 1.1 };
const faint = parseTransferFunction('0 #cde 0.6%, 1 #cde 0.6%', [0, 1]);
const fog = parseTransferFunction('0 #246 0, 0.3 #fa6 5%, 1 #fff 30%', [0, 1]);
const dense = parseTransferFunction('0 #246 0, 0.2 #246 0, 0.3 #fa6 60%, 1 #fff 90%', [0, 1]);
const halves = labelMap([40, 14, 32], (i, j) => Number(i + 0.3 * j > 22), 2);

const scenes: readonly LabelScene[] = [
  scatter('specks of 1 voxel, dense in a veil', 1, {
    volume: veil,
    transferFunction: faint,
    styles: [plainAppearance, { color: [1, 0.7, 0.4], opacityFactor: 150 }],
    pixelsPerVoxel: 1.6,
    phi: 0.7,
  }),
  scatter('specks of 2 voxels, dense in a veil', 2, {
    volume: veil,
    transferFunction: faint,
    styles: [plainAppearance, { color: [1, 0.7, 0.4], opacityFactor: 150 }],
    pixelsPerVoxel: 1,
    phi: 0.7,
  }),
  scatter('specks of 1 voxel, of which alone something shows', 1, {
    volume: veil,
    transferFunction: parseTransferFunction('0 #fff 60%, 1 #fff 60%', [0, 1]),
    styles: [{ ...plainAppearance, opacityFactor: 0 }, plainAppearance],
    pixelsPerVoxel: 1.6,
    phi: 0.7,
  }),
  scatter('specks of 1 voxel in a group of their own', 1, {
    volume: veil,
    transferFunction: faint,
    styles: [plainAppearance, { ...plainAppearance, group: 1 }],
    functions: [parseTransferFunction('0 #fb6 60%, 1 #fb6 60%', [0, 1])],
    pixelsPerVoxel: 1.6,
    phi: 0.7,
  }),
  {
    name: 'an atlas of blocks in five groups',
    volume: smooth,
    transferFunction: fog,
    labels: mixedGroups(blocks([40, 14, 32], 20, 6)),
    places: [],
    ...attached,
  },
  {
    name: 'an atlas of blocks in fog',
    volume: smooth,
    transferFunction: fog,
    labels: mixedAppearances(blocks([40, 14, 32], 20, 6)),
    places: [],
    ...attached,
  },
  {
    name: 'half of what is dense is hidden',
    volume: smooth,
    transferFunction: dense,
    labels: { map: halves, styles: [plainAppearance, { ...plainAppearance, opacityFactor: 0 }] },
    places: [],
    ...attached,
  },
];

const percent = (shares: readonly number[]): string => `${(100 * Math.min(...shares)).toFixed(0)} %`;

/** One of small things, and one of groups. */
const tested = casesOf(scenes, (_, i) => i === 0 || i === 4);

describe('labels in the picture at rest', () => {
  const scene = shareScene({});
  const ratios: number[] = [];

  for (const { name, volume, transferFunction, labels, places, pixelsPerVoxel, phi } of tested) {
    it(name, async function () {
      this.timeout(60_000);
      const { center } = boundingSphere(volume.grid);
      const camera = orbitCamera(
        { theta: 0.7, phi, radius: size / pixelsPerVoxel / (2 * Math.tan(0.15)) },
        center,
        0.3,
      );
      changePlan(scene(), { picture: { width: size, height: size } });
      scene().setVolume(volume);
      await scene().setAppearance({
        optics: { transferFunction, referenceLength: 1, opacityFactor: 1, lightFactor: 1 },
      });
      await scene().setLabels(labels);
      changePlan(scene(), { camera });
      const control = new QualityControl();
      const { steps, substeps } = await settle(control, scene(), { volume, size: picture });
      const shown = scene().readPicture().data;
      const cast = (stepsPerVoxel: number, substeps: Substeps = allSubsteps): Float32Array => {
        changePlan(scene(), { substeps });
        return probe(
          scene(),
          [stepLengthOf(volume.grid, stepsPerVoxel * autoSteps(volume.grid))],
          { stride: 1, first: [0, 0], ...picture },
          picture,
        )![0];
      };
      const full = cast(16); // Twice the finest level's steps: a picture of that level would be held against itself.
      const error = measureTrueError(shown, full);
      const { rms, max } = control.error!;
      ratios.push(rms / error.rms);
      const one = autoSteps(volume.grid);
      console.log(
        `${name}: ${steps / one} steps a voxel, ${substeps} substeps; stated ${rms.toFixed(2)}, true ${error.rms.toFixed(2)}; largest: stated ${max?.toFixed(1)}, true ${error.max.toFixed(1)}`,
      );
      expect(max, 'the largest error').to.be.at.least(error.max);
      if (places.length === 0) return;
      const [fine, coarse] = [cutSteps({ steps: one, substeps: 1 }, one, 1), { ...allSubsteps, max: 1 }].map(
        (substeps) => cast(1, substeps),
      );
      await scene().setLabels({ ...labels, styles: labels.styles.map(() => labels.styles[0]) });
      const bare = cast(4);
      const listKept = (drawn: Uint8Array): number[] =>
        places.flatMap((place) => {
          const thing = measureThing(
            { shown: drawn, full, bare, size },
            findPixel(camera, transformPoint(volume.grid.indexToWorld, place), size),
            Math.max(1, pixelsPerVoxel),
          );
          return thing && thing.contrast >= minContrast ? [thing.kept] : [];
        });
      const [kept, keptByDetail, keptWithout] = [
        shown,
        ...[fine, coarse].map((floats) => Uint8Array.from(floats, (x) => Math.round(255 * x))),
      ].map(listKept);
      console.log(
        `${name}: ${kept.length} things, at least ${percent(kept)} kept, at one step a voxel ${percent(keptByDetail)}, without detail ${percent(keptWithout)}`,
      );
      expect(kept.length, 'things that full rays show').to.be.at.least(25);
      for (const shares of [kept, keptByDetail])
        expect(
          shares.filter((share) => share < minKept),
          'dimmed',
        ).to.deep.equal([]);
      if (name.includes('1 voxel')) expect(Math.min(...keptWithout), 'without a closer look').to.be.below(0.5);
    });
  }

  it('is said to be off by what it is, within a factor of two', () => {
    expect(ratios.length).to.equal(tested.length);
    expect(ratios.filter((ratio) => ratio < 0.5 || ratio > 2)).to.deep.equal([]);
  });
});
