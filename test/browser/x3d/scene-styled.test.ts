// X3D's rendering styles on the GPU against the twin in float64: two programs a context, as which styles there are is in a table.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import type { SceneLights } from '../../../src/optics/transfer/lights.ts';
import { renderReference } from '../../../src/optics/reference.ts';
import { withLight } from '../../../src/optics/transfer/volume-styles.ts';
import type { StyleChain, VolumeStyle } from '../../../src/optics/transfer/volume-styles.ts';
import { programKey } from '../../../src/renderer/ray/compose-ray.ts';
import { hasRoom } from '../../../src/renderer/ray/modules/styled.ts';
import type { RayText } from '../../../src/renderer/ray/ray-module.ts';
import { boundingSphere, longestDiagonal } from '../../../src/volume/grid.ts';
import { casesIn, takesAll } from '../../helpers/cases.ts';
import { lamp, styledStages } from '../../helpers/lit.ts';
import {
  bothWalks,
  comparePictures,
  drawPicture,
  height,
  plainOptics,
  raysOf,
  referenceOf,
  shareScene,
  width,
} from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { remember } from '../../helpers/remember.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';
import { viewOfCloud } from '../../helpers/views.ts';

const boundary: VolumeStyle = { kind: 'boundary', retained: 0.2, boundary: 0.9, power: 2 };
const silhouette: VolumeStyle = { kind: 'silhouette', retained: 0.3, boundary: 1.2, sharpness: 2 };
const edge: VolumeStyle = { kind: 'edge', color: [0.9, 0.1, 0], threshold: 1.1 };
const cartoon: VolumeStyle = { kind: 'cartoon', parallel: [1, 0.8, 0.3], orthogonal: [0.2, 0, 0.5], steps: 3 };
const tone: VolumeStyle = { kind: 'tone', cool: [0.1, 0.2, 0.8], warm: [1, 0.7, 0.2] };
const shaded: VolumeStyle = {
  kind: 'shaded',
  material: {
    ambient: 0.2,
    diffuse: [0.9, 0.8, 0.7],
    specular: [0.2, 0.2, 0.3],
    emissive: [0.05, 0, 0],
    shininess: 20,
  },
};

const chain = (...styles: VolumeStyle[]): readonly StyleChain[] => [{ weight: 1, styles }];

const steep: VolumeStyle = {
  kind: 'gradient',
  stops: [
    [0, 0.05],
    [0.02, 0.1],
    [0.06, 1],
  ],
};
/** A tenth as steep: gradients over metres. */
const gentle: VolumeStyle = {
  kind: 'gradient',
  stops: [
    [0.0001, 0],
    [0.003, 1],
  ],
};

const looks: Record<string, readonly StyleChain[]> = {
  boundary: chain(boundary),
  silhouette: chain(silhouette),
  edge: chain(edge),
  cartoon: chain(cartoon),
  'tone, then light': chain(tone, shaded),
  'gradient-opacity': chain(steep),
  'gradient-opacity in lit fog': withLight(chain(steep)),
  'gradient-opacity of a radar': chain(gentle),
  'all of them': chain(cartoon, tone, boundary, edge, shaded, silhouette, edge),
  'two blended': [
    { weight: 0.6, styles: [cartoon] },
    { weight: 0.4, styles: [silhouette, shaded, steep] },
  ],
};

const sun: SceneLights = {
  headlight: true,
  lights: [lamp],
};

const views: Record<string, () => View> = {
  cartesian: () => {
    const volume = syntheticVolume({ dimensions: [24, 20, 16], spacing: [1, 1.2, 0.9] });
    const diagonal = longestDiagonal(volume.grid);
    return {
      volume,
      camera: orbitCamera({ theta: 0.6, phi: 1.2, radius: 1.4 * diagonal }, boundingSphere(volume.grid).center, 0.6),
      stepLength: diagonal / 45,
      optics: { ...plainOptics, opacityFactor: 0.8 },
    };
  },
  polar: viewOfCloud,
};

const viewsOf = remember((name: string) => bothWalks(views[name]()));
const expectationOf = remember((view: View) =>
  remember((appearance: string) =>
    renderReference(
      { ...referenceOf(view), ...styledStages(view, looks[appearance], sun) },
      raysOf(view),
      width,
      height,
    ).map((x) => x * 255),
  ),
);

for (const version of [2, 1] as const) {
  describe(`rendering styles in WebGL ${version}`, () => {
    const scene = shareScene({ webgl1: version === 1 });
    for (const name of Object.keys(views)) {
      it(`are the twin's, without a program more: ${name}`, async function () {
        this.timeout(240_000);
        const layer = scene().layers[0];
        layer.lights = () => sun;
        const shown =
          name === 'polar'
            ? ['all of them', 'boundary', 'gradient-opacity of a radar']
            : Object.keys(looks).filter((one) => !one.endsWith('radar'));
        const cases = casesIn(version, shown, (one) => ['all of them', 'two blended'].includes(one));
        for (const [walk, view] of viewsOf(name).entries()) {
          const drawn = cases.filter((_, i) => takesAll || i % 2 === walk); // The two walks in turns.
          if (drawn.length === 0) continue;
          await scene().prepare(view.volume);
          const keys = new Set<string>();
          for (const appearance of drawn) {
            await scene().setAppearance({ style: null });
            const plain = drawPicture(scene(), view);
            await scene().setAppearance({ style: { styles: looks[appearance] } });
            const got = drawPicture(scene(), view);
            keys.add(programKey(layer.program(false)));
            const { worst, rmse } = comparePictures(got, expectationOf(view)(appearance));
            const other = comparePictures(got, plain);
            console.log(
              `WebGL ${version} ${name} ${appearance}: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)}; to the picture without ${other.worst}`,
            );
            expect(worst, `${appearance}: worst pixel`).to.be.at.most(2);
            expect(rmse, `${appearance}: RMSE`).to.be.at.most(0.5);
            expect(other.worst, `${appearance}: another picture than without`).to.be.above(20);
            layer.skipping = false;
            expect(comparePictures(got, drawPicture(scene(), view)).worst, `${appearance}: skipping`).to.equal(0);
            layer.skipping = true;
          }
          expect(keys.size, 'programs').to.equal(1);
        }
      });
    }
  });
}

describe('where there is no sampler left', () => {
  it('styles are left out of a ray, in WebGL 1', () => {
    const module = (count: number): RayText => ({
      name: 'many',
      stage: 'field',
      defines: {},
      chunks: [],
      samplers: Array.from({ length: count }, (_, i) => `u${i}`),
    });
    // The table of substeps takes one.
    expect(hasRoom([module(6)], { webgl2: false })).to.equal(true);
    expect(hasRoom([module(7)], { webgl2: false })).to.equal(false);
    expect(hasRoom([module(8)], { webgl2: true })).to.equal(true);
    expect(hasRoom([module(5), module(8)], { webgl2: false })).to.equal(false);
  });
});
