import { VolumeViewError } from '../../core/errors.ts';
import type { PixelLattice, RaySetup } from '../../optics/rays/rays.ts';
import type { Gl } from '../device/device.ts';
import { bytesAttachment, DrawTarget } from '../device/draw-target.ts';
import { startReading } from '../device/read-picture.ts';
import { PassDrawing } from '../passes/pass-drawing.ts';
import type { Pass, Size } from '../passes/pass-drawing.ts';
import type { EdgeDrawing, ShapeDepths } from '../ray/ray-module.ts';
import { createProbeTarget } from '../probes/probe-target.ts';
import { makeCoarsePictures } from './adaptive-provider.ts';
import type { CoarsePictures } from './adaptive-provider.ts';
import type { View, VolumeLayer } from '../layers/volume-layer.ts';

/** The members of a layer that its pictures need. */
export type CastLayer = Pick<VolumeLayer, 'raysOf' | 'inputs' | 'surfacesModule'>;

/** How a picture of the volume is drawn. */
export interface Cast {
  /** The program that casts the rays; x3dom has compiled it. */
  readonly program: WebGLProgram;
  /** Depths of the scene's opaque shapes; null where there are none. */
  readonly depths: ShapeDepths | null;
  /** The view of a picture of this size. */
  readonly view: View;
  /** Pixels of the whole picture. */
  readonly picture: Size;
  /** Length of a step in world units. */
  readonly stepLength: number;
  /** Largest curvature at which pixels are interpolated, in units of 1/255. */
  readonly maxCurvature: number;
}

/** How edges are smoothed. */
export interface SmoothEdges {
  readonly edges: EdgeDrawing;
  /** In units of 1/255, see optics/rays/edge-rays.ts */
  readonly edgeCurvature: number;
  readonly asPoints: boolean;
}

/** Pictures of the volume that are drawn off-screen: to show them when they are complete, or to measure them. */
export class VolumePictures {
  readonly #passes: PassDrawing;
  /** The picture that was drawn last to be shown. */
  gathered: DrawTarget | null = null;
  #coarse: CoarsePictures | null = null;
  #probe: DrawTarget | null | undefined;

  constructor(
    readonly gl: Gl,
    readonly layer: CastLayer,
  ) {
    this.#passes = new PassDrawing(gl);
  }

  /**
   * The passes of a picture to be shown, one lattice of pixels after the other.
   * @param smooth - draws more rays at the picture's edges, and says what counts as an edge; null for no more rays
   */
  passes(picture: Size, isAdaptive: boolean, smooth: SmoothEdges | null = null): Pass[] {
    const target = (this.gathered ??= new DrawTarget(this.gl, [bytesAttachment(this.gl, 'uGathered')]));
    target.resize(picture.width, picture.height);
    if (isAdaptive && makeCoarsePictures) return (this.#coarse ??= makeCoarsePictures(this.gl)).passes(picture, target);
    const whole = wholePass(picture, target);
    return [whole, ...(smooth ? edgePasses(whole, smooth) : [])];
  }

  /** Draw some rows of a pass; all rows if `rows` is absent. */
  draw(pass: Pass, cast: Cast, rows?: { readonly firstRow: number; readonly rows: number }): void {
    const { program, view, picture, stepLength, maxCurvature } = cast;
    const depths = pass.depths ?? cast.depths;
    const rays = castableRays(this.layer, view);
    const inputs = this.layer.inputs(
      rays,
      depths && { depths, projection: view.projection, picture, lattice: pass, stepLength },
    );
    this.#passes.draw(pass, { program, inputs, rays, stepLength, maxCurvature }, picture, rows);
  }

  /** Show the picture, all of whose passes have been drawn, over the content of the framebuffer. @param size - of the framebuffer */
  show(size: Size): void {
    this.#passes.show(this.gathered!, size);
  }

  /**
   * Draw a picture's sparse rays, in floats.
   * @returns a function that reads the pixels, once, also after other probes: RGBA, premultiplied, 0..1, bottom row first. null where
   * the device can't draw floats
   */
  probe(lattice: PixelLattice, cast: Omit<Cast, 'maxCurvature'>): (() => Float32Array) | null {
    if (this.#probe === undefined) this.#probe = createProbeTarget(this.gl);
    const target = this.#probe;
    if (!target) return null;
    target.resize(lattice.width, lattice.height);
    this.draw({ ...lattice, target, half: null }, { ...cast, maxCurvature: 0 });
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, target.framebuffer);
    return startReading(this.gl, lattice, new Float32Array(4 * lattice.width * lattice.height));
  }

  dispose(): void {
    this.#passes.dispose();
    this.gathered?.dispose();
    this.#coarse?.dispose();
    this.#probe?.dispose();
  }
}

/** The pass that draws a picture with a ray for each pixel. */
export function wholePass({ width, height }: Size, target: DrawTarget): Pass {
  return { stride: 1, first: [0, 0], width, height, target, half: null };
}

/** More rays at the edges of a picture that has been drawn. */
function edgePasses(whole: Pass, { edges, edgeCurvature, asPoints }: SmoothEdges): Pass[] {
  return edges.offsets.map((first, number) => ({
    ...whole,
    first,
    over: {
      begin: () => number || edges.find(whole.target, edgeCurvature, asPoints),
      draw: (cast) => edges.mix(number, cast),
    },
  }));
}

/** @throws {VolumeViewError} `format/corrupt` where no ray can cross the volume */
export function castableRays(layer: Pick<CastLayer, 'raysOf'>, view: View): RaySetup {
  const rays = layer.raysOf(view);
  if (!rays) throw new VolumeViewError('format/corrupt', 'The volume is flat: its affine maps it into a plane.');
  return rays;
}
