// Surfaces of values, styles, light, labels and a layer in one picture: the GPU against the twin in float64, and that skipping changes no byte.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../src/optics/camera.ts';
import { uncut } from '../../src/optics/cut-fade.ts';
import { domainOf } from '../../src/optics/emission.ts';
import { cartesianGradient, flatChange } from '../../src/optics/gradient.ts';
import { groupedStagesOf, groupOptics } from '../../src/optics/label-groups.ts';
import { litShade, pointField } from '../../src/optics/lit.ts';
import type { RayStyle } from '../../src/optics/ray-style.ts';
import { cartesianField } from '../../src/optics/ray-field.ts';
import type { RayStages } from '../../src/optics/ray-stages.ts';
import { renderStages } from '../../src/optics/reference.ts';
import { styledShade } from '../../src/optics/styled.ts';
import type { VolumeStyle } from '../../src/optics/volume-styles.ts';
import { polarBeamField } from '../../src/radar/polar-field.ts';
import { polarGradient } from '../../src/radar/polar-gradient.ts';
import { boundingSphere, longestDiagonal } from '../../src/volume/grid.ts';
import { buildMacrocells } from '../../src/volume/macrocells.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { cutRegion } from '../../src/volume/region.ts';
import { isPolar } from '../../src/volume/volume.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { cutBox, keep } from '../helpers/clips.ts';
import { isEdge, listOff } from '../helpers/edges.ts';
import { blocks, mixedGroups, mixedLooks } from '../helpers/labels.ts';
import { askew, overlayOf, waves } from '../helpers/overlays.ts';
import { comparePictures, drawPicture, height, plainOptics, raysOf, referenceOf, shareScene, width } from '../helpers/picture.ts';
import type { View } from '../helpers/picture.ts';
import { cloudCamera, cloudColors, cloudVolume } from '../helpers/polar-cloud.ts';
import { remember } from '../helpers/remember.ts';
import { surfaceStages } from '../helpers/surfaces.ts';
import { smoothField, syntheticVolume } from '../helpers/synthetic.ts';

const dimensions: Vector3 = [24, 20, 16];
const three: RayStyle = {
  surfaces: [{ value: 0.35, color: [1, 0.4, 0.2], opacity: 0.3 }, { value: 0.5, color: [0.2, 0.9, 0.5], opacity: 0.5 }, { value: 0.65, color: [1, 1, 0.9], opacity: 1 }],
};
const shaded: VolumeStyle = { kind: 'shaded', material: { ambient: 0.1, diffuse: [0.9, 0.6, 0.5], specular: [0.1, 0.1, 0.2], emissive: [0.15, 0, 0], shininess: 20 } };
const silhouette: VolumeStyle = { kind: 'silhouette', retained: 0.4, boundary: 1.2, sharpness: 2 };
const styles: RayStyle = { styles: [{ weight: 1, styles: [silhouette, shaded] }] };
const hole = (x: number, y: number, z: number): number => (Math.hypot(x - 0.4, y - 0.5, z - 0.5) < 0.3 ? NaN : smoothField(x, y, z));

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
  return { volume, camera: orbitCamera({ theta: 0.6, phi: 1.2, radius: 1.4 * diagonal }, boundingSphere(volume.grid).center, 0.6), stepLength: diagonal / 60, ...more };
}

const whole = syntheticVolume({ dimensions, kind: 'uint16' });
const holed = ((): Volume => {
  const made = syntheticVolume({ dimensions, kind: 'float32', field: hole });
  return { ...made, hasNoData: true, macrocells: buildMacrocells(made.samples, dimensions) };
})();
const mixed = overlayOf(whole, layerOver(whole));
const overHole = overlayOf(holed, layerOver(holed));

interface Case {
  readonly view: () => View;
  readonly style: RayStyle;
  readonly webgl1?: boolean;
}

