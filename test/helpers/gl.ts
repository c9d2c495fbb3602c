import { composeStage } from '../../src/renderer/device/compose-stage.ts';
import type { Defines } from '../../src/renderer/device/compose-stage.ts';
import { isWebGl2 } from '../../src/renderer/device/device.ts';
import type { Device, Gl } from '../../src/renderer/device/device.ts';
import { describe as describeDevice } from '../../src/renderer/probes/probe-device.ts';
import { probeTwoByteFilter } from '../../src/renderer/probes/probe-filter.ts';
import { bindUnit, compileProgram, useProgram } from '../../src/renderer/device/program.ts';
import type { Uniforms } from '../../src/renderer/device/inputs.ts';
import { textureUnit } from '../../src/renderer/device/texture-unit.ts';
import type { TextureUnit } from '../../src/renderer/device/texture-unit.ts';

/** A context of a WebGL version that can draw into float textures, and its abilities. */
export interface TestGl {
  readonly version: 1 | 2;
  readonly gl: Gl;
  readonly device: Device;
}

/** Create a context. Release it with `releaseGl`, because a page gets only 16 of them. */
export function createGl(version: 1 | 2): TestGl {
  const gl = document.createElement('canvas').getContext(version === 2 ? 'webgl2' : 'webgl') as Gl;
  const device = { ...describeDevice(gl), twoByteLinear: probeTwoByteFilter(gl) };
  const floatTarget = version === 2 ? 'EXT_color_buffer_float' : 'WEBGL_color_buffer_float';
  if (!gl.getExtension(floatTarget)) throw new Error(`this browser can not draw into floats: no ${floatTarget}`);
  return { version, gl, device };
}

export function releaseGl({ gl }: TestGl): void {
  gl.getExtension('WEBGL_lose_context')?.loseContext();
}

export interface ChunkRun {
  /** Defines that are absent are 0. */
  readonly defines?: Defines;
  /** The chunks under test. */
  readonly chunks: readonly string[];
  /** A GLSL expression of a vec4, which uses `vec4 a` (and `vec4 b`), the inputs of one point. */
  readonly result: string;
  /** The inputs: four numbers for each point. */
  readonly a: readonly (readonly number[])[];
  readonly b?: readonly (readonly number[])[];
  readonly uniforms?: Uniforms;
  readonly units?: readonly TextureUnit[];
}

/**
 * Run a chunk once for every point on a small float target.
 * @returns four float32 numbers for each point
 */
export function runChunk({ gl, version }: TestGl, run: ChunkRun): number[][] {
  const main = `
    uniform sampler2D uA;
    uniform sampler2D uB;
    uniform float uCount;
    void main() {
      vec2 place = vec2(gl_FragCoord.x / uCount, 0.5);
      vec4 a = texture2D(uA, place);
      vec4 b = texture2D(uB, place);
      FRAGMENT_COLOR = ${run.result};
    }`;
  const stage = { webgl2: version === 2, defines: { TWO_BYTES: 0, RADIAL_ELEVATIONS: 0, ...run.defines } };
  const vertex = composeStage({ ...stage, stage: 'VERTEX_STAGE' }, [
    'attribute vec3 position;\nvoid main() { gl_Position = vec4(position, 1.0); }',
  ]);
  const program = compileProgram(gl, {
    vertex,
    fragment: composeStage({ ...stage, stage: 'FRAGMENT_STAGE' }, [...run.chunks, main]),
  });
  const inputs = [pointTexture(gl, run.a, 'uA'), pointTexture(gl, run.b ?? run.a, 'uB')];
  const output = pointTexture(gl, run.a, 'output');
  useProgram(gl, program, {
    uniforms: { ...run.uniforms, uCount: run.a.length },
    units: [...(run.units ?? []), ...inputs],
  });
  return drawAndRead(gl, output.texture, run.a.length);
}

/** A row of float texels, one for each point. */
export function pointTexture(gl: Gl, points: readonly (readonly number[])[], samplerName: string): TextureUnit {
  const texels = new Float32Array(points.length * 4);
  points.forEach((point, i) => texels.set(point, i * 4));
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, isWebGl2(gl) ? gl.RGBA32F : gl.RGBA, points.length, 1, 0, gl.RGBA, gl.FLOAT, texels);
  const unit = textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter: gl.NEAREST, samplerName });
  bindUnit(gl, unit, 15);
  return unit;
}

function drawAndRead(gl: Gl, target: WebGLTexture, count: number): number[][] {
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
  if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE)
    throw new Error('the float target is incomplete');
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), gl.STATIC_DRAW);
  gl.enableVertexAttribArray(0);
  gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
  gl.viewport(0, 0, count, 1);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const texels = new Float32Array(count * 4);
  gl.readPixels(0, 0, count, 1, gl.RGBA, gl.FLOAT, texels);
  const error = gl.getError();
  if (error) throw new Error(`WebGL error ${error}`);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.deleteFramebuffer(framebuffer);
  return Array.from({ length: count }, (_, i) => [...texels.subarray(i * 4, i * 4 + 4)]);
}
