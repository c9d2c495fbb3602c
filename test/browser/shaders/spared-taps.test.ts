// Normals are looked for only where something shows: the shaders of lit and styled volumes, over a field that counts what is read of it.
import { expect } from '@esm-bundle/chai';
import segmentChunk from '../../../shaders/chunks/walk/segment.glsl?raw';
import { sampleStruct } from '../../../src/renderer/ray/generate-chains.ts';
import { litText } from '../../../src/renderer/ray/modules/lit.ts';
import { pointsModule } from '../../../src/renderer/ray/modules/points.ts';
import { cartesianTapsOf } from '../../../src/renderer/ray/modules/field-taps.ts';
import { styledText } from '../../../src/renderer/ray/modules/styled.ts';
import { createGl, releaseGl, runChunk } from '../../helpers/gl.ts';

/** What a shading module reads of others; a field that counts its taps. */
const counted = `
uniform vec3 uDimensions;
uniform float uOpticalScale;
float taps = 0.0;
struct Ray { vec3 direction; };
Ray rayOfPixel() { return Ray(vec3(0.0, 0.0, 1.0)); }
float toShare(float stored) { return stored; }
`;
const countingTaps = `
#define TAPS_IN_LOOP
vec3 beginTaps(vec3 p) { return p; }
vec3 growsTowards(vec3 p, vec3 from, vec3 perVoxel) { return perVoxel; }
vec3 tapSteps(vec3 from) { return vec3(0.1); }
bool tapField(vec3 at, out float stored) {
  taps++;
  stored = at.x;
  return true;
}
`;

/** Taps of a piece of a ray and of the one that goes on from its end, by what is seen of each; and whether what does not show stays as it is. */
const count = (shade: string): string => `
vec4 count(vec4 visible, vec4 seen) {
  Sample ends[3];
  for (int i = 0; i < 3; i++) {
    ends[i].value = 0.5;
    ends[i].point = vec3(0.4 + 0.1 * float(i));
  }
  float span = 0.25;
  vec4 first = vec4(0.5, 0.25, 0.0, 1.0) * seen.x;
  vec4 second = vec4(0.5, 0.25, 0.0, 1.0) * seen.y;
  vec4 one = ${shade}(Segment(ends[0], ends[1], 0.0, span, visible.x), first);
  float before = taps;
  vec4 other = ${shade}(Segment(ends[1], ends[2], span, span, visible.y), second);
  return vec4(before, taps - before, one == first ? 1.0 : 0.0, other == second ? 1.0 : 0.0);
}
`;

const min = 1 / 1024;
const pieces: readonly (readonly [
  name: string,
  visible: readonly [number, number],
  opacities: readonly [number, number],
  taps: readonly [number, number],
])[] = [
  ['both show: where the second one begins is known', [1, 1], [0.1, 0.1], [12, 6]],
  ['nothing is there', [1, 1], [0, 0], [0, 0]],
  ['nothing is there, and then something', [1, 1], [0, 0.1], [0, 12]],
  ['something, and then nothing', [1, 1], [0.1, 0], [12, 0]],
  ['all is hidden', [0, 0], [0.9, 0.9], [0, 0]],
  ['less is to be seen than counts', [0.9 * min, 1.1 * min], [1, 1], [0, 12]],
  ['less is there than counts, by its length', [1, 1], [0.9 * min * 0.25, 1.1 * min * 0.25], [0, 12]],
];

for (const version of [1, 2] as const) {
  for (const make of [litText, styledText]) {
    const text = make({ taps: { ...cartesianTapsOf, chunk: countingTaps }, lights: false, cuts: false });
    it(`${text.name} in WebGL ${version}: six taps at an end of a piece that shows, and none where nothing does`, () => {
      const test = createGl(version);
      try {
        const got = runChunk(test, {
          defines: { ...text.defines, NO_DATA: 0, FOLDS: 0 },
          chunks: [sampleStruct([pointsModule]), segmentChunk, counted, ...text.chunks, count(`${text.name}Shade`)],
          result: 'count(a, b)',
          a: pieces.map(([, [one, other]]) => [one, other, 0, 0]),
          b: pieces.map(([, , [one, other]]) => [one, other, 0, 0]),
          uniforms: { uDimensions: [10, 10, 10], uPerFlat: 1, uHeadlight: 1, uOpticalScale: 1 },
        });
        pieces.forEach(([name, , , taps], i) => {
          expect(got[i].slice(0, 2), name).to.deep.equal(taps);
          expect(
            got[i].slice(2).map((stays, piece) => stays === 1 || taps[piece] > 0),
            name,
          ).to.deep.equal([true, true]);
        });
      } finally {
        releaseGl(test);
      }
    });
  }
}
