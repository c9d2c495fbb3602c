import { expect } from '@esm-bundle/chai';
import vote from '../../../shaders/chunks/field/vote.glsl?raw';
import { voteOfCorners } from '../../../src/optics/rays/vote.ts';
import { createGl, releaseGl, runChunk } from '../../helpers/gl.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

/** Eight corners as the digits of a number to the base of 4. */
const voteOf = `
vec4 digitsOf(float code) {
  return floor(mod(vec4(code, floor(code / 4.0), floor(code / 16.0), floor(code / 64.0)) + 0.01, 4.0));
}
vec4 voteOf(vec4 a) {
  return vec4(voteOfCorners(digitsOf(a.w), digitsOf(floor(a.w / 256.0)), a.xyz));
}`;

it("the vote of eight corners is the twin's, and one of them also where several have as many votes", () => {
  const random = randomNumbers(77);
  // Quarters are exact in float32, and many of them draws.
  const a = Array.from({ length: 1200 }, (_, n) => [
    ...[0, 0, 0].map(() => (n % 3 === 0 ? Math.floor(random() * 5) / 4 : Math.fround(random()))),
    Math.floor(random() * 65536),
  ]);
  const test = createGl(2);
  try {
    const got = runChunk(test, { chunks: [vote, voteOf], result: 'voteOf(a)', a });
    const off = a.filter(([x, y, z, code], i) => {
      const corners = Uint8Array.from({ length: 8 }, (_, c) => Math.floor(code / 4 ** c) % 4);
      return got[i][0] !== voteOfCorners(corners, [2, 2, 2], [x / 2 + 0.25, y / 2 + 0.25, z / 2 + 0.25]);
    });
    expect(off).to.deep.equal([]);
  } finally {
    releaseGl(test);
  }
});
