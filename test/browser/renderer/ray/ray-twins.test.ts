import { expect } from '@esm-bundle/chai';
import { castRay } from '../../../../src/optics/rays/cast-ray.ts';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import type { RayStages, ShadeStage } from '../../../../src/optics/rays/ray-stages.ts';
import { shapeInterval } from '../../../../src/optics/rays/ray-intervals.ts';
import { rayThrough, setUpRays } from '../../../../src/optics/rays/rays.ts';
import type { Ray, RaySetup } from '../../../../src/optics/rays/rays.ts';
import { castSceneRay } from '../../../../src/optics/reference.ts';
import { maxSubsteps } from '../../../../src/optics/transfer/substep-limits.ts';
import { polarField } from '../../../../src/radar/polar-field.ts';
import { sliceInterval, sliceMeeter } from '../../../../src/radar/slices.ts';
import type { Slice } from '../../../../src/radar/slices.ts';
import type { VolumeLayer } from '../../../../src/renderer/layers/volume-layer.ts';
import { composeTwins, loadTwins } from '../../../../src/renderer/ray/compose-twins.ts';
import { labelAppearances } from '../../../../src/renderer/ray/modules/label-appearances.ts';
import type { Optics, RayModule, TwinFrame } from '../../../../src/renderer/ray/ray-module.ts';
import { later, twinOf } from '../../../../src/renderer/ray/ray-twin.ts';
import { longestDiagonal } from '../../../../src/volume/grid.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { plainOptics } from '../../../helpers/picture.ts';
import { createQuietLayer } from '../../../helpers/quiet-layer.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';
import { evenAzimuths, radarVolume } from '../../../helpers/synthetic-radar.ts';

/** Rays through the middle of a volume. */
function setUp(volume: Volume) {
  const camera = orbitCamera({ theta: 0.5, phi: 1.1, radius: 1.3 * longestDiagonal(volume.grid) }, [0, 0, 0], 0.6);
  const rays = setUpRays(volume.grid, viewMatrix(camera), projectionMatrix(0.6, 1, 1, 1e6))!;
  return { rays, picked: [-0.2, 0, 0.15].map((x) => rayThrough(rays, x, 0.3 * x)) };
}

/** The rays of a layer's list. */
async function stagesOfLayer(
  layer: VolumeLayer,
  rays: RaySetup,
  { stepLength, shapeT }: { readonly stepLength: number } & Pick<TwinFrame, 'shapeT'>,
): Promise<RayStages> {
  const twins = layer.twins(shapeT !== undefined)!;
  const frame = { ...twins, rays, placesOnly: false, shapeT };
  await loadTwins(twins, frame);
  return composeTwins(twins, frame, { stepLength, maxSubsteps });
}

async function layerOf(volume: Volume, optics: Optics): Promise<VolumeLayer> {
  const layer = createQuietLayer();
  await layer.prepare(volume, optics);
  layer.set(volume);
  await layer.setAppearance({ optics });
  return layer;
}

describe('the modules of a layer, in float64', () => {
  it("are a whole ray, the reference's own", async () => {
    const volume = syntheticVolume({ dimensions: [14, 12, 10], kind: 'uint16' });
    const { rays, picked } = setUp(volume);
    const scene = { ...volume, ...plainOptics, stepLength: 0.6 };
    const shapeT = (): number => 0.1;
    const stages = await stagesOfLayer(await layerOf(volume, plainOptics), rays, { stepLength: 0.6, shapeT });
    for (const ray of picked) {
      const [color, whole] = [castRay(stages, ray), castSceneRay(scene, rays, ray)];
      expect(color).to.deep.equal(castSceneRay({ ...scene, ends: [shapeInterval(shapeT)] }, rays, ray));
      expect(color[3]).to.be.within(0.01, whole[3] - 0.001);
    }
  });

  it("are a radar's, with slices, brightened once", async () => {
    const sweeps = [0.5, 3, 8].map((elevation) => ({ elevation, azimuths: evenAzimuths(36), gates: 30 }));
    const volume = radarVolume({ sweeps }, { verticalExaggeration: 4 });
    const { rays, picked } = setUp(volume);
    const stepLength = longestDiagonal(volume.grid) / 60;
    const appearance = {
      ...plainOptics,
      transferFunction: [
        { value: -30, color: [0.2, 0.3, 0.4], opacity: 0.1 },
        { value: 90, color: [0.5, 0, 0.1], opacity: 0.2 },
      ] as const,
      referenceLength: 1e5,
      lightFactor: 1.5,
    };
    const level: Slice = { kind: 'level', height: 2000 };
    const layer = await layerOf(volume, appearance);
    const bare = await stagesOfLayer(layer, rays, { stepLength });
    layer.plan = { ...layer.plan, slices: [level] };
    const cut = await stagesOfLayer(layer, rays, { stepLength });
    const scene = { ...volume, ...appearance, stepLength, field: polarField(volume) };
    const ends = [sliceInterval(sliceMeeter(volume, [level], appearance))];
    const cast = (ray: Ray, withSlice: boolean) => castSceneRay({ ...scene, ...(withSlice && { ends }) }, rays, ray);
    let opaque = 0;
    for (const ray of picked) {
      expect(castRay(bare, ray)[3]).to.be.within(0.001, 0.9);
      expect(castRay(bare, ray)).to.deep.equal(cast(ray, false));
      expect(castRay(cut, ray)).to.deep.equal(cast(ray, true));
      opaque += Number(castRay(cut, ray)[3] === 1);
    }
    expect(opaque).to.be.above(0);
  });

  it('act in the order of the list, each in its own stage', async () => {
    const volume = syntheticVolume({ dimensions: [14, 12, 10], kind: 'uint16' });
    const { rays, picked } = setUp(volume);
    const layer = await layerOf(volume, plainOptics);
    const shade = (name: string, act: ShadeStage): RayModule => ({
      ...labelAppearances,
      name,
      twin: twinOf(
        later(() => Promise.resolve({})),
        () => ({ shades: [act] }),
      ),
    });
    const [double, add] = [
      shade('double', (_, [r, g, b, a]) => [2 * r, g, b, a]),
      shade('add', (_, [r, g, b, a]) => [r + a, g, b, a]),
    ];
    const redOf = async (modules: readonly RayModule[]): Promise<number> => {
      layer.setModules(modules);
      return castRay(await stagesOfLayer(layer, rays, { stepLength: 0.6 }), picked[1])[0];
    };
    const [red, last, first] = [await redOf([]), await redOf([double, add]), await redOf([add, double])];
    const { 3: alpha } = castRay(await stagesOfLayer(layer, rays, { stepLength: 0.6 }), picked[1]);
    expect(last).to.be.closeTo(2 * red + alpha, 1e-9);
    expect(first).to.be.closeTo(2 * (red + alpha), 1e-9);
    const lost = { ...double, stage: 'gather', members: undefined } as RayModule;
    expect(await redOf([lost]).catch(String)).to.include('the twin of double got "shades"');
  });

  it("say so where one that a ray can't do without says nothing of float64", async () => {
    const volume = syntheticVolume({ dimensions: [4, 4, 4] });
    const layer = await layerOf(volume, plainOptics);
    layer.setModules([{ ...layer.modules(false).find(({ name }) => name === 'composite')!, name: 'mute', twin: null }]);
    const error = await stagesOfLayer(layer, setUp(volume).rays, { stepLength: 1 }).catch((thrown: unknown) => thrown);
    expect(error).to.be.an.instanceOf(TypeError);
    expect((error as Error).message)
      .to.include('gather')
      .and.to.include('mute');
  });
});
