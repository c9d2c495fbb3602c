import { expect } from '@esm-bundle/chai';
import chunk from '../../../shaders/chunks/depth/between-pixels.glsl?raw';
import { emptyQuad, interpolateQuad } from '../../../src/optics/rays/between-pixels.ts';
import { bytesAttachment, DrawTarget } from '../../../src/renderer/device/draw-target.ts';
import { createGl, releaseGl, runChunk } from '../../helpers/gl.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

/** A result has four numbers. */
const parts = `
vec4 colorOf(vec2 pixel) { vec2 quad = floor(0.5 * pixel); return interpolateBetween(lookAround(quad), pixel - 2.0 * quad); }
vec4 curvatureAt(vec2 pixel) { return vec4(curvatureOf(lookAround(floor(0.5 * pixel)))); }`;

for (const version of [1, 2] as const) {
  it(`pixels between others are the twin's in WebGL ${version}, at the edges too`, () => {
    const test = createGl(version);
    const { gl } = test;
    const [width, height] = [9, 7];
    const random = randomNumbers(12);
    const half = Uint8Array.from(
      { length: 4 * width * height },
      (_, i) => 100 + 30 * Math.sin(i / 30) + (i > 150 ? 60 : 6) * random(),
    );
    const target = new DrawTarget(gl, [bytesAttachment(gl, 'uHalfPicture')]);
    target.resize(width, height);
    gl.bindTexture(gl.TEXTURE_2D, target.units[0].texture);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, half);

    // The whole picture, of which the half one has every second pixel.
    const whole = { data: new Float64Array(16 * width * height), width: 2 * width, height: 2 * height };
    for (let i = 0; i < half.length; i++) {
      const [x, y] = [(i >> 2) % width, Math.floor((i >> 2) / width)];
      whole.data[4 * (2 * y * whole.width + 2 * x) + (i & 3)] = half[i];
    }
    const a = Array.from({ length: 4 * width * height }, (_, i) => [
      i % whole.width,
      Math.floor(i / whole.width),
      0,
      0,
    ]);
    const run = (result: string): number[][] =>
      runChunk(test, {
        chunks: [chunk, parts],
        result,
        a,
        units: target.units,
        uniforms: { uHalfPixel: [1 / width, 1 / height] },
      });
    const [colors, curvatures] = [run('colorOf(a.xy)'), run('curvatureAt(a.xy)')];
    const quad = emptyQuad();
    a.forEach(([x, y], i) => {
      interpolateQuad(whole, 2, [x >> 1, y >> 1], quad);
      const at = 4 * ((x & 1) + 2 * (y & 1));
      for (let c = 0; c < 4; c++) expect(colors[i][c] * 255, `${x}, ${y}`).to.be.closeTo(quad.colors[at + c], 1e-3);
      expect(curvatures[i][0] * 255, `${x}, ${y}`).to.be.closeTo(quad.curvature, 1e-3);
    });
    const straight = curvatures.filter(([curvature]) => curvature * 255 <= 40).length;
    expect(straight / a.length).to.be.within(0.1, 0.9);
    releaseGl(test);
  });
}
