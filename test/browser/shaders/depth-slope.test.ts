import { expect } from '@esm-bundle/chai';
import sceneDepth from '../../../shaders/chunks/depth/scene-depth.glsl?raw';
import { depthSlope } from '../../../src/optics/rays/depth-slope.ts';
import { createGl, releaseGl, runChunk } from '../../helpers/gl.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

describe('the slope of a depth buffer', () => {
  it('is that of a plane, of the side without an edge, and nothing at a line', () => {
    expect(depthSlope(0.5, 0.51, 0.52)).to.be.closeTo(0.01, 1e-12);
    expect(depthSlope(0.5, 0.5, 0.5)).to.equal(0);
    for (const there of [0.2, 1]) {
      expect(depthSlope(0.5, 0.51, there), 'an edge after it').to.be.closeTo(0.01, 5e-4);
      expect(depthSlope(there, 0.51, 0.52), 'and before').to.be.closeTo(0.01, 5e-4);
    }
    expect(depthSlope(1, 0.5, 1)).to.equal(0);
    expect(Math.abs(depthSlope(1, 0.5, 0.9)), 'a line before something').to.be.below(0.1);
  });

  for (const version of [1, 2] as const) {
    it(`is the twin's in WebGL ${version}`, () => {
      const test = createGl(version);
      const random = randomNumbers(8);
      const a = Array.from({ length: 300 }, (_, i) => {
        const here = random();
        const [before, after] = [random() - 0.5, random() - 0.5].map((x) => here + x * 10 ** -(i % 6));
        return [before, here, after, 0].map(Math.fround);
      });
      const chunks = [
        'struct Interval { float entry; float exit; vec4 behind; };',
        'struct Ray { vec3 point; vec3 direction; };',
        sceneDepth,
      ];
      const got = runChunk(test, {
        defines: {},
        chunks,
        result: 'vec4(depthSlope(a.xz, a.y, a.zx), 0.0, 0.0)',
        a,
        units: [],
        uniforms: {},
      });
      a.forEach(([before, here, after], i) => {
        const min = Math.min(Math.abs(here - before), Math.abs(after - here));
        expect(got[i][0], `${before}, ${here}, ${after}`).to.be.closeTo(
          depthSlope(before, here, after),
          1e-4 * min + 1e-12,
        );
        expect(got[i][1], 'the other way round, on the other axis').to.be.closeTo(-got[i][0], 1e-4 * min + 1e-12);
        expect(Math.abs(got[i][0]), 'no more than an edge').to.be.at.most(1.3 * min);
      });
      releaseGl(test);
    });
  }
});
