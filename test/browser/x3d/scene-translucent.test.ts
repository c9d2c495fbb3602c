// Translucent shapes of the author amid a volume: each is mixed in at its place, against the twin in float64.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../src/optics/rays/camera.ts';
import { renderReference } from '../../../src/optics/reference.ts';
import type { ReferenceScene } from '../../../src/optics/reference.ts';
import type { RayStyle } from '../../../src/optics/rays/ray-style.ts';
import { rayThrough } from '../../../src/optics/rays/rays.ts';
import { longestDiagonal } from '../../../src/volume/grid.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { changePlan } from '../../helpers/change-plan.ts';
import { drawPicture, height, meetBox, raysOf, referenceOf, width, withScene } from '../../helpers/picture.ts';
import type { View } from '../../helpers/picture.ts';
import { surfaceStages } from '../../helpers/surfaces.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

const material = (color: string, transparency: number): string =>
  `<appearance><material diffuseColor="0 0 0" specularColor="0 0 0" emissiveColor="${color}" transparency="${transparency}"></material></appearance>`;

/** Looks along the second axis, from the front, at a plane of one value, across which a sheet stands that is nearer on the left. */
const plane: View = (() => {
  const volume = syntheticVolume({ dimensions: [24, 24, 24], kind: 'float32', field: (_x, y) => y });
  return { volume, camera: orbitCamera({ theta: 0, phi: Math.PI / 2, radius: 60 }, [0, 0, 0], 0.6), stepLength: 0.7 };
})();

interface Box {
  readonly center: Vector3;
  readonly size: number;
}

/** Front faces alone are drawn. */
const boxOf = ({ center, size }: Box, color: string, transparency: number): string =>
  `<transform translation="${center.join(' ')}"><shape>${material(color, transparency)}<box size="${size} ${size} ${size}"></box></shape></transform>`;

const [glass, stone]: readonly Box[] = [
  { center: [2, -1, 1], size: 13 },
  { center: [-3, -4, -3], size: 8 },
];
const translucency = 0.35;
const three: RayStyle = {
  plain: true,
  surfaces: [
    { value: 0.35, color: [1, 0.4, 0.2], opacity: 0.3 },
    { value: 0.5, color: [0.2, 0.9, 0.5], opacity: 0.5 },
    { value: 0.65, color: [1, 1, 0.9], opacity: 1 },
  ],
};

const fog: View = (() => {
  const volume = syntheticVolume({ dimensions: [24, 20, 16] });
  const diagonal = longestDiagonal(volume.grid);
  return {
    volume,
    camera: orbitCamera({ theta: 0.6, phi: 1.2, radius: 1.4 * diagonal }, [0, 0, 0], 0.6),
    stepLength: diagonal / 45,
  };
})();

/** What is expected of a picture with a blue translucent and a green opaque box, 0..255; NaN beside edges of the boxes. */
function expectBoxes(view: View, stages: Partial<ReferenceScene>): Float64Array {
  const rays = raysOf(view);
  const draw = (boxes: readonly Box[]): Float64Array => {
    const nearest = (ray: Parameters<typeof meetBox>[1]): number =>
      Math.min(...boxes.map((box) => meetBox(view.volume, ray, box)));
    return renderReference({ ...referenceOf(view, nearest), ...stages }, rays, width, height);
  };
  const [behind, before] = [draw([stone]), draw([stone, glass])];
  const meets = (x: number, y: number, box: Box): number =>
    meetBox(view.volume, rayThrough(rays, (2 * x + 1) / width - 1, 1 - (2 * y + 1) / height), box);
  const kindAt = (x: number, y: number): number => {
    const [near, far] = [meets(x, y, glass), meets(x, y, stone)];
    return Number(near < far) + 2 * Number(Number.isFinite(far));
  };
  return Float64Array.from({ length: width * height * 4 }, (_, i) => {
    const [pixel, c] = [i >> 2, i & 3];
    const [x, y] = [pixel % width, Math.floor(pixel / width)];
    const kind = kindAt(x, y);
    const isAtEdge = [-1, 0, 1].some((dx) => [-1, 0, 1].some((dy) => kindAt(x + dx, y + dy) !== kind));
    const over = (part: Float64Array, color: readonly number[]): number =>
      part[i] + (1 - part[4 * pixel + 3]) * color[c];
    const without = over(behind, kind & 2 ? [0, 1, 0, 1] : [0, 0, 0, 0]);
    if (isAtEdge) return NaN;
    return 255 * (kind & 1 ? translucency * without + (1 - translucency) * over(before, [0, 0, 1, 1]) : without);
  });
}

