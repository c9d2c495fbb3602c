// Surfaces in a scene: rays end at them as at an author's shape of the same form, both of their sides are lit, and they go again.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import type { ShownSurface } from '../../../src/renderer/layers/shown-surfaces.ts';
import type { VolumeScene } from '../../../src/x3d/scene.ts';
import { changePlan, drawAt } from '../../helpers/change-plan.ts';
import { surfaceOf } from '../../helpers/meshes.ts';
import { height, plainOptics, width, withScene } from '../../helpers/picture.ts';
import { readPixels } from '../../helpers/read-pixels.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

const volume = syntheticVolume({ dimensions: [24, 20, 16], kind: 'uint16' });
const camera = orbitCamera({ theta: 0.6, phi: 1.2, radius: 70 }, [0, 0, 0], 0.6);
const [x, y, z] = [7, 5, 8];

/** A box around the origin, its corners counterclockwise from outside, or the other way round. */
function box(isTurned: boolean): string {
  const corners = Array.from({ length: 8 }, (_, i) => [i & 1 ? x : -x, i & 2 ? y : -y, i & 4 ? z : -z]);
  const sides = [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ];
  return [
    ...corners.map((corner) => `v ${corner.join(' ')}`),
    ...sides.map(
      (side) => `f ${(isTurned ? side.map((_, i) => side[3 - i]) : side).map((corner) => corner + 1).join(' ')}`,
    ),
    '',
  ].join('\n');
}

/** Those of a scene that are shown. */
const owners = new WeakMap<VolumeScene, object[]>();

/** In place of those before. */
async function show(scene: VolumeScene, shown: readonly ShownSurface[]): Promise<Uint8Array> {
  const lines = (await scene.loadLines())!;
  for (const owner of owners.get(scene) ?? []) await lines.showSurface(null, owner);
  owners.set(
    scene,
    shown.map(() => ({})),
  );
  for (const [i, owner] of owners.get(scene)!.entries()) await lines.showSurface(shown[i], owner);
  return draw(scene);
}

async function draw(scene: VolumeScene): Promise<Uint8Array> {
  await scene.setAppearance({ optics: plainOptics });
  changePlan(scene, { picture: { width, height } });
  scene.setVolume(volume);
  changePlan(scene, { camera });
  drawAt(scene, 0.6);
  return Uint8Array.from(readPixels(scene));
}

const worstOf = (a: Uint8Array, b: Uint8Array): number =>
  a.reduce((worst, level, i) => Math.max(worst, Math.abs(level - b[i])), 0);

describe('surfaces in a scene', () => {
  for (const webgl1 of [false, true]) {
    it(`are drawn as a shape of the same form is, in WebGL ${webgl1 ? 1 : 2}`, async () => {
      const color = [0.25, 0.5, 0.75] as const;
      // A fifth of the light comes from all around.
      const light = (share: number): string => color.map((channel) => share * channel ** 2.2).join(' ');
      const author = `<shape><appearance><material diffusecolor="${light(0.8)}" emissivecolor="${light(0.2)}" specularcolor="0.02 0.02 0.02" shininess="0.2"></material></appearance><box solid="false" size="${2 * x} ${2 * y} ${2 * z}"></box></shape>`;
      const wanted = await withScene({ webgl1, children: author }, async (scene) => {
        await scene.othersReady();
        return draw(scene);
      });
      await withScene({ webgl1 }, async (scene) => {
        const bare = await draw(scene);
        expect(worstOf(bare, wanted)).to.be.above(100);
        for (const isTurned of [false, true]) {
          const surface = await surfaceOf(box(isTurned));
          expect(worstOf(await show(scene, [{ surface, color, usesOwnColors: true }]), wanted)).to.be.at.most(2);
          // In two parts.
          const [part] = surface.parts;
          const parts = [part.indices.slice(0, 15), part.indices.slice(15)].map((indices) => ({ ...part, indices }));
          expect(
            worstOf(await show(scene, [{ surface: { ...surface, parts }, color, usesOwnColors: true }]), wanted),
          ).to.be.at.most(2);
        }
        expect(worstOf(await show(scene, []), bare)).to.equal(0);
      });
    });
  }
});
