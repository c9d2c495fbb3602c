import { raysOfLattice } from '../../optics/rays/rays.ts';
import type { RaySetup } from '../../optics/rays/rays.ts';
import { composePictureShader } from '../device/compose-picture.ts';
import type { PictureProgram } from '../device/compose-picture.ts';
import { isWebGl2 } from '../device/device.ts';
import type { Gl } from '../device/device.ts';
import type { DrawTarget } from '../device/draw-target.ts';
import { joinInputs } from '../device/inputs.ts';
import type { ProgramInputs, Uniforms } from '../device/inputs.ts';
import { compileProgram, useProgram } from '../device/program.ts';
import type { EdgeCast, ShapeDepths, SurfaceLattice } from '../ray/ray-module.ts';
import { rayUniforms } from '../ray/uniforms.ts';

/** Pixels across and down. */
export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Drawing all pixels of one lattice: those that the lattice before tells enough of are interpolated, others get rays. */
export interface Pass extends SurfaceLattice {
  /** What it is drawn into. */
  readonly target: DrawTarget;
  /** The lattice before; null for the first, in which all pixels get rays. */
  readonly half: DrawTarget | null;
  /** What ends its rays, where that is not what ends all others. */
  readonly depths?: ShapeDepths;
  /** For a lattice drawn over another one, in some of its pixels. */
  readonly over?: {
    /** What comes first. Binds a framebuffer. */
    readonly begin: () => void;
    readonly draw: (cast: EdgeCast) => void;
  };
}

/** What a pass is drawn with. */
export interface Caster {
  /** Casts the rays, see renderer/ray/compose-ray.ts. */
  readonly program: WebGLProgram;
  readonly inputs: ProgramInputs;
  readonly rays: RaySetup;
  /** World length. */
  readonly stepLength: number;
  /** Largest curvature at which pixels are interpolated, 1/255. */
  readonly maxCurvature: number;
}

/** Corners of the picture, as triangles. */
const corners = new Float32Array([-0.5, -0.5, 0, 0.5, -0.5, 0, -0.5, 0.5, 0, 0.5, 0.5, 0]);

/** Quads that one call draws at the most: floats count them. */
const maxQuads = 2 ** 18;

/**
 * Draws what a picture of the volume is made from into targets, outside of what x3dom draws. Programs and textures stay
 * in use; x3dom has to be told.
 */
export class PassDrawing {
  readonly #programs = new Map<PictureProgram, WebGLProgram>();
  readonly #corners: WebGLBuffer;
  #numbers: { readonly buffer: WebGLBuffer; readonly count: number } | null = null;

  constructor(readonly gl: Gl) {
    this.#corners = this.#fill(corners);
  }

  /**
   * Draw some rows of a pass.
   * @param picture - pixels of the whole picture
   * @param part - rows from the bottom; all where absent
   */
  draw(pass: Pass, caster: Caster, picture: Size, part: { readonly firstRow: number; readonly rows: number } = { firstRow: 0, rows: pass.height }): void {
    const { gl } = this;
    // What shows it is compiled first: afterwards the page would wait for rays that are being drawn.
    this.#program('gathered');
    if (part.firstRow === 0) pass.over?.begin();
    this.alone(() => {
      gl.bindFramebuffer(gl.FRAMEBUFFER, pass.target.framebuffer);
      gl.viewport(0, 0, pass.width, pass.height);
      gl.enable(gl.SCISSOR_TEST);
      gl.scissor(0, part.firstRow, pass.width, part.rows);
      const rays = rayUniforms(raysOfLattice(caster.rays, picture, pass), pass, caster.stepLength);
      const all = { ...caster, inputs: joined(caster.inputs, { ...rays, uQuadToDevice: quadToDevice(pass, picture) }) };
      if (pass.half) this.#drawBetween(pass.half, all, pass, part);
      else if (pass.over) pass.over.draw({ ...part, program: all.program, inputs: withoutQuads(gl, all.inputs) });
      else this.#drawAll(all);
    });
  }

