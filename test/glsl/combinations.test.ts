import { expect } from '@esm-bundle/chai';
import { composePictureShader, composeShader, featureKey } from '../../src/renderer/compose.ts';
import { isLegal, legalCombinations } from '../../src/renderer/features.ts';
import { polarSampling } from '../../src/radar/gpu/polar-shader.ts';
import { composeStudyShader } from '../../src/renderer/study.ts';
import { loadX3dom } from '../../src/x3d/load-x3dom.ts';
import { compileProgram } from '../../src/renderer/program.ts';
import { createGl, plainFeatures, releaseGl } from '../helpers/gl.ts';

/** What x3dom puts into a ComposedShader's texts before it compiles them. */
interface Injector {
  injectVRPartsVS(text: string): string;
  injectVRPartsFS(text: string): string;
}

describe('the composed shader', () => {
  for (const version of [1, 2] as const) {
    const combinations = legalCombinations().filter((features) => features.webgl2 === (version === 2));

    it(`compiles and links in WebGL ${version} in all of its ${combinations.length} combinations, as x3dom changes it`, async () => {
      const x3dom = await loadX3dom() as unknown as { shader: { ComposedShader: { prototype: Injector } } };
      const injector = x3dom.shader.ComposedShader.prototype;
      const test = createGl(version);
      try {
        for (const features of combinations) {
          const { vertex, fragment } = composeShader(features, polarSampling);
          const texts = { vertex: injector.injectVRPartsVS(vertex), fragment: injector.injectVRPartsFS(fragment) };
          expect(texts.fragment, 'x3dom found main()').to.contain('isVR').and.to.contain('FRAGMENT_COLOR = ');
          try {
            test.gl.deleteProgram(compileProgram(test.gl, texts));
          } catch (error) {
            throw new Error(`${featureKey(features)}: ${String((error as Error).cause)}`, { cause: error });
          }
        }
      } finally {
        releaseGl(test);
      }
    });

    it(`compiles as the programs that draw pictures from pictures, in WebGL ${version}`, () => {
      const test = createGl(version);
      for (const program of ['between', 'gathered'] as const) test.gl.deleteProgram(compileProgram(test.gl, composePictureShader(program, version === 2)));
      expect(test.gl.getError()).to.equal(0);
      releaseGl(test);
    });

    it(`a text that WebGL ${version} does not take is refused with the compiler's words`, () => {
      const test = createGl(version);
      const { vertex, fragment } = composeShader(plainFeatures(version));
      expect(() => compileProgram(test.gl, { vertex, fragment: fragment.replace('vec4 accumulated', 'vec3 accumulated') }))
        .to.throw().with.property('code', 'webgl/shader');
      releaseGl(test);
    });
  }

  it('compiles as the other programs of the study and the benchmark', () => {
    const test = createGl(2);
    const features = { ...plainFeatures(2), texture3d: true };
    for (const program of ['printed', 'plain', 'shipped', 'shown', 'fetched'] as const) {
      try {
        test.gl.deleteProgram(compileProgram(test.gl, composeStudyShader(program, features)));
      } catch (error) {
        throw new Error(`${program}: ${String((error as Error).cause)}`, { cause: error });
      }
    }
    expect(test.gl.getError()).to.equal(0);
    releaseGl(test);
  });

  it('has every feature on and off among the legal combinations, and none of the impossible ones', () => {
    const combinations = legalCombinations();
    expect(new Set(combinations.map(featureKey)).size).to.equal(combinations.length);
    for (const name of Object.keys(combinations[0]) as (keyof (typeof combinations)[0])[]) {
      expect(new Set(combinations.map((features) => features[name])).size, name).to.equal(2);
    }
    expect(isLegal({ ...plainFeatures(1), texture3d: true })).to.equal(false);
    expect(isLegal({ ...plainFeatures(2), noData: true })).to.equal(false);
    expect(isLegal({ ...plainFeatures(2), polar: true })).to.equal(false);
    expect(isLegal({ ...plainFeatures(2), polar: true, noData: true, filterInShader: true, texture3d: true })).to.equal(false);
    expect(isLegal({ ...plainFeatures(2), slices: true })).to.equal(false);
    expect(isLegal({ ...plainFeatures(2), surfaces: true, adaptive: true })).to.equal(false);
  });

  it('is put together once a combination', () => {
    const features = plainFeatures(2);
    expect(composeShader({ ...features })).to.equal(composeShader(features));
    expect(composeShader({ ...features, surfaces: true }).fragment).to.contain('uSceneDepth');
    expect(composeShader(features).fragment).not.to.contain('uniform sampler2D uSceneDepth');
    expect(composeShader({ ...features, adaptive: true }).vertex).to.contain('uHalfPicture');
    expect(composeShader(features).vertex, 'some devices can\'t').not.to.contain('uniform sampler2D');
  });
});