for (const webgl1 of [false, true]) {
  describe(`translucent shapes amid a volume, WebGL ${webgl1 ? 1 : 2}`, function () {
    this.timeout(180_000);

    it('are hidden behind an opaque surface and shown before it, within a pixel', async () => {
      // Through the plane at its middle column, turned by half a radian.
      const sheet = `<transform rotation="0 0 1 0.5"><shape>${material('0 0 1', 0.25)}<indexedfaceset solid="false" coordIndex="0 1 2 3 -1"><coordinate point="-9 0 -6 9 0 -6 9 0 6 -9 0 6"></coordinate></indexedfaceset></shape></transform>`;
      await withScene({ webgl1, children: sheet }, async (scene) => {
        await scene.setAppearance({
          style: { clear: true, plain: true, surfaces: [{ value: 0.5, color: [1, 0.5, 0], opacity: 1 }] },
        });
        for (const maxCurvature of [0, 4]) {
          changePlan(scene, { maxCurvature, edgeCurvature: Infinity });
          const got = drawPicture(scene, plane);
          const row = Array.from({ length: width }, (_, x) =>
            Array.from(got.subarray(4 * (18 * width + x), 4 * (18 * width + x) + 4)),
          );
          const bare = [255, 127.5, 0, 255];
          const veiled = [0.25 * 255, 0.25 * 127.5, 0.75 * 255, 255];
          const isLike = (pixel: readonly number[], wanted: readonly number[]): boolean =>
            pixel.every((x, c) => Math.abs(x - wanted[c]) <= 2);
          const shown = row.map((pixel) => (isLike(pixel, veiled) ? 'v' : isLike(pixel, bare) ? 'b' : '?')).join('');
          // The sheet's left half, then the bare plane; what is drawn where the sheet passes through it may be either.
          expect(shown.slice(16, 32), shown).to.match(/^v{7}[vb]{2}b{7}$/);
        }
        expect(scene.adaptive).to.equal(true);
        expect(
          Array.from(scene.readVolume()!.startJumps(1, false)().data).every((x) => x === 0),
          'it ends no rays of the volume',
        ).to.equal(true);
      });
    });

    it('are mixed into fog and translucent surfaces as the twin has them, and behind opaque shapes', async () => {
      const children = boxOf(glass, '0 0 1', translucency) + boxOf(stone, '0 1 0', 0);
      const expected = expectBoxes(fog, surfaceStages(fog.volume, three, referenceOf(fog).transferFunction));
      await withScene({ webgl1, children }, async (scene) => {
        await scene.setAppearance({ style: three });
        const got = drawPicture(scene, fog);
        let [worst, count, grazing] = [0, 0, 0];
        expected.forEach((wanted, i) => {
          if (Number.isNaN(wanted)) return;
          const off = Math.abs(got[i] - wanted);
          if (off > 2) grazing++; // A ray that grazes a surface may pass it here and not there.
          else worst = Math.max(worst, off);
          count++;
        });
        console.log(
          `WebGL ${webgl1 ? 1 : 2}: ${grazing} of ${count} channels differ by more than 2, the others by ${worst.toFixed(2)} at most`,
        );
        expect(count / expected.length, 'share of the picture').to.be.above(0.7);
        expect(grazing, 'channels that differ').to.be.at.most(8);
      });
    });
  });
}
