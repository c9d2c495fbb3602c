import { expect } from '@esm-bundle/chai';
import { readUniformsOnce } from '../../../../src/renderer/ray/read-uniforms-once.ts';

/** As they are written, and as the build leaves them. */
const texts: readonly (readonly [what: string, chunks: readonly string[], main: string])[] = [
  [
    'as it is written',
    [
      '/// A scale.\nuniform float uScale;\nuniform vec4 uColors[2];\nuniform sampler2D uTable;\n',
      '#if FAR\nuniform vec3 uShift;\n#endif\nfloat scaled(float x) { return uScale * x; }\n',
    ],
    'void main() {\n  FRAGMENT_COLOR = uColors[1] * scaled(1.0);\n}\n',
  ],
  [
    'in few lines',
    [
      'uniform float uScale;uniform vec4 uColors[2];uniform sampler2D uTable;',
      '#if FAR\nuniform vec3 uShift;\n#endif\nfloat scaled(float x){return uScale*x;}',
    ],
    'void main(){FRAGMENT_COLOR=uColors[1]*scaled(1.0);}',
  ],
];

describe('reading uniforms once', () => {
  for (const [what, chunks, main] of texts) {
    const [first, second, last] = readUniformsOnce(chunks, main);
    it(`holds copies of numbers and vectors, ${what}`, () => {
      expect(first).to.match(/uniform float uScale;\nfloat heldScale;\n#define HOLDS_Scale\n/);
      expect(second)
        .to.match(/return heldScale ?\* ?x;/)
        .and.not.to.contain('uScale');
      expect(last).to.match(/void main\(\) ?\{\n#ifdef HOLDS_Scale\n {2}heldScale = uScale;\n#endif\n/);
    });
    it(`leaves samplers and arrays alone, and knows of options, ${what}`, () => {
      expect(first).to.contain('uniform sampler2D uTable;').and.to.contain('uniform vec4 uColors[2];');
      expect(`${first}${second}${last}`).not.to.contain('heldColors').and.not.to.contain('heldTable');
      expect(second.slice(second.indexOf('#if FAR'), second.indexOf('#endif'))).to.contain('#define HOLDS_Shift');
      expect(last.slice(last.indexOf('#ifdef HOLDS_Shift'))).to.contain('heldShift = uShift;');
    });
  }
});