const cases: Record<string, Case> = {
  'surfaces in styled fog': { view: () => viewOf(whole), style: { ...three, ...styles }, webgl1: true },
  'surfaces in lit fog, a layer and labels': { view: () => viewOf(whole, { overlay: mixed, labels: mixedLooks(blocks(dimensions, 6)) }), style: { ...three, lit: true } },
  'surfaces, groups of labels, and a layer that colours': { view: () => viewOf(whole, { overlay: { ...mixed, blend: 'color' }, labels: mixedGroups(blocks(dimensions, 12)) }), style: three },
  'styles, and a layer where there is no data': { view: () => viewOf(holed, { overlay: overHole }), style: styles, webgl1: true },
  'surfaces in lit fog, and a layer where there is no data': { view: () => viewOf(holed, { overlay: overHole }), style: { ...three, lit: true }, webgl1: true },
  'styles, groups of labels, a layer, all of it cut': { view: () => viewOf(whole, {
    overlay: mixed, labels: mixedGroups(blocks(dimensions, 12)), region: cutRegion(whole.grid, [-9, -9, -7, 12, 10, 6]),
    clips: { kept: [keep(whole.grid, [1, -0.4, 0.3], -8)], cutout: cutBox(whole.grid, [2, -4, -3], [9, 4, 20]) },
  }), style: styles },
  'one value everywhere': { view: () => {
    const flat = syntheticVolume({ dimensions, kind: 'float32', field: () => 0.5 });
    return viewOf(flat, { overlay: overlayOf(flat, layerOver(flat)) });
  }, style: { ...three, ...styles } },
  'labels as the volume': { view: () => {
    const made = syntheticVolume({ dimensions, field: (x, y, z) => Math.floor(smoothField(x, y, z) * 6) / 255 });
    const volume: Volume = { ...made, slope: 1, isDiscrete: true };
    return viewOf(volume, { overlay: overlayOf(volume, layerOver(volume)), optics: { ...plainOptics, transferFunction: [{ value: 0, color: [0, 0, 0.4], opacity: 0 }, { value: 2, color: [1, 0.3, 0.1], opacity: 0.1 }, { value: 5, color: [1, 1, 0.8], opacity: 0.4 }] } });
  }, style: { ...three, ...styles, lit: true } },
  'a projection, whatever else': { view: () => viewOf(holed, { overlay: overHole, projection: 'max', labels: mixedGroups(blocks(dimensions, 12)) }), style: { projection: 'max', ...three, ...styles } },
  'a radar': { view: () => {
    const volume = cloudVolume(1);
    return { volume, camera: cloudCamera, stepLength: longestDiagonal(volume.grid) / 200, optics: { ...plainOptics, transferFunction: cloudColors, referenceLength: 3000 }, overlay: overlayOf(volume, { ...volume, range: [0, 1] }, { blend: 'mix', transferFunction: cloudColors.slice(20) }) };
  }, style: { surfaces: [{ value: 0.3, color: [0.3, 0.8, 1], opacity: 0.4 }, { value: 0.6, color: [1, 0.6, 0.2], opacity: 1 }], ...styles }, webgl1: true },
};

/** The stages of a view's rays in a style. */
function stagesOf(view: View, { surfaces, styles: chains, lit, clear, projection }: RayStyle): RayStages {
  const { volume, optics = plainOptics, clips, labels } = view;
  const { grid, range } = volume;
  const scene = referenceOf(view);
  const rays = raysOf(view);
  const groups = groupOptics((!projection && labels?.functions) || [], scene);
  if (projection || volume.isDiscrete) return groupedStagesOf(scene, rays, groups);
  const gradient = isPolar(volume) ? polarGradient(polarBeamField(volume), volume.grid) : cartesianGradient(cartesianField({ ...volume, dimensions: grid.dimensions }), grid);
  const cuts = { ...uncut, unitToRegion: rays.unitToRegion, halfSpaces: clips?.kept ?? [], unitToCutout: clips?.cutout?.unitToBox ?? null };
  const { referenceLength, opacityFactor, transferFunction } = optics;
  const all = { grid, gradient, flat: flatChange(domainOf(transferFunction), range), cuts };
  const last = chains && !clear ? [styledShade({ ...all, chains, referenceLength, opticalScale: (rays.diameter / referenceLength) * opacityFactor })] : lit && !clear ? [litShade(all)] : [];
  const more = surfaces ? { gather: surfaceStages(volume, { surfaces, clear }, transferFunction, { cuts }).gather } : {};
  return groupedStagesOf({ ...scene, ...more, moreFields: [...scene.moreFields!, pointField], shades: [...scene.shades!, ...last] }, rays, groups);
}

const expectationOf = remember((name: string) => {
  const { view: make, style } = cases[name];
  const view = make();
  const stages = stagesOf(view, style);
  return { view, stages, expected: renderStages(stages, raysOf(view), width, height).map((x) => x * 255) };
});

for (const version of [2, 1] as const) {
  describe(`together in WebGL ${version}`, () => {
    const scene = shareScene({ webgl1: version === 1 });
    for (const name of Object.keys(cases).filter((one) => version === 2 || cases[one].webgl1)) {
      it(`are the twin's: ${name}; and skipping changes no byte`, async function () {
        this.timeout(240_000);
        const { view, stages, expected } = expectationOf(name);
        await scene().prepare(view.volume);
        scene().setVolume(view.volume);
        await scene().setStyle(cases[name].style);
        await scene().setLabels(view.labels ?? null);
        await scene().setOverlay(view.overlay ?? null);
        const got = drawPicture(scene(), view);
        const rays = raysOf(view);
        const off = listOff(got, expected);
        const edges = new Set([...off].filter((pixel) => isEdge(stages, rays, pixel)));
        const { worst, rmse } = comparePictures(got, expected, (pixel) => edges.has(pixel));
        const names = scene().layers[0].modules(false).map((module) => module.name);
        console.log(`WebGL ${version} ${name}: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)}, ${off.size} off, ${edges.size} edges; ${names.join(' ')}`);
        const differs = [1, 4].map((factor) => {
          const [skipped, plain] = [true, false].map((skipping) => {
            scene().layers[0].skipping = skipping;
            return drawPicture(scene(), { ...view, stepLength: view.stepLength * factor });
          });
          scene().layers[0].skipping = true;
          return comparePictures(skipped, plain).worst;
        });
        console.log('skipping', ...differs);
        expect(worst, 'worst pixel').to.be.at.most(2);
        expect(edges.size, 'edges').to.be.below(0.02 * width * height);
        expect(Math.max(...differs), 'skipping').to.equal(0);
      });
    }
  });
}
