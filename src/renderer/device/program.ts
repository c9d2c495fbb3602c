import { VolumeViewError } from '../../core/errors.ts';
import type { ShaderTexts } from './compose-stage.ts';
import type { Gl } from './device.ts';
import type { ProgramInputs } from './inputs.ts';
import type { TextureUnit } from './texture-unit.ts';

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

/** @param log - the compiler's own message */
export function shaderError(log: string | null): VolumeViewError {
  return new VolumeViewError('webgl/shader', 'the graphics driver refused the program; update browser or driver', {
    cause: new Error(log ?? ''),
  });
}

interface ActiveUniform {
  readonly type: number;
  readonly location: WebGLUniformLocation;
}

const knownUniforms = new WeakMap<WebGLProgram, ReadonlyMap<string, ActiveUniform>>();

function activeUniforms(gl: Gl, program: WebGLProgram): ReadonlyMap<string, ActiveUniform> {
  const known = knownUniforms.get(program);
  if (known) return known;
  const found = new Map<string, ActiveUniform>();
  const count = (gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) as number | null) ?? 0; // null if the context is lost.
  for (let i = 0; i < count; i++) {
    const active = gl.getActiveUniform(program, i);
    const location = active && gl.getUniformLocation(program, active.name);
    if (location) found.set(active.name.replace(/\[0\]$/, ''), { type: active.type, location });
  }
  knownUniforms.set(program, found);
  return found;
}

/** Use a program, and set its inputs. Inputs that the program does not read are ignored. */
export function useProgram(gl: Gl, program: WebGLProgram, { uniforms, units }: ProgramInputs): void {
  const active = activeUniforms(gl, program);
  gl.useProgram(program);
  for (const [name, value] of Object.entries(uniforms)) {
    const uniform = active.get(name);
    if (uniform) setUniform(gl, uniform, typeof value === 'number' ? [value] : value);
  }
  units.forEach((unit, i) => {
    bindUnit(gl, unit, i);
    const uniform = active.get(unit.samplerName);
    if (uniform) gl.uniform1i(uniform.location, i);
  });
}

function setUniform(gl: Gl, { type, location }: ActiveUniform, value: readonly number[]): void {
  switch (type) {
    case gl.FLOAT:
      return gl.uniform1fv(location, value);
    case gl.FLOAT_VEC2:
      return gl.uniform2fv(location, value);
    case gl.FLOAT_VEC3:
      return gl.uniform3fv(location, value);
    case gl.FLOAT_VEC4:
      return gl.uniform4fv(location, value);
    case gl.FLOAT_MAT3:
      return gl.uniformMatrix3fv(location, false, value);
    case gl.FLOAT_MAT4:
      return gl.uniformMatrix4fv(location, false, value);
    default:
      return gl.uniform1i(location, value[0]);
  }
}

/** Bind a texture, with its filter, to the texture unit of this number. */
export function bindUnit(
  gl: Gl,
  { type, texture, wrapS, wrapT, minFilter, magFilter }: TextureUnit,
  index: number,
): void {
  gl.activeTexture(gl.TEXTURE0 + index);
  gl.bindTexture(type, texture);
  gl.texParameteri(type, gl.TEXTURE_WRAP_S, wrapS);
  gl.texParameteri(type, gl.TEXTURE_WRAP_T, wrapT);
  gl.texParameteri(type, gl.TEXTURE_MIN_FILTER, minFilter);
  gl.texParameteri(type, gl.TEXTURE_MAG_FILTER, magFilter);
}
