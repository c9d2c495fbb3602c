import sceneDepth from '../../../shaders/chunks/depth/scene-depth.glsl?raw';
import edgeSplit from '../../../shaders/chunks/depth/edge-split.glsl?raw';
import interval from '../../../shaders/chunks/walk/interval.glsl?raw';
import ray from '../../../shaders/chunks/walk/ray.glsl?raw';
import otherSides from '../../../shaders/programs/other-sides.frag.glsl?raw';
import shapeEdges from '../../../shaders/programs/shape-edges.frag.glsl?raw';
import wholePicture from '../../../shaders/programs/whole-picture.vert.glsl?raw';
import type { DeviceRectangle } from '../../optics/cells/bound-seen-cells.ts';
import { composeStage } from '../device/compose-stage.ts';
import type { ShaderTexts } from '../device/compose-stage.ts';
import { isWebGl2 } from '../device/device.ts';
import type { Gl } from '../device/device.ts';
import { bytesAttachment, DrawTarget } from '../device/draw-target.ts';
import { joinInputs } from '../device/inputs.ts';
import type { ProgramInputs } from '../device/inputs.ts';
import { PassDrawing } from '../passes/pass-drawing.ts';
import type { Pass, Size } from '../passes/pass-drawing.ts';
import { compileProgram } from '../device/program.ts';
import type { ShapeDepths } from '../ray/ray-module.ts';
import { wholePass } from './volume-pictures.ts';

/** The two programs for edges: one writes the depth of their other sides, one shows the picture. */
export type EdgeProgram = 'otherSides' | 'shapeEdges';

export function composeShapeEdges(webgl2: boolean, program: EdgeProgram): ShaderTexts {
  const defines = { FRAGMENT_DEPTH: webgl2 ? 'gl_FragDepth' : 'gl_FragDepthEXT' };
  const fragment = composeStage({ webgl2, stage: 'FRAGMENT_STAGE', defines }, [
    interval,
    ray,
    sceneDepth,
    edgeSplit,
    { otherSides, shapeEdges }[program],
  ]);
  return {
    vertex: composeStage({ webgl2, stage: 'VERTEX_STAGE' }, [wholePicture]),
    fragment: webgl2 ? fragment : `#extension GL_EXT_frag_depth : enable\n${fragment}`,
  };
}

/** Two ray ends are on different sides of an edge only if they are at least this far apart, in bounding diameters. */
const minJump = 1 / 200;

/** Shows pictures of the volume over shapes with smooth edges (antialiased by the canvas). */
export class ShapeEdges {
  readonly #passes: PassDrawing;
  readonly #programs = new Map<EdgeProgram, WebGLProgram>();
  /** The colours that rays gathered which end on the other sides of edges, and the depths at which these rays end. */
  readonly #others: DrawTarget;
  readonly #ends: DrawTarget;
  /** Whether both targets belong to the present picture. */
  #hasOthers = false;

  private constructor(
    readonly gl: Gl,
    depthTarget: (gl: Gl) => DrawTarget,
  ) {
    this.#passes = new PassDrawing(gl);
    this.#others = new DrawTarget(gl, [bytesAttachment(gl, 'uOtherSides')]);
    this.#ends = depthTarget(gl);
  }

  /**
   * @param depthTarget - makes the target that depths are drawn into
   * @returns null where edges are not smooth, or the device can't split them. The canvas framebuffer has to be bound
   */
  static create(gl: Gl, depthTarget: (gl: Gl) => DrawTarget): ShapeEdges | null {
    const canSplit = isWebGl2(gl) || gl.getExtension('EXT_frag_depth');
    return canSplit && gl.getParameter(gl.SAMPLES) > 1 ? new ShapeEdges(gl, depthTarget) : null;
  }

