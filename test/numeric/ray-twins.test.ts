import { expect } from '@esm-bundle/chai';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../src/optics/rays/camera.ts';
import { castRay } from '../../src/optics/rays/cast-ray.ts';
import { projectionGather } from '../../src/optics/rays/projection.ts';
import { rayThrough, setUpRays } from '../../src/optics/rays/rays.ts';
import { castSceneRay, opticsOf, stagesOf } from '../../src/optics/reference.ts';
import { polarField } from '../../src/radar/polar-field.ts';
import * as polar from '../../src/radar/gpu/polar-field-module.ts';
import * as slices from '../../src/radar/gpu/slices-module.ts';
import { sliceMeeter } from '../../src/radar/slices.ts';
import type { Slice } from '../../src/radar/slices.ts';
import * as box from '../../src/renderer/ray/modules/box.ts';
import * as cartesian from '../../src/renderer/ray/modules/cartesian-field.ts';
import * as composite from '../../src/renderer/ray/modules/composite.ts';
import * as projection from '../../src/renderer/ray/modules/projection.ts';
import * as sceneDepth from '../../src/renderer/ray/modules/scene-depth.ts';
import * as transferFunction from '../../src/renderer/ray/modules/transfer-function.ts';
import { longestDiagonal } from '../../src/volume/grid.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { plainOptics } from '../helpers/picture.ts';
import { syntheticVolume } from '../helpers/synthetic.ts';
import { evenAzimuths, radarVolume } from '../helpers/synthetic-radar.ts';

/** Rays through the middle of a volume. */
function setUp(volume: Volume) {
  const camera = orbitCamera({ theta: 0.5, phi: 1.1, radius: 1.3 * longestDiagonal(volume.grid) }, [0, 0, 0], 0.6);
  const rays = setUpRays(volume.grid, viewMatrix(camera), projectionMatrix(0.6, 1, 1, 1e6))!;
  return { rays, picked: [-0.2, 0, 0.15].map((x) => rayThrough(rays, x, 0.3 * x)) };
}

describe('the twins that modules name', () => {
  it('are a whole ray, the reference\'s own', () => {
    const volume = syntheticVolume({ dimensions: [14, 12, 10], kind: 'uint16' });
    const { rays, picked } = setUp(volume);
    const scene = { ...volume, ...plainOptics, stepLength: 0.6 };
    const ends = (): number => 0.1;
    const field = cartesian.twin({ ...volume, dimensions: volume.grid.dimensions });
    const stages = {
      ...stagesOf(scene, rays),
      intervals: [box.twin(rays), sceneDepth.twin(ends)],
      field,
      classify: transferFunction.twin(opticsOf(scene), field, rays.diameter),
      gather: composite.twin,
    };
    for (const ray of picked) {
      const [color, whole] = [castRay(stages, ray), castSceneRay(scene, rays, ray)];
      expect(color).to.deep.equal(castSceneRay({ ...scene, ends: [sceneDepth.twin(ends)] }, rays, ray));
      expect(color[3]).to.be.within(0.01, whole[3] - 0.001);
    }
    expect(projection.twin).to.equal(projectionGather);
  });

  it('are a radar\'s, with slices', () => {
    const sweeps = [0.5, 3, 8].map((elevation) => ({ elevation, azimuths: evenAzimuths(36), gates: 30 }));
    const volume = radarVolume({ sweeps }, { verticalExaggeration: 4 });
    const { rays, picked } = setUp(volume);
    const stepLength = longestDiagonal(volume.grid) / 60;
    const look = { ...plainOptics, transferFunction: [{ value: -30, color: [1, 1, 1], opacity: 0.1 }, { value: 90, color: [1, 0, 0], opacity: 0.2 }] as const, referenceLength: 1e5 };
    const scene = { ...volume, ...look, stepLength, field: polar.twin(volume) };
    const level: Slice = { kind: 'level', height: 2000 };
    const cut = { ...scene, ends: [slices.twin(sliceMeeter(volume, [level], look))] };
    expect(polar.twin).to.equal(polarField);
    let opaque = 0;
    for (const ray of picked) {
      expect(castSceneRay(scene, rays, ray)[3]).to.be.within(0.001, 0.9);
      opaque += Number(castSceneRay(cut, rays, ray)[3] === 1);
    }
    expect(opaque).to.be.above(0);
  });
});
