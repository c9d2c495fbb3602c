import { expect } from '@esm-bundle/chai';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../src/optics/rays/camera.ts';
import { findJump, findThin, jumps, rayEnd } from '../../../src/optics/rays/depth-jumps.ts';
import type { EndsAround, RayEnd } from '../../../src/optics/rays/depth-jumps.ts';
import { crossVolume, rayThrough, setUpRays } from '../../../src/optics/rays/rays.ts';
import { jumpChunks, jumpDefines } from '../../../src/renderer/passes/depth-jumps-text.ts';
import { rayUniforms } from '../../../src/renderer/ray/uniforms.ts';
import { createGl, pointTexture, releaseGl, runChunk } from '../../helpers/gl.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

const [width, height] = [22, 18];
const quads = Array.from({ length: (width / 2 - 1) * (height / 2 - 1) }, (_, i) => [
  2 * (i % (width / 2 - 1)),
  2 * Math.floor(i / (width / 2 - 1)),
]);
const { grid } = syntheticVolume({ dimensions: [8, 9, 10] });
const camera = orbitCamera({ theta: 0.5, phi: 1.1, radius: 22 }, [0, 0, 0], 0.8);
const [near, far] = [1, 60];
const stepLength = 0.4;
const parallelMatrix = [
  0.12,
  0,
  0,
  0,
  0,
  0.15,
  0,
  0,
  0,
  0,
  -2 / (far - near),
  -(far + near) / (far - near),
  0,
  0,
  0,
  1,
];

/** Depths in the world: a tilted plane with a hole, a ball, and lines, which solid shapes do not count. */
const solidDepth = (x: number, y: number): number => {
  const plane =
    x > 3 && x < 15 && !(x > 7 && x < 10 && y > 4 && y < 9) ? 1 / (0.045 + 0.0004 * x - 0.0003 * y) : Infinity;
  const out = 1 - ((x - 16) ** 2 + (y - 12) ** 2) / 16;
  return Math.min(plane, out > 0 ? 21 - 2 * Math.sqrt(out) : Infinity);
};
const depth = (x: number, y: number): number =>
  Math.min(solidDepth(x, y), x === 12 || y === 5 || x + y === 30 ? 20 : Infinity);

for (const version of [1, 2] as const) {
  for (const [name, projection] of [
    ['perspective', projectionMatrix(camera.fieldOfView, width / height, near, far)],
    ['parallel', parallelMatrix],
  ] as const) {
    it(`ends of rays at shapes are the twin's in WebGL ${version}, ${name}`, () => {
      const test = createGl(version);
      const rays = setUpRays(grid, viewMatrix(camera), projection)!;
      const stored = (d: number): number =>
        Number.isFinite(d)
          ? ((-projection[10] * d + projection[11]) / (-projection[14] * d + projection[15]) + 1) / 2
          : 1;
      const pixels = Array.from({ length: width * height }, (_, i) => [i % width, Math.floor(i / width)]);
      // One texture of a row for both: pixel (x, y) is looked up at its number.
      const texture = (of: typeof depth, sampler: string) =>
        pointTexture(
          test.gl,
          pixels.map(([x, y]) => [stored(of(x, y)), 0, 0, 0]),
          sampler,
        );
      const units = [texture(depth, 'uSceneDepth'), texture(solidDepth, 'uSolidDepth')];
      const inRow =
        'vec2 inRow(vec2 at) { return vec2((floor(at.x) + floor(at.y) * WIDTH + 0.5) / (WIDTH * HEIGHT), 0.5); }';
      const chunks = [
        inRow,
        ...jumpChunks.map((chunk) => chunk.replace(/pixel \* uPixelToDepth\.xy \+ uPixelToDepth\.zw/, 'inRow(pixel)')),
      ];
      const got = runChunk(test, {
        defines: { ...jumpDefines, WIDTH: width.toFixed(1), HEIGHT: height.toFixed(1) },
        chunks,
        result: 'vec4(findJump(a.xy + 0.5), hasShapes(a.xy + 0.5) ? 1.0 : 0.0, 0.0)',
        a: quads.map(([x, y]) => [x, y, 0, 0]),
        units,
        uniforms: {
          ...rayUniforms(rays, { width, height }, stepLength),
          uSolids: 1,
          uDepthTerms: [projection[10], projection[11], projection[14], projection[15]],
          uDepthToT: [rays.planeDepth, rays.diameter],
        },
      });
      const scale = {
        planeDepth: name === 'perspective' ? rays.planeDepth / rays.diameter : null,
        stepLength: stepLength / rays.diameter,
      };
      const endAt = (of: typeof depth, x: number, y: number): RayEnd =>
        rayEnd(
          crossVolume(rays, rayThrough(rays, (2 * x + 1) / width - 1, (2 * y + 1) / height - 1)),
          (of(x, y) - rays.planeDepth) / rays.diameter,
          scale,
        );
      const around = (of: typeof depth, [x, y]: readonly number[], stride: number) =>
        [
          [0, 0],
          [1, 0],
          [0, 1],
          [1, 1],
        ].map(([dx, dy]) => endAt(of, x + stride * dx, y + stride * dy)) as unknown as EndsAround['own'];
      const counts = new Map<number, number>();
      quads.forEach((quad, i) => {
        const own = around(depth, quad, 1);
        const jump = findJump({ known: around(solidDepth, quad, 2), own });
        expect(got[i][0], `jump at ${quad.join(', ')}`).to.be.closeTo(jump, 1e-6);
        expect(got[i][1] * 15, `thin at ${quad.join(', ')}`).to.be.closeTo(
          findThin(own, around(solidDepth, quad, 1)),
          1e-4,
        );
        if (jump !== jumps.none) expect(got[i][2], `a shape at ${quad.join(', ')}`).to.equal(1);
        counts.set(jump, (counts.get(jump) ?? 0) + 1);
      });
      for (const jump of Object.values(jumps)) expect(counts.get(jump), `${name}: quads of ${jump}`).to.be.above(5);
      releaseGl(test);
    });
  }
}