  /**
   * A pass with one more ray for each pixel that an edge passes through: this ray ends at the shape on the other side of the edge.
   * Lines and points get no such rays: the mean of the rays next to them is good enough, and a radar with rings has many lines.
   * Also draws the depths at which these rays end.
   * @param depth - inputs that give the depth of the shapes that are neither lines nor points
   */
  passes(picture: Size, depths: ShapeDepths, depth: ProgramInputs): Pass[] {
    const { gl } = this;
    const { width, height } = picture;
    const rectangle = pixelsOf(depths.solidBounds!, picture);
    this.#others.resize(width, height);
    this.#ends.resize(width, height);
    this.#hasOthers = true;
    this.#passes.alone(() => {
      gl.bindFramebuffer(gl.FRAMEBUFFER, this.#ends.framebuffer);
      gl.viewport(0, 0, width, height);
      gl.enable(gl.DEPTH_TEST);
      gl.depthMask(true);
      gl.depthFunc(gl.ALWAYS);
      this.#passes.drawCorners(
        this.#program('otherSides'),
        joinInputs(depth, { uniforms: { uMinJump: minJump }, units: [] }),
      );
      gl.depthFunc(gl.LEQUAL);
    });
    const over: Pass['over'] = {
      begin: () => {
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.#others.framebuffer);
        gl.clearColor(0, 0, 0, 0);
        gl.clear(gl.COLOR_BUFFER_BIT);
      },
      draw: ({ program, inputs, firstRow, rows }) => {
        const [left, bottom, right, top] = rectangle;
        const [from, to] = [Math.max(firstRow, bottom), Math.min(firstRow + rows, top)];
        if (from >= to) return;
        gl.scissor(left, from, right - left, to - from);
        this.#passes.drawCorners(program, inputs);
      },
    };
    return [{ ...wholePass(picture, this.#others), depths: { ...depths, all: this.#ends, solid: this.#ends }, over }];
  }

  /** Call it when the next picture has no rays for the other sides of edges. */
  forget(): void {
    this.#hasOthers = false;
  }

  /**
   * Show a picture over the content of the framebuffer, whose depth buffer holds the shapes.
   * @param size - of the framebuffer
   * @param depth - inputs that give the depth of the shapes in it
   */
  show(picture: DrawTarget, { width, height }: Size, depth: ProgramInputs): void {
    const { gl } = this;
    const others = this.#hasOthers ? this.#others : picture;
    const split = this.#hasOthers ? this.#ends.units[1] : picture.units[0];
    this.#passes.alone(() => {
      gl.enable(gl.BLEND);
      gl.blendEquation(gl.FUNC_ADD);
      gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
      gl.enable(gl.DEPTH_TEST);
      gl.depthMask(false);
      for (const side of [0, 1]) {
        gl.depthFunc(side ? gl.LESS : gl.GEQUAL);
        const uniforms = {
          uGatheredPixel: [1 / width, 1 / height],
          uMinJump: minJump,
          uFarSide: side,
          uHasOtherSides: Number(this.#hasOthers),
        };
        this.#passes.drawCorners(
          this.#program('shapeEdges'),
          joinInputs(depth, {
            uniforms,
            units: [
              ...picture.units,
              { ...others.units[0], samplerName: 'uOtherSides' },
              { ...split, samplerName: 'uSplitPixels' },
            ],
          }),
        );
      }
      gl.depthMask(true); // Without this, the next frame's depth would not be cleared.
    });
  }

  #program(name: EdgeProgram): WebGLProgram {
    let program = this.#programs.get(name);
    if (!program)
      this.#programs.set(name, (program = compileProgram(this.gl, composeShapeEdges(isWebGl2(this.gl), name))));
    return program;
  }

  dispose(): void {
    this.#passes.dispose();
    for (const program of this.#programs.values()) this.gl.deleteProgram(program);
    this.#others.dispose();
    this.#ends.dispose();
  }
}

/** The pixels of a part of a picture: left, bottom, right and top. */
function pixelsOf(
  [left, bottom, right, top]: DeviceRectangle,
  { width, height }: Size,
): readonly [number, number, number, number] {
  const pixel = (device: number, pixels: number): number => ((device + 1) / 2) * pixels;
  const [x, y] = [Math.max(0, Math.floor(pixel(left, width))), Math.max(0, Math.floor(pixel(bottom, height)))];
  return [
    x,
    y,
    Math.max(x, Math.min(width, Math.ceil(pixel(right, width)))),
    Math.max(y, Math.min(height, Math.ceil(pixel(top, height)))),
  ];
}
