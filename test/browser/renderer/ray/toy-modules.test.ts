// Modules that the package does not know, added by this file alone, in one place: what renderer/ray/ray-module.ts promises. They are drawn, cast in float64, picked and checked.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../../src/optics/rays/camera.ts';
import type { GatherStage, Sample, ShadeStage } from '../../../../src/optics/rays/ray-stages.ts';
import type { RayModule } from '../../../../src/renderer/ray/ray-module.ts';
import { later, twinOf } from '../../../../src/renderer/ray/ray-twin.ts';
import { noCuts } from '../../../../src/viewer/cuts/cuts.ts';
import { checkPicture } from '../../../../src/viewer/picking/check-picture.ts';
import { pick } from '../../../../src/viewer/picking/pick.ts';
import { Visibility } from '../../../../src/viewer/scenes/visibility.ts';
import { Viewer } from '../../../../src/viewer/view/viewer.ts';
import type { VolumeScene } from '../../../../src/x3d/scene.ts';
import { x3dScenes } from '../../../../components/internal/x3d-scenes.ts';
import { boundingSphere, longestDiagonal } from '../../../../src/volume/grid.ts';
import { casesOf } from '../../../helpers/cases.ts';
import { isEdge, listOff } from '../../../helpers/edges.ts';
import {
  comparePictures,
  drawPicture,
  drawReference,
  height,
  plainOptics,
  raysOf,
  stagesOfView,
  width,
  withScene,
} from '../../../helpers/picture.ts';
import type { View } from '../../../helpers/picture.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

const nothing = { uniforms: {}, units: [] };

/** Nothing has to be loaded for twins that are here. */
const here = later(() => Promise.resolve({}));

/** How far along its ray is the nearest value that is no less than a threshold, as gray; clear where there is none. */
function nearestAbove(threshold: number): RayModule<'gather'> {
  return {
    name: 'nearestAbove',
    stage: 'gather',
    defines: {},
    chunks: [
      `
uniform float uThreshold;
struct Gathered { float at; };
Gathered beginGathering() { return Gathered(-1.0); }
void gatherSegment(Segment segment, inout Gathered gathered) {
  if (gathered.at >= 0.0 || !hasData(segment.front) || !hasData(segment.back) || max(segment.front.value, segment.back.value) < uThreshold) return;
  float rise = segment.back.value - segment.front.value;
  float share = segment.front.value >= uThreshold ? 0.0 : (uThreshold - segment.front.value) / rise;
  gathered.at = segment.begin + share * segment.span;
}
bool isSettled(Gathered gathered) { return gathered.at >= 0.0; }
float chooseSubsteps(Sample front, Sample back, Gathered gathered) { return 1.0; }
Ahead lookAhead(CellRay cells, float number, Gathered gathered) { return Ahead(0.0, 1.0); }
vec4 finishGathering(Gathered gathered, Path path) { return gathered.at < 0.0 ? vec4(0.0) : vec4(vec3(gathered.at / path.total), 1.0); }
`,
    ],
    samplers: [],
    sparesRays: false,
    order: 2,
    inputs: ({ domain: [low, high] }) => ({ uniforms: { uThreshold: (threshold - low) / (high - low) }, units: [] }),
    twin: twinOf(here, () => ({ gather: nearestAboveTwin(threshold) })),
  };
}

const nearestAboveTwin =
  (threshold: number): GatherStage =>
  () => {
    let at = -1;
    return {
      add: ({ front, back, begin, span }) => {
        if (at >= 0 || !front.valid || !back.valid || Math.max(front.value, back.value) < threshold) return;
        at = begin + (front.value >= threshold ? 0 : (threshold - front.value) / (back.value - front.value)) * span;
      },
      chooseSubsteps: () => 1,
      finish: (path) => (path && at >= 0 ? [at / path.total, at / path.total, at / path.total, 1] : [0, 0, 0, 0]),
    };
  };

/** A field that knows how high a place is, beside its value. */
const heightModule: RayModule<'field'> = {
  name: 'height',
  stage: 'field',
  defines: {},
  members: ['float height'],
  samplers: [],
  sparesRays: true,
  order: Infinity,
  chunks: ['Sample heightField(vec3 p, Sample known) { known.height = p.z; return known; }\n'],
  inputs: () => nothing,
  twin: twinOf(here, () => ({ moreFields: [(place, known) => ({ ...known, height: place[2] })] })),
};

/** Redder the higher. */
const redden: RayModule<'shade'> = {
  name: 'redden',
  stage: 'shade',
  defines: {},
  samplers: [],
  sparesRays: true,
  order: 2,
  chunks: [
    `
uniform float uRedness;
vec4 reddenShade(Segment segment, vec4 seen) {
  float height = 0.5 * (segment.front.height + segment.back.height);
  return vec4(mix(seen.rgb, vec3(seen.a, 0.0, 0.0), uRedness * height), seen.a);
}
`,
  ],
  inputs: () => ({ uniforms: { uRedness: 0.8 }, units: [] }),
  twin: twinOf(here, () => ({ shades: [reddenTwin] })),
};

const heightOf = ({ height: h }: Sample): number => h as number;
const reddenTwin: ShadeStage = ({ front, back }, [red, green, blue, alpha]) => {
  const share = 0.8 * 0.5 * (heightOf(front) + heightOf(back));
  return [red + share * (alpha - red), green * (1 - share), blue * (1 - share), alpha];
};

const volume = syntheticVolume({ dimensions: [24, 20, 16], kind: 'uint16' });
const diagonal = longestDiagonal(volume.grid);
const view: View = {
  volume,
  camera: orbitCamera({ theta: 0.6, phi: 1.2, radius: 1.4 * diagonal }, boundingSphere(volume.grid).center, 0.6),
  stepLength: diagonal / 50,
};
const rays = raysOf(view);

