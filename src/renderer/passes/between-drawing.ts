import betweenPixels from '../../../shaders/chunks/depth/between-pixels.glsl?raw';
import betweenPixelsStage from '../../../shaders/programs/between-pixels.frag.glsl?raw';
import { composePictureShader } from '../device/compose-picture.ts';
import { isWebGl2 } from '../device/device.ts';
import type { Gl } from '../device/device.ts';
import type { DrawTarget } from '../device/draw-target.ts';
import { joinInputs } from '../device/inputs.ts';
import { compileProgram, useProgram } from '../device/program.ts';
import { fillBuffer } from './pass-drawing.ts';
import type { Caster, Pass, PassDrawing, PassRows, Size } from './pass-drawing.ts';

/** The chunks that interpolate the pixels between those of a coarser picture. */
export const interpolatedPicture: readonly string[] = [betweenPixels, betweenPixelsStage];

/** The largest number of quads in one draw call: the shader counts them in floats. */
const maxQuads = 2 ** 18;

/** Draws pixels between those of a coarser picture. */
export class BetweenDrawing {
  #program: WebGLProgram | null = null;
  #numbers: { readonly buffer: WebGLBuffer; readonly count: number } | null = null;

  constructor(readonly gl: Gl) {}

  /**
   * Interpolate all pixels of some rows, then draw rays over the pixels with more curvature.
   * @param half - the coarser picture
   */
  draw(
    half: DrawTarget,
    drawing: PassDrawing,
    { program, inputs, maxCurvature }: Caster,
    { pass, picture, firstRow, rows }: PassRows,
  ): void {
    const { gl } = this;
    const place = { uHalfPixel: [1 / half.width, 1 / half.height] };
    this.#program ??= compileProgram(gl, composePictureShader(interpolatedPicture, isWebGl2(gl)));
    drawing.drawCorners(this.#program, { uniforms: place, units: half.units });
    const [columns, all] = [Math.ceil(pass.width / 2), Math.ceil(pass.height / 2)];
    gl.viewport(0, 0, 2 * columns, 2 * all);
    const quads = {
      ...place,
      uQuads: [columns, all],
      uQuadToDevice: quadToDevice(pass, picture),
      uMaxCurvature: maxCurvature / 255,
    };
    const end = Math.ceil((firstRow + rows) / 2);
    const max = Math.max(1, Math.floor(maxQuads / columns));
    for (let row = Math.floor(firstRow / 2); row < end; row += max) {
      useProgram(gl, program, joinInputs(inputs, { uniforms: { ...quads, uFirstQuadRow: row }, units: half.units }));
      const count = columns * Math.min(max, end - row);
      drawing.readPositions(program, this.#numbered(count), 1);
      gl.drawArrays(gl.POINTS, 0, count);
    }
  }

  dispose(): void {
    this.gl.deleteProgram(this.#program);
    this.gl.deleteBuffer(this.#numbers?.buffer ?? null);
  }

  /** A buffer with the numbers 0, 1, 2 and so on. */
  #numbered(count: number): WebGLBuffer {
    if (!this.#numbers || this.#numbers.count < count) {
      this.gl.deleteBuffer(this.#numbers?.buffer ?? null);
      const numbers = Float32Array.from({ length: count }, (_, i) => i);
      this.#numbers = { buffer: fillBuffer(this.gl, numbers), count };
    }
    return this.#numbers.buffer;
  }
}

/** Maps a lattice's quads to the known pixels around them, in device coordinates of the picture, see rays.vert.glsl. */
function quadToDevice({ stride, first }: Pass, { width, height }: Size): number[] {
  const shift = (begin: number, pixels: number): number => (2 * (begin + stride) + 1) / pixels - 1;
  return [(4 * stride) / width, (4 * stride) / height, shift(first[0], width), shift(first[1], height)];
}
