import { expect } from '@esm-bundle/chai';
import { compileProgram, useProgram } from '../../../src/renderer/device/program.ts';
import type { Uniforms } from '../../../src/renderer/device/inputs.ts';
import { createGl, pointTexture, releaseGl } from '../../helpers/gl.ts';

const fragment = `
precision highp float;
uniform float uFloat;
uniform vec2 uPair;
uniform vec3 uTriple;
uniform vec4 uFour;
uniform mat3 uNine;
uniform mat4 uSixteen;
uniform float uList[3];
uniform sampler2D uTexture;
void main() {
  gl_FragColor = uFour + uFloat + uPair.xyxy + uTriple.xyzx + vec4(uNine[2], 0.0) + uSixteen[3] + uList[2] + texture2D(uTexture, uPair);
}`;

const uniforms: Uniforms = {
  uFloat: 0.5,
  uPair: [1, 2],
  uTriple: [3, 4, 5],
  uFour: [6, 7, 8, 9],
  uNine: [1, 2, 3, 4, 5, 6, 7, 8, 9],
  uSixteen: Array.from({ length: 16 }, (_, i) => i),
  uList: [0.25, 0.75, 1.25],
  uUnknown: 3,
};

for (const version of [1, 2] as const) {
  it(`a program gets its uniforms and textures, of every kind that ours have, in WebGL ${version}`, () => {
    const test = createGl(version);
    const { gl } = test;
    const vertex = 'attribute vec3 position;\nvoid main() { gl_Position = vec4(position, 1.0); }';
    const program = compileProgram(gl, { vertex, fragment });
    const units = [pointTexture(gl, [[0, 0, 0, 0]], 'uOther'), pointTexture(gl, [[1, 1, 1, 1]], 'uTexture')];
    for (const factor of [1, 2]) {
      const scaled = Object.fromEntries(
        Object.entries(uniforms).map(([name, value]) => [
          name,
          typeof value === 'number' ? value * factor : value.map((x) => x * factor),
        ]),
      );
      useProgram(gl, program, { uniforms: scaled, units });
      const read = (name: string): unknown => gl.getUniform(program, gl.getUniformLocation(program, name)!);
      for (const name of ['uPair', 'uTriple', 'uFour', 'uNine', 'uSixteen'])
        expect([...(read(name) as Float32Array)], name).to.deep.equal(scaled[name]);
      expect(read('uFloat')).to.equal(scaled.uFloat);
      expect(read('uList[2]')).to.equal(1.25 * factor);
      expect(read('uTexture')).to.equal(1);
    }
    expect(gl.getError()).to.equal(0);
    releaseGl(test);
  });
}
