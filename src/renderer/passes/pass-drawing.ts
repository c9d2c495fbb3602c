import { raysOfLattice } from '../../optics/rays/rays.ts';
import type { RaySetup } from '../../optics/rays/rays.ts';
import { composePictureShader, gatheredPicture } from '../device/compose-picture.ts';
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

/** The drawing of all pixels of one lattice: a pixel is interpolated where the lattice before is smooth enough, and gets a ray elsewhere. */
export interface Pass extends SurfaceLattice {
  /** The target that the pass draws into. */
  readonly target: DrawTarget;
  /** What draws the pixels between those of the lattice before; null for the first pass, in which all pixels get rays. */
  readonly half: HalfPicture | null;
  /** The depths that end the rays of this pass, if they differ from those of the other passes. */
  readonly depths?: ShapeDepths;
  /** Present if this pass draws over the picture of another one, in some of its pixels. */
  readonly over?: {
    /** Called before the first rows are drawn. Binds a framebuffer. */
    readonly begin: () => void;
    readonly draw: (cast: EdgeCast) => void;
  };
}

/** The picture of a lattice, from which the next one is drawn. */
export interface HalfPicture {
  /** Interpolate all pixels of some rows, then draw rays over the pixels with more curvature. */
  draw(drawing: PassDrawing, caster: Caster, place: PassRows): void;
}

/** Rows of a pass, from the bottom. */
export interface Rows {
  readonly firstRow: number;
  readonly rows: number;
}

/** Rows of a pass of a picture. */
export interface PassRows extends Rows {
  readonly pass: Pass;
  /** Pixels of the whole picture. */
  readonly picture: Size;
}

/** The program and the inputs with which a pass is drawn. */
export interface Caster {
  /** The program that casts the rays, see renderer/ray/compose-ray.ts. */
  readonly program: WebGLProgram;
  readonly inputs: ProgramInputs;
  readonly rays: RaySetup;
  /** Length of a step in world units. */
  readonly stepLength: number;
  /** Largest curvature at which pixels are interpolated, in units of 1/255. */
  readonly maxCurvature: number;
}

/** Corners of the picture, as triangles. */
const corners = new Float32Array([-0.5, -0.5, 0, 0.5, -0.5, 0, -0.5, 0.5, 0, 0.5, 0.5, 0]);

/**
 * Draws the parts of a picture of the volume into targets, outside of x3dom's own drawing. Afterwards its programs and
 * textures are still bound; the caller has to let x3dom know.
 */
export class PassDrawing {
  #gathered: WebGLProgram | null = null;
  readonly #corners: WebGLBuffer;

  constructor(readonly gl: Gl) {
    this.#corners = fillBuffer(gl, corners);
  }

  /**
   * Draw some rows of a pass.
   * @param picture - pixels of the whole picture
   * @param part - rows from the bottom; all where absent
   */
  draw(pass: Pass, caster: Caster, picture: Size, part: Rows = { firstRow: 0, rows: pass.height }): void {
    const { gl } = this;
    // Compile the program that shows the picture first: later, the page would wait until the GPU has drawn the rays.
    this.#showing();
    if (part.firstRow === 0) pass.over?.begin();
    this.alone(() => {
      gl.bindFramebuffer(gl.FRAMEBUFFER, pass.target.framebuffer);
      gl.viewport(0, 0, pass.width, pass.height);
      gl.enable(gl.SCISSOR_TEST);
      gl.scissor(0, part.firstRow, pass.width, part.rows);
      const rays = rayUniforms(raysOfLattice(caster.rays, picture, pass), pass, caster.stepLength);
      const all = { ...caster, inputs: joined(caster.inputs, rays) };
      if (pass.half) pass.half.draw(this, all, { ...part, pass, picture });
      else if (pass.over) pass.over.draw({ ...part, program: all.program, inputs: withoutQuads(gl, all.inputs) });
      else this.#drawAll(all);
    });
  }

  /** Show a picture that has been drawn before, over the content of the framebuffer. @param size - of the framebuffer */
  show(picture: DrawTarget, { width, height }: Size): void {
    const { gl } = this;
    this.alone(() => {
      gl.enable(gl.BLEND);
      gl.blendEquation(gl.FUNC_ADD);
      gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
      this.drawCorners(this.#showing(), {
        uniforms: { uGatheredPixel: [1 / width, 1 / height] },
        units: picture.units,
      });
    });
  }

  dispose(): void {
    const { gl } = this;
    gl.deleteProgram(this.#gathered);
    gl.deleteBuffer(this.#corners);
  }

  /** Every pixel gets a ray. */
  #drawAll({ program, inputs }: Caster): void {
    const { gl } = this;
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    this.drawCorners(program, withoutQuads(gl, inputs));
  }

  /** Do some work with blending, depth test, culling and scissor off; then restore x3dom's settings of these. */
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

  #showing(): WebGLProgram {
    const { gl } = this;
    return (this.#gathered ??= compileProgram(gl, composePictureShader(gatheredPicture, isWebGl2(gl))));
  }

  /** Draw all pixels of the bound framebuffer. */
  drawCorners(program: WebGLProgram, inputs: ProgramInputs): void {
    useProgram(this.gl, program, inputs);
    this.readPositions(program, this.#corners, 3);
    this.gl.drawArrays(this.gl.TRIANGLE_STRIP, 0, 4);
  }

  /** @param numbers - of each position */
  readPositions(program: WebGLProgram, buffer: WebGLBuffer, numbers: number): void {
    const { gl } = this;
    const attribute = gl.getAttribLocation(program, 'position');
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(attribute);
    gl.vertexAttribPointer(attribute, numbers, gl.FLOAT, false, 0, 0);
  }
}

/** A buffer of positions. */
export function fillBuffer(gl: Gl, numbers: Float32Array<ArrayBuffer>): WebGLBuffer {
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
  return buffer;
}

/** The inputs of a program that draws its box instead of quads. */
export function withoutQuads(gl: Gl, inputs: ProgramInputs): ProgramInputs {
  // Even a sampler that the program never reads must not share a texture unit with a sampler of another type.
  const plane = inputs.units.findIndex(({ type }) => type === gl.TEXTURE_2D);
  return joined(inputs, { uQuads: [0, 0], uHalfPicture: plane });
}

function joined(inputs: ProgramInputs, uniforms: Uniforms): ProgramInputs {
  return joinInputs(inputs, { uniforms, units: [] });
}
