import { edgeOffsets, findEdges } from '../../optics/rays/edge-rays.ts';
import type { Gl } from '../device/device.ts';
import type { DrawTarget } from '../device/draw-target.ts';
import { joinInputs } from '../device/inputs.ts';
import { useProgram } from '../device/program.ts';
import type { EdgeCast, EdgeDrawing } from '../ray/ray-module.ts';
import { readPicture } from '../device/read-picture.ts';

/** Draws more rays for the quads of 2 x 2 pixels that an edge runs through, see optics/rays/edge-rays.ts, and for no other quads. */
export class EdgeRays implements EdgeDrawing {
  readonly offsets = edgeOffsets;
  readonly #buffer: WebGLBuffer;
  /** How many quads the picture has across and up, and the numbers of the quads in the buffer. */
  #columns = 0;
  #rows = 0;
  #quads: Float32Array<ArrayBuffer> = new Float32Array(0);
  #asPoints = false;

  constructor(readonly gl: Gl) {
    this.#buffer = gl.createBuffer();
  }

  find(picture: DrawTarget, edgeCurvature: number, asPoints: boolean): void {
    const { gl } = this;
    const { width, height } = picture;
    gl.bindFramebuffer(gl.FRAMEBUFFER, picture.framebuffer);
    this.#quads = findEdges(readPicture(gl, picture), edgeCurvature);
    [this.#columns, this.#rows, this.#asPoints] = [Math.ceil(width / 2), Math.ceil(height / 2), asPoints];
    const places = asPoints ? this.#quads : triangles(this.#quads, this.#columns, this.#rows);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.#buffer);
    gl.bufferData(gl.ARRAY_BUFFER, places, gl.STREAM_DRAW);
  }

  mix(number: number, { program, inputs, firstRow, rows }: EdgeCast): void {
    // Draw only the quads of these rows: the GPU would spend time on quads of other rows too, although they are clipped.
    const [first, end] = [Math.floor(firstRow / 2), Math.ceil((firstRow + rows) / 2)].map((row) =>
      this.#quads.findIndex((quad) => quad >= row * this.#columns),
    );
    const [from, to] = [first, end].map((index) => (index < 0 ? this.#quads.length : index));
    if (from === to) return;
    const { gl } = this;
    const quads = { uQuads: [this.#columns, this.#rows], uFirstQuadRow: 0, uMaxCurvature: -1 };
    useProgram(
      gl,
      program,
      joinInputs(inputs, { uniforms: this.#asPoints ? quads : { uBounds: [-1, -1, 1, 1] }, units: [] }),
    );
    gl.viewport(0, 0, 2 * this.#columns, 2 * this.#rows);
    gl.enable(gl.BLEND);
    gl.blendEquation(gl.FUNC_ADD);
    gl.blendColor(0, 0, 0, 1 / (number + 2));
    gl.blendFunc(gl.CONSTANT_ALPHA, gl.ONE_MINUS_CONSTANT_ALPHA);
    const attribute = gl.getAttribLocation(program, 'position');
    gl.bindBuffer(gl.ARRAY_BUFFER, this.#buffer);
    gl.enableVertexAttribArray(attribute);
    gl.vertexAttribPointer(attribute, this.#asPoints ? 1 : 2, gl.FLOAT, false, 0, 0);
    const corners = this.#asPoints ? 1 : 6;
    gl.drawArrays(this.#asPoints ? gl.POINTS : gl.TRIANGLES, corners * from, corners * (to - from));
  }

  dispose(): void {
    this.gl.deleteBuffer(this.#buffer);
  }
}

/** Two triangles for each quad, in the coordinates of the box that rays are drawn with: -0.5..0.5. For programs that draw no points. */
function triangles(quads: Float32Array, columns: number, rows: number): Float32Array<ArrayBuffer> {
  const places = new Float32Array(12 * quads.length);
  quads.forEach((quad, i) => {
    const [left, bottom] = [quad % columns, Math.floor(quad / columns)];
    const [x, y] = [
      [left, left + 1],
      [bottom, bottom + 1],
    ].map((ends, axis) => ends.map((end) => end / (axis ? rows : columns) - 0.5));
    places.set([x[0], y[0], x[1], y[0], x[0], y[1], x[1], y[0], x[1], y[1], x[0], y[1]], 12 * i);
  });
  return places;
}
