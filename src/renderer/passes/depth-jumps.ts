import type { Pixels } from '../../optics/rays/between-pixels.ts';
import type { DeviceRectangle } from '../../optics/cells/bound-seen-cells.ts';
import { raysOfLattice } from '../../optics/rays/rays.ts';
import type { RaySetup } from '../../optics/rays/rays.ts';
import { isWebGl2 } from '../device/device.ts';
import type { Gl } from '../device/device.ts';
import { bytesAttachment, DrawTarget } from '../device/draw-target.ts';
import { joinInputs } from '../device/inputs.ts';
import type { ProgramInputs } from '../device/inputs.ts';
import { composeDepthJumps } from './depth-jumps-text.ts';
import { PassDrawing } from './pass-drawing.ts';
import { compileProgram } from '../device/program.ts';
import type { Surfaces } from '../ray/ray-module.ts';
import { readPicture } from '../device/read-picture.ts';
import type { TextureUnit } from '../device/texture-unit.ts';
import { rayUniforms } from '../ray/uniforms.ts';

/**
 * Finds the quads of 2 x 2 pixels of a lattice that can't be interpolated: shapes end rays there, and the coarser lattice before
 * does not show it. See optics/rays/depth-jumps.ts
 */
export class DepthJumps {
  readonly #passes: PassDrawing;
  readonly #program: WebGLProgram;
  /** One target for each stride of a lattice. */
  readonly #targets = new Map<number, DrawTarget>();
  #last: DrawTarget | null = null;

  constructor(readonly gl: Gl) {
    this.#passes = new PassDrawing(gl);
    this.#program = compileProgram(gl, composeDepthJumps(isWebGl2(gl)));
  }

  /** @param depth - inputs that give the depth of the shapes that end rays: uniforms of the lattice, and the texture */
  draw(
    rays: RaySetup,
    { lattice, depths, picture, stepLength }: Surfaces,
    depth: ProgramInputs,
  ): readonly TextureUnit[] {
    const target = (this.#last = this.#targetOf(lattice.stride));
    target.resize(Math.ceil(lattice.width / 2), Math.ceil(lattice.height / 2));
    const { solid, solidBounds, bounds } = depths;
    const uniforms = {
      ...rayUniforms(raysOfLattice(rays, picture, lattice), lattice, stepLength),
      uSolids: Number(solidBounds !== null),
    };
    const solids = { uniforms, units: [{ ...solid.units[0], samplerName: 'uSolidDepth' }] };
    const part = quadsWithin(rays.bounds, lattice.isCoarse ? solidBounds : bounds, { lattice, picture });
    const { gl } = this;
    this.#passes.alone(() => {
      gl.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffer);
      gl.viewport(0, 0, target.width, target.height);
      gl.clearColor(0, 0, 0, 0);
      gl.clear(gl.COLOR_BUFFER_BIT);
      gl.enable(gl.SCISSOR_TEST);
      gl.scissor(...part);
      this.#passes.drawCorners(this.#program, joinInputs(depth, solids));
    });
    return target.units;
  }

  /** Read the last result, a pixel for each quad. Binds its framebuffer. */
  read(): Pixels {
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, this.#last!.framebuffer);
    return readPicture(this.gl, this.#last!);
  }

  #targetOf(stride: number): DrawTarget {
    let target = this.#targets.get(stride);
    if (!target)
      this.#targets.set(stride, (target = new DrawTarget(this.gl, [bytesAttachment(this.gl, 'uDepthJumps')])));
    return target;
  }

  dispose(): void {
    this.#passes.dispose();
    this.gl.deleteProgram(this.#program);
    for (const target of this.#targets.values()) target.dispose();
  }
}

/** The quads of a lattice that touch both rectangles of the picture: left, bottom, width and height. */
function quadsWithin(
  volume: DeviceRectangle,
  shapes: DeviceRectangle | null,
  { lattice: { stride }, picture }: Pick<Surfaces, 'lattice' | 'picture'>,
): readonly [number, number, number, number] {
  if (!shapes) return [0, 0, 0, 0];
  const quad = (device: number, pixels: number): number => (((device + 1) / 2) * pixels) / (2 * stride);
  const from = [0, 1].map((axis) =>
    Math.max(0, Math.floor(quad(Math.max(volume[axis], shapes[axis]), axis ? picture.height : picture.width)) - 1),
  );
  const to = [2, 3].map((axis) =>
    Math.ceil(quad(Math.min(volume[axis], shapes[axis]), axis === 3 ? picture.height : picture.width)),
  );
  return [from[0], from[1], Math.max(0, to[0] - from[0]), Math.max(0, to[1] - from[1])];
}
