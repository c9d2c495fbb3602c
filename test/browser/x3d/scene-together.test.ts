// Surfaces of values, styles, light, labels and a layer in one picture: the GPU against the twin in float64, and that skipping changes no byte.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import { uncut } from '../../../src/optics/rays/cut-fade.ts';
import { domainOf } from '../../../src/optics/transfer/emission.ts';
import { cartesianGradient, flatChange } from '../../../src/optics/rays/gradient.ts';
import { litShade, pointField } from '../../../src/optics/rays/lit.ts';
import type { RayStyle } from '../../../src/optics/rays/ray-style.ts';
import { cartesianField } from '../../../src/optics/rays/ray-field.ts';
import type { RayStages } from '../../../src/optics/rays/ray-stages.ts';
import { stagesOf as stagesOfScene, renderStages } from '../../../src/optics/reference.ts';
import { styledShade } from '../../../src/optics/rays/styled.ts';
import type { VolumeStyle } from '../../../src/optics/transfer/volume-styles.ts';
import { boundingSphere, longestDiagonal } from '../../../src/volume/grid.ts';
import { buildMacrocells } from '../../../src/volume/macrocells.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { cutRegion } from '../../../src/volume/region.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import type { VolumeScene } from '../../../src/x3d/scene.ts';
import { cutBox, keep } from '../../helpers/clips.ts';
import { isEdge, listOff } from '../../helpers/edges.ts';
import { blocks, mixedGroups, mixedAppearances } from '../../helpers/labels.ts';
import { askew, overlayOf, waves } from '../../helpers/overlays.ts';
import {
  comparePictures,
  drawPicture,
  height,
  plainOptics,
  raysOf,
  referenceOf,
  shareScene,
  width,
  walksOf,
} from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { remember } from '../../helpers/remember.ts';
import { surfaceStages } from '../../helpers/surfaces.ts';
import { smoothField, syntheticVolume } from '../../helpers/synthetic.ts';

const dimensions: Vector3 = [24, 20, 16];
const three: RayStyle = {
  surfaces: [
    { value: 0.35, color: [1, 0.4, 0.2], opacity: 0.3 },
    { value: 0.5, color: [0.2, 0.9, 0.5], opacity: 0.5 },
    { value: 0.65, color: [1, 1, 0.9], opacity: 1 },
  ],
};
const shaded: VolumeStyle = {
  kind: 'shaded',
  material: {
    ambient: 0.1,
    diffuse: [0.9, 0.6, 0.5],
    specular: [0.1, 0.1, 0.2],
    emissive: [0.15, 0, 0],
    shininess: 20,
  },
};
const silhouette: VolumeStyle = { kind: 'silhouette', retained: 0.4, boundary: 1.2, sharpness: 2 };
const styles: RayStyle = { styles: [{ weight: 1, styles: [silhouette, shaded] }] };
const hole = (x: number, y: number, z: number): number =>
  Math.hypot(x - 0.4, y - 0.5, z - 0.5) < 0.3 ? NaN : smoothField(x, y, z);

/** The layer lies askew, has a hole, and shows where the volume has none. */
function layerOver(over: Volume): Volume {
  const own: Vector3 = [14, 12, 18];
  const made = syntheticVolume({ dimensions: own, kind: 'float32', indexToWorld: askew(over, own), field: waves });
  made.samples.forEach((_, at) => {
    if (at % 14 < 4) made.samples[at] = NaN;
  });
  return { ...made, hasNoData: true, macrocells: buildMacrocells(made.samples, own) };
}

function viewOf(volume: Volume, more: Partial<View> = {}): View {
  const diagonal = longestDiagonal(volume.grid);
  return {
    volume,
    camera: orbitCamera({ theta: 0.6, phi: 1.2, radius: 1.4 * diagonal }, boundingSphere(volume.grid).center, 0.6),
    stepLength: diagonal / 45,
    ...more,
  };
}

const whole = syntheticVolume({ dimensions, kind: 'uint16' });
const holed = ((): Volume => {
  const made = syntheticVolume({ dimensions, kind: 'float32', field: hole });
  return { ...made, hasNoData: true, macrocells: buildMacrocells(made.samples, dimensions) };
})();
const mixed = overlayOf(whole, layerOver(whole), { blend: 'color' });
const overHole = overlayOf(holed, layerOver(holed));

interface Case {
  readonly view: () => View;
  readonly style: RayStyle;
  readonly webgl1?: boolean;
}

