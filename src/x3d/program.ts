import { VolumeViewError } from '../errors.ts';
import type { ShaderTexts } from '../shader/compose.ts';
import type { Gl } from './device.ts';

/**
 * Compile and link a program.
 * @throws {VolumeViewError} `webgl/shader` with the compiler's own words
 */
export function compileProgram(gl: Gl, { vertex, fragment }: ShaderTexts): WebGLProgram {
  const program = gl.createProgram();
  const shaders = [compileStage(gl, gl.VERTEX_SHADER, vertex), compileStage(gl, gl.FRAGMENT_SHADER, fragment)];
  for (const shader of shaders) gl.attachShader(program, shader);
  gl.bindAttribLocation(program, 0, 'position');
  gl.linkProgram(program);
  const linked = gl.getProgramParameter(program, gl.LINK_STATUS) as boolean;
  const log = gl.getProgramInfoLog(program);
  for (const shader of shaders) gl.deleteShader(shader);
  if (!linked && !gl.isContextLost()) {
    gl.deleteProgram(program);
    throw shaderError(log);
  }
  return program;
}

function compileStage(gl: Gl, type: number, text: string): WebGLShader {
  const shader = gl.createShader(type)!;
  gl.shaderSource(shader, text);
  gl.compileShader(shader);
  if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
    const log = gl.getShaderInfoLog(shader);
    gl.deleteShader(shader);
    throw shaderError(log);
  }
  return shader;
}

/** @param log - the compiler's own words */
export function shaderError(log: string | null): VolumeViewError {
  return new VolumeViewError(
    'webgl/shader',
    'The graphics driver refused the ray-caster\'s program. Update the browser or the driver; if it stays, report it with the cause given here.',
    { cause: new Error(log ?? 'no log') },
  );
}
