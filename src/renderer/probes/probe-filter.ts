import { isWebGl2 } from '../device/device.ts';
import type { Gl } from '../device/device.ts';
import { compileProgram } from '../device/program.ts';

const vertex = `#version 300 es
in vec2 position;
void main() { gl_Position = vec4(position, 0.0, 1.0); }`;

const fragment = `#version 300 es
precision highp float;
uniform sampler2D uPair;
out vec4 color;
void main() {
  vec2 bytes = texture(uPair, vec2((0.5 + floor(gl_FragCoord.x) / 16.0) / 2.0, 0.5)).rg;
  float value = floor(bytes.g * 65280.0 + bytes.r * 255.0 + 0.5);
  float high = floor(value / 256.0);
  color = vec4(value - high * 256.0, high, 0.0, 255.0) / 255.0;
}`;

/**
 * Whether the device's linear filter of two 8-bit channels gives a result of 16 bits. Some filter units round their
 * output to 8 or 10 bits, which would turn 16-bit data into 8-bit data. The probe uses weights of sixteenths, which every
 * filter represents exactly.
 */
export function probeTwoByteFilter(gl: Gl): boolean {
  if (!isWebGl2(gl)) return false;
  const low = 1000;
  const high = 1300;
  const program = compileProgram(gl, { vertex, fragment });
  const source = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, source);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  gl.texImage2D(
    gl.TEXTURE_2D,
    0,
    gl.RG8,
    2,
    1,
    0,
    gl.RG,
    gl.UNSIGNED_BYTE,
    new Uint8Array(new Uint16Array([low, high]).buffer),
  );
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.LINEAR);
  for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
  const target = gl.createRenderbuffer();
  gl.bindRenderbuffer(gl.RENDERBUFFER, target);
  gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA8, 17, 1);
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, target);
  const corners = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, corners);
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 3, -1, -1, 3]), gl.STATIC_DRAW);
  gl.enableVertexAttribArray(0);
  gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
  gl.viewport(0, 0, 17, 1);
  gl.useProgram(program);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const pixels = new Uint8Array(17 * 4);
  gl.readPixels(0, 0, 17, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.deleteFramebuffer(framebuffer);
  gl.deleteRenderbuffer(target);
  gl.deleteTexture(source);
  gl.deleteBuffer(corners);
  gl.deleteProgram(program);
  gl.disableVertexAttribArray(0);
  return Array.from({ length: 17 }, (_, i) => {
    const got = pixels[i * 4] + 256 * pixels[i * 4 + 1];
    return Math.abs(got - (low + ((high - low) * i) / 16)) <= 1.5;
  }).every(Boolean);
}
