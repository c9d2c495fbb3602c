import { expect } from '@esm-bundle/chai';
import box from '../../../shaders/chunks/walk/box.glsl?raw';
import decode from '../../../shaders/chunks/field/decode.glsl?raw';
import interval from '../../../shaders/chunks/walk/interval.glsl?raw';
import ray from '../../../shaders/chunks/walk/ray.glsl?raw';
import sceneDepth from '../../../shaders/chunks/depth/scene-depth.glsl?raw';
import { projectionMatrix } from '../../../src/optics/rays/camera.ts';
import { intersectUnitCube } from '../../../src/optics/rays/rays.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { createGl, pointTexture, releaseGl, runChunk } from '../../helpers/gl.ts';
import type { TestGl } from '../../helpers/gl.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

for (const version of [1, 2] as const) {
  describe(`chunks in WebGL ${version}`, () => {
    let test: TestGl;
    before(() => (test = createGl(version)));
    after(() => releaseGl(test));

    it('decode: all 65,536 values of two bytes come out as themselves', () => {
      const values = Array.from({ length: 4096 }, (_, i) => (i < 2048 ? i : i * 16 + (i % 16)));
      // The high byte is in the second channel of RG and in the last of LUMINANCE_ALPHA.
      const a = values.map((v) =>
        version === 2 ? [(v & 255) / 255, (v >> 8) / 255, 0, 1] : [(v & 255) / 255, 0, 0, (v >> 8) / 255],
      );
      const got = runChunk(test, { defines: { TWO_BYTES: 1 }, chunks: [decode], result: 'vec4(decodeTexel(a))', a });
      // float32: 2^-24 relative, a few operations.
      got.forEach(([x], i) => expect(x, `value ${values[i]}`).to.equal(values[i]));
    });

    it('decode: one channel is the value itself', () => {
      const a = [
        [0.25, 9, 9, 9],
        [-1e30, 0, 0, 0],
      ];
      const got = runChunk(test, { chunks: [decode], result: 'vec4(decodeTexel(a))', a });
      expect(got.map(([x]) => x)).to.deep.equal([0.25, Math.fround(-1e30)]);
    });

    it("box: the crossing is the twin's", () => {
      const random = randomNumbers(8);
      const lines = Array.from({ length: 500 }, (): [Vector3, Vector3] => [
        [random() * 2 - 0.5, random() * 2 - 0.5, random() * 2 - 0.5],
        [random() - 0.5, random() - 0.5, random() - 0.5],
      ]);
      lines.push(
        [
          [0.3, -1, 0.2],
          [0, 1, 0.5],
        ],
        [
          [0.3, 2, 0.7],
          [0, -1, 0],
        ],
        [
          [2, 0.5, 0.5],
          [0, 0, 1],
        ],
        [
          [0.5, 0.5, 0.5],
          [-1, 0, 0],
        ],
      );
      const [a, b] = [lines.map(([p]) => [...p, 0]), lines.map(([, d]) => [...d, 0])];
      const result = 'vec4(intersectUnitCube(a.xyz, b.xyz), 0.0, 0.0)';
      const got = runChunk(test, { chunks: [box], result, a, b });
      lines.forEach(([point, direction], i) => {
        const [entry, exit] = intersectUnitCube(
          point.map(Math.fround) as unknown as Vector3,
          direction.map(Math.fround) as unknown as Vector3,
        );
        // Two roundings of float32 on numbers up to 1 / |direction|.
        const scale = Math.max(1, Math.abs(entry), Math.abs(exit));
        expect(got[i][0] / scale).to.be.closeTo(entry / scale, 1e-6);
        expect(got[i][1] / scale).to.be.closeTo(exit / scale, 1e-6);
      });
    });

    for (const [name, projection] of [
      ['perspective', projectionMatrix(0.8, 1, 0.1, 100)],
      ['parallel', [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2 / 99.9, -100.1 / 99.9, 0, 0, 0, 1]],
    ] as const) {
      it(`scene depth: a depth buffer's value means the depth that the ${name} projection gave it`, () => {
        const depths = [0.11, 0.5, 3, 42, 99];
        const device = depths.map(
          (d) => (-projection[10] * d + projection[11]) / (-projection[14] * d + projection[15]),
        );
        const a = [...device.map((z) => [z / 2 + 0.5, 0, 0, 0]), [1, 0, 0, 0]];
        const unit = pointTexture(test.gl, a, 'uSceneDepth');
        const uniforms = {
          uPixelToDepth: [1 / a.length, 1, 0, 0],
          uDepthTerms: [projection[10], projection[11], projection[14], projection[15]],
          uDepthToT: [7, 4],
        };
        const got = runChunk(test, {
          chunks: [interval, ray, sceneDepth],
          result: 'vec4(surfaceT())',
          a,
          uniforms,
          units: [unit],
        });
        depths.forEach((depth, i) => {
          // 2^-24 of the device depth is depth^2 / (near * 2^24) in the world of a perspective, 100 / 2^23 in a parallel one.
          const tolerance = (depth ** 2 / 0.1 + 100) / 2 ** 22;
          expect(got[i][0] * 4 + 7, `depth ${depth}`).to.be.closeTo(depth, tolerance);
        });
        expect(got[depths.length][0]).to.be.above(1e29);
      });
    }
  });
}