const tintTwin: ShadeStage = (_, [red, green, blue, alpha]) => {
  const opacity = 1 - (1 - alpha) ** 0.25;
  const share = opacity / alpha;
  return alpha > 0 ? [opacity, green * share, blue * share, opacity] : [red, green, blue, alpha];
};

/** Redder, and of a quarter of the depth: which a pick tells. */
const tint: RayModule<'shade'> = {
  name: 'tint',
  stage: 'shade',
  defines: {},
  samplers: [],
  sparesRays: true,
  order: 2,
  chunks: [
    `
vec4 tintShade(Segment segment, vec4 seen) {
  float opacity = 1.0 - pow(1.0 - seen.a, 0.25);
  return seen.a > 0.0 ? vec4(opacity, seen.gb * (opacity / seen.a), opacity) : seen;
}
`,
  ],
  inputs: () => nothing,
  twin: twinOf(here, () => ({ shades: [tintTwin] })),
};

describe('modules of others', () => {
  for (const { name, modules } of [
    { name: 'a gather stage stands in for ours', modules: [nearestAbove(0.45)] },
    { name: 'a field and a shade stage join ours', modules: [heightModule, redden] },
    { name: 'one changes opacity', modules: [tint] },
  ]) {
    const reported = { ...view, modules };
    const stages = stagesOfView(reported);
    for (const version of casesOf([2, 1] as const, (one) => one === 2 || modules.length === 2)) {
      it(`${name}, and draw what their twins say, in WebGL ${version}`, () =>
        withScene({ webgl1: version === 1 }, (scene) => {
          const before = drawPicture(scene, view);
          scene.layers[0].setModules(modules);
          const got = drawPicture(scene, view);
          const expected = drawReference(reported);
          const edges = new Set([...listOff(got, expected)].filter((pixel) => isEdge(stages, rays, pixel)));
          const { worst, rmse } = comparePictures(got, expected, (pixel) => edges.has(pixel));
          console.log(
            `WebGL ${version} ${modules.map((module) => module.name).join(', ')}: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)}, ${edges.size} pixels left out`,
          );
          expect(worst).to.be.at.most(2);
          expect(edges.size).to.be.below(0.01 * width * height);
          expect(comparePictures(got, before).worst, 'it is another picture').to.be.above(20);
          scene.layers[0].setModules([]);
          expect(comparePictures(drawPicture(scene, view), before).worst, 'afterwards').to.equal(0);
        }));
    }
  }
});

/** A view of the volume in the page, at rest. */
async function withViewer(use: (viewer: Viewer, scene: VolumeScene) => Promise<void>): Promise<void> {
  const host = document.createElement('div');
  host.style.cssText = 'width: 160px; height: 120px';
  const container = document.createElement('div');
  container.style.cssText = 'width: 100%; height: 100%';
  host.append(container);
  document.body.append(host);
  const visibility = new Visibility(() => {});
  const failures: unknown[] = [];
  const viewer = new Viewer(
    { host, container, visibility, scenes: x3dScenes },
    { rendered: () => {}, cameraMoved: () => {}, labelRing: () => '', drawingFailed: (error) => failures.push(error) },
  );
  viewer.setQuality({ steps: 60, maxError: 1, isFree: false, targetFps: 30 });
  try {
    await visibility.ask(async () => {
      await viewer.show(
        volume,
        { ...plainOptics, window: [0, 1], projection: null, shading: 'unlit', surfaces: null },
        () => noCuts,
      );
      await viewer.redraw();
      await use(viewer, viewer.pictures.parts.controller.scene as VolumeScene);
    });
    expect(failures).to.deep.equal([]);
  } finally {
    viewer.dispose();
    host.remove();
  }
}

describe('a module that is added to the list of a layer', () => {
  it('is drawn, picked and checked, and no more so when it is gone', async function () {
    this.timeout(240_000);
    await withViewer(async (viewer, scene) => {
      const opacityOf = async (): Promise<number> => (await pick(viewer, [80, 60]))!.opacity;
      const show = async (modules: readonly RayModule[]): Promise<Uint8Array> => {
        scene.layers[0].setModules(modules);
        viewer.invalidate();
        await viewer.redraw();
        await viewer.settled();
        return scene.readPicture().data;
      };
      const before = await show([]);
      const opacity = await opacityOf();
      expect(opacity).to.be.within(0.1, 0.999);
      expect((await checkPicture(viewer))!.agrees, 'without it').to.equal(true);

      expect(comparePictures(await show([tint]), before).worst, 'it is drawn').to.be.above(20);
      expect(await opacityOf(), 'it is picked').to.be.closeTo(1 - (1 - opacity) ** 0.25, 1e-3);
      const check = (await checkPicture(viewer))!;
      expect([check.agrees, check.off], 'it is checked').to.deep.equal([true, 0]);

      await show([{ ...tint, twin: twinOf(here, () => ({})) }]);
      expect((await checkPicture(viewer))!.agrees, 'what it is in float64 counts').to.equal(false);

      expect(
        comparePictures(await show([]), before).worst,
        'it is gone; another number of steps may be enough',
      ).to.be.at.most(1);
      expect(await opacityOf(), 'from picks too').to.equal(opacity);

      await show([tint]);
      const tinted = await opacityOf();
      viewer.pictures.parts.controller.leave();
      expect(viewer.pictures.parts.controller.scene, "its context is another view's").to.equal(null);
      expect(await opacityOf(), 'the picture that stands there is picked').to.be.closeTo(tinted, 1e-9);
    });
  });
});
