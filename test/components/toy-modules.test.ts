// Modules that the package does not know, added by this file alone: what renderer/ray/ray-module.ts promises.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../src/optics/rays/camera.ts';
import { castRay } from '../../src/optics/rays/cast-ray.ts';
import type { GatherStage, Sample, SecondFieldStage, ShadeStage } from '../../src/optics/rays/ray-stages.ts';
import { stagesOf } from '../../src/optics/reference.ts';
import type { RayModule } from '../../src/renderer/ray/ray-module.ts';
import { boundingSphere, longestDiagonal } from '../../src/volume/grid.ts';
import { isEdge, listOff, rayAt } from '../helpers/edges.ts';
import { comparePictures, drawPicture, height, raysOf, referenceOf, width, withScene } from '../helpers/picture.ts';
import type { View } from '../helpers/picture.ts';
import { syntheticVolume } from '../helpers/synthetic.ts';

const nothing = { uniforms: {}, units: [] };

/** How far along its ray is the nearest value that is no less than a threshold, as gray; clear where there is none. */
function nearestAbove(threshold: number): RayModule<'gather'> {
  return {
    name: 'nearestAbove',
    stage: 'gather',
    defines: {},
    chunks: [`
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
`],
    samplers: [],
    sparesRays: false,
    order: 2,
    inputs: ({ domain: [low, high] }) => ({ uniforms: { uThreshold: (threshold - low) / (high - low) }, units: [] }),
  };
}

const nearestAboveTwin = (threshold: number): GatherStage => () => {
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
  name: 'height', stage: 'field', defines: {}, members: ['float height'], samplers: [], sparesRays: true, order: Infinity,
  chunks: ['Sample heightField(vec3 p, Sample known) { known.height = p.z; return known; }\n'],
  inputs: () => nothing,
};

const heightTwin: SecondFieldStage = (place, known) => ({ ...known, height: place[2] });

/** Redder the higher. */
const redden: RayModule<'shade'> = {
  name: 'redden', stage: 'shade', defines: {}, samplers: [], sparesRays: true, order: 2,
  chunks: [`
uniform float uRedness;
vec4 reddenShade(Segment segment, vec4 seen) {
  float height = 0.5 * (segment.front.height + segment.back.height);
  return vec4(mix(seen.rgb, vec3(seen.a, 0.0, 0.0), uRedness * height), seen.a);
}
`],
  inputs: () => ({ uniforms: { uRedness: 0.8 }, units: [] }),
};

const heightOf = ({ height: h }: Sample): number => h as number;
const reddenTwin: ShadeStage = ({ front, back }, [red, green, blue, alpha]) => {
  const share = 0.8 * 0.5 * (heightOf(front) + heightOf(back));
  return [red + share * (alpha - red), green * (1 - share), blue * (1 - share), alpha];
};

const volume = syntheticVolume({ dimensions: [24, 20, 16], kind: 'uint16' });
const diagonal = longestDiagonal(volume.grid);
const view: View = { volume, camera: orbitCamera({ theta: 0.6, phi: 1.2, radius: 1.4 * diagonal }, boundingSphere(volume.grid).center, 0.6), stepLength: diagonal / 50 };
const rays = raysOf(view);
const plain = stagesOf(referenceOf(view), rays);

describe('modules of others', () => {
  for (const { name, modules, stages } of [
    { name: 'a gather stage stands in for ours', modules: [nearestAbove(0.45)], stages: { ...plain, gather: nearestAboveTwin(0.45) } },
    { name: 'a field and a shade stage join ours', modules: [heightModule, redden], stages: { ...plain, moreFields: [heightTwin], shades: [reddenTwin] } },
  ]) {
    for (const version of [2, 1] as const) {
      it(`${name}, and draw what their twins say, in WebGL ${version}`, () => withScene({ webgl1: version === 1 }, (scene) => {
        const before = drawPicture(scene, view);
        scene.layers[0].setModules(modules);
        const got = drawPicture(scene, view);
        const expected = Array.from({ length: width * height }, (_, pixel) => castRay(stages, rayAt(rays, pixel)).map((x) => x * 255)).flat();
        const edges = new Set([...listOff(got, expected)].filter((pixel) => isEdge(stages, rays, pixel)));
        const { worst, rmse } = comparePictures(got, expected, (pixel) => edges.has(pixel));
        console.log(`WebGL ${version} ${modules.map((module) => module.name).join(', ')}: worst ${worst.toFixed(2)} rmse ${rmse.toFixed(2)}, ${edges.size} pixels left out`);
        expect(worst).to.be.at.most(2);
        expect(edges.size).to.be.below(0.01 * width * height);
        expect(comparePictures(got, before).worst, 'it is another picture').to.be.above(20);
        scene.layers[0].setModules([]);
        expect(comparePictures(drawPicture(scene, view), before).worst, 'afterwards').to.equal(0);
      }));
    }
  }
});