  /** Show a picture that has been drawn before, over what is there. @param size - of what is drawn into */
  show(picture: DrawTarget, { width, height }: Size): void {
    const { gl } = this;
    this.alone(() => {
      gl.enable(gl.BLEND);
      gl.blendEquation(gl.FUNC_ADD);
      gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
      this.drawCorners(this.#program('gathered'), { uniforms: { uGatheredPixel: [1 / width, 1 / height] }, units: picture.units });
    });
  }

  dispose(): void {
    const { gl } = this;
    for (const program of this.#programs.values()) gl.deleteProgram(program);
    gl.deleteBuffer(this.#corners);
    gl.deleteBuffer(this.#numbers?.buffer ?? null);
  }

  /** Every pixel gets a ray. */
  #drawAll({ program, inputs }: Caster): void {
    const { gl } = this;
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    this.drawCorners(program, withoutQuads(gl, inputs));
  }

  /** All pixels are interpolated, and rays drawn over those with more curvature. */
  #drawBetween(half: DrawTarget, { program, inputs, maxCurvature }: Caster, { width, height }: Size, { firstRow, rows }: { firstRow: number; rows: number }): void {
    const { gl } = this;
    const place = { uHalfPixel: [1 / half.width, 1 / half.height] };
    this.drawCorners(this.#program('between'), { uniforms: place, units: half.units });
    const [columns, all] = [Math.ceil(width / 2), Math.ceil(height / 2)];
    gl.viewport(0, 0, 2 * columns, 2 * all);
    const end = Math.ceil((firstRow + rows) / 2);
    const most = Math.max(1, Math.floor(maxQuads / columns));
    for (let row = Math.floor(firstRow / 2); row < end; row += most) {
      const uniforms = { ...place, uQuads: [columns, all], uFirstQuadRow: row, uMaxCurvature: maxCurvature / 255 };
      useProgram(gl, program, joinInputs(inputs, { uniforms, units: half.units }));
      const count = columns * Math.min(most, end - row);
      this.#readPositions(program, this.#numbered(count), 1);
      gl.drawArrays(gl.POINTS, 0, count);
    }
  }

  /** Nothing else has a say in what is drawn; x3dom's switches are then as before. */
  alone(work: () => void): void {
    const { gl } = this;
    const switches = [gl.BLEND, gl.DEPTH_TEST, gl.CULL_FACE, gl.SCISSOR_TEST];
    const wereOn = switches.filter((one) => gl.isEnabled(one));
    for (const one of switches) gl.disable(one);
    try {
      work();
    } finally {
      for (const one of switches) gl.disable(one);
      for (const one of wereOn) gl.enable(one);
    }
  }

  #program(name: PictureProgram): WebGLProgram {
    let program = this.#programs.get(name);
    if (!program) this.#programs.set(name, (program = compileProgram(this.gl, composePictureShader(name, isWebGl2(this.gl)))));
    return program;
  }

  /** Draw all pixels of what is bound. */
  drawCorners(program: WebGLProgram, inputs: ProgramInputs): void {
    useProgram(this.gl, program, inputs);
    this.#readPositions(program, this.#corners, 3);
    this.gl.drawArrays(this.gl.TRIANGLE_STRIP, 0, 4);
  }

  #readPositions(program: WebGLProgram, buffer: WebGLBuffer, numbers: number): void {
    const { gl } = this;
    const attribute = gl.getAttribLocation(program, 'position');
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(attribute);
    gl.vertexAttribPointer(attribute, numbers, gl.FLOAT, false, 0, 0);
  }

  /** 0, 1, 2 and so on. */
  #numbered(count: number): WebGLBuffer {
    if (!this.#numbers || this.#numbers.count < count) {
      this.gl.deleteBuffer(this.#numbers?.buffer ?? null);
      this.#numbers = { buffer: this.#fill(Float32Array.from({ length: count }, (_, i) => i)), count };
    }
    return this.#numbers.buffer;
  }

  #fill(numbers: Float32Array<ArrayBuffer>): WebGLBuffer {
    const { gl } = this;
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
    return buffer;
  }
}

/** Where the known pixels around a lattice's quads are in the picture, see rays.vert.glsl. */
function quadToDevice({ stride, first }: Pass, { width, height }: Size): number[] {
  const shift = (begin: number, pixels: number): number => (2 * (begin + stride) + 1) / pixels - 1;
  return [(4 * stride) / width, (4 * stride) / height, shift(first[0], width), shift(first[1], height)];
}

/** What a program reads that draws its box instead of quads. */
export function withoutQuads(gl: Gl, inputs: ProgramInputs): ProgramInputs {
  // A sampler that nothing is read from may still not share its texture with one of another kind.
  const plane = inputs.units.findIndex(({ type }) => type === gl.TEXTURE_2D);
  return joined(inputs, { uQuads: [0, 0], uHalfPicture: plane });
}

function joined(inputs: ProgramInputs, uniforms: Uniforms): ProgramInputs {
  return joinInputs(inputs, { uniforms, units: [] });
}