const cases: Record<string, Case> = {
  'surfaces in styled fog, and a layer where there is no data': {
    view: () => viewOf(holed, { overlay: overHole }),
    style: { ...three, ...styles },
    webgl1: true,
  },
  'surfaces in lit fog, labels, and a layer where there is no data': {
    view: () => viewOf(holed, { overlay: overHole, labels: mixedAppearances(blocks(dimensions, 6)) }),
    style: { ...three, lit: true },
  },
  'styles, groups of labels, and a layer that colours, all of it cut': {
    view: () =>
      viewOf(whole, {
        overlay: mixed,
        labels: mixedGroups(blocks(dimensions, 12)),
        region: cutRegion(whole.grid, [-9, -9, -7, 12, 10, 6]),
        clips: { kept: [keep(whole.grid, [1, -0.4, 0.3], -8)], cutout: cutBox(whole.grid, [2, -4, -3], [9, 4, 20]) },
      }),
    style: styles,
  },
};

/** The stages of a view's rays in a style. */
function stagesOf(view: View, { surfaces, styles: chains }: RayStyle): RayStages {
  const {
    volume: { grid, ...volume },
    clips,
    labels,
  } = view;
  const scene = referenceOf(view);
  const rays = raysOf(view);
  const cuts = {
    ...uncut,
    unitToRegion: rays.unitToRegion,
    halfSpaces: clips?.kept ?? [],
    unitToCutout: clips?.cutout?.unitToBox ?? null,
  };
  const { referenceLength, opacityFactor, transferFunction } = plainOptics;
  const gradient = cartesianGradient(cartesianField({ ...volume, dimensions }), grid);
  const all = { grid, gradient, flat: flatChange(domainOf(transferFunction), volume.range), cuts };
  const last = chains
    ? styledShade({ ...all, chains, referenceLength, opticalScale: (rays.diameter / referenceLength) * opacityFactor })
    : litShade(all);
  const gather = surfaces && surfaceStages(view.volume, { surfaces }, transferFunction, { cuts }).gather;
  const more = {
    moreFields: [...scene.moreFields!, pointField],
    shades: [...scene.shades!, last],
    ...(gather && { gather }),
  };
  return stagesOfScene({ ...scene, ...more, functions: labels?.functions }, rays);
}

const expectationOf = remember((name: string) => {
  const { view: make, style } = cases[name];
  return walksOf(make(), Object.keys(cases).indexOf(name)).map((view) => {
    const stages = stagesOf(view, style);
    return { view, stages, expected: renderStages(stages, raysOf(view), width, height).map((x) => x * 255) };
  });
});

/** By how much a picture is another one where nothing is skipped, 1/255. */
function skippingChanges(scene: VolumeScene, view: View): number {
  const [skipped, plain] = [true, false].map((skipping) => {
    scene.layers[0].skipping = skipping;
    return drawPicture(scene, view);
  });
  scene.layers[0].skipping = true;
  return comparePictures(skipped, plain).worst;
}

for (const version of [2, 1] as const) {
  describe(`together in WebGL ${version}`, () => {
    const scene = shareScene({ webgl1: version === 1 });
    for (const name of Object.keys(cases).filter((one) => version === 2 || cases[one].webgl1)) {
      it(`are the twin's: ${name}; and skipping changes no byte`, async function () {
        this.timeout(240_000);
        for (const { view, stages, expected } of expectationOf(name)) {
          await scene().prepare(view.volume);
          scene().setVolume(view.volume);
          await scene().setAppearance({ style: cases[name].style });
          await scene().setLabels(view.labels ?? null);
          await scene().setOverlay(view.overlay ?? null);
          const got = drawPicture(scene(), view);
          const rays = raysOf(view);
          const off = listOff(got, expected);
          const edges = new Set([...off].filter((pixel) => isEdge(stages, rays, pixel)));
          const { worst, rmse } = comparePictures(got, expected, (pixel) => edges.has(pixel));
          console.log(
            `WebGL ${version} ${name}: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)}, ${edges.size} edges`,
          );
          expect(worst, 'worst pixel').to.be.at.most(2);
          expect(edges.size, 'edges').to.be.below(0.02 * width * height);
          expect(
            Math.max(
              ...[1, 4].map((factor) => skippingChanges(scene(), { ...view, stepLength: view.stepLength * factor })),
            ),
            'skipping',
          ).to.equal(0);
        }
      });
    }
  });
}

describe('in WebGL 1', () => {
  const scene = shareScene({ webgl1: true });

  it('styles have the room of a layer that is left out', async () => {
    scene().setVolume(whole);
    await scene().setAppearance({ style: styles });
    await scene().setLabels(mixedGroups(blocks(dimensions, 12)));
    await scene().setOverlay(mixed);
    const names = scene()
      .layers[0].modules(false)
      .map(({ name }) => name);
    expect(names).to.include.members(['labelFunctions', 'styled']).and.not.include('overlay');
  });
});
