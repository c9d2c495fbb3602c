import sceneDepth from '../../shaders/chunks/scene-depth.glsl?raw';
import interval from '../../shaders/chunks/interval.glsl?raw';
import ray from '../../shaders/chunks/ray.glsl?raw';
import shapeEdges from '../../shaders/shape-edges.frag.glsl?raw';
import wholePicture from '../../shaders/whole-picture.vert.glsl?raw';
import { composeStage } from './compose-stage.ts';
import type { ShaderTexts } from './compose-stage.ts';
import { isWebGl2 } from './device.ts';
import type { Gl } from './device.ts';
import type { DrawTarget } from './draw-target.ts';
import { joinInputs } from './inputs.ts';
import type { ProgramInputs } from './inputs.ts';
import { PassDrawing } from './pass-drawing.ts';
import type { Size } from './pass-drawing.ts';
import { compileProgram } from './program.ts';

export function composeShapeEdges(webgl2: boolean): ShaderTexts {
  const defines = { FRAGMENT_DEPTH: webgl2 ? 'gl_FragDepth' : 'gl_FragDepthEXT' };
  const fragment = composeStage({ webgl2, stage: 'FRAGMENT_STAGE', defines }, [interval, ray, sceneDepth, shapeEdges]);
  return {
    vertex: composeStage({ webgl2, stage: 'VERTEX_STAGE' }, [wholePicture]),
    fragment: webgl2 ? fragment : `#extension GL_EXT_frag_depth : enable\n${fragment}`,
  };
}

/** Ends of rays that are nearer to each other than this, in bounding diameters, are on no two sides of an edge. */
const leastJump = 1 / 200;

/** Shows pictures of the volume over shapes whose edges are smooth. */
export class ShapeEdges {
  readonly #passes: PassDrawing;
  readonly #program: WebGLProgram;

  private constructor(readonly gl: Gl) {
    this.#passes = new PassDrawing(gl);
    this.#program = compileProgram(gl, composeShapeEdges(isWebGl2(gl)));
  }

  /** @returns null where edges are not smooth, or the device can't. The canvas has to be bound */
  static create(gl: Gl): ShapeEdges | null {
    const canSplit = isWebGl2(gl) || gl.getExtension('EXT_frag_depth');
    return canSplit && gl.getParameter(gl.SAMPLES) > 1 ? new ShapeEdges(gl) : null;
  }

  /**
   * Show a picture over what is in the framebuffer, whose depth is that of the shapes.
   * @param size - of that
   * @param depth - what tells the depth of the shapes in it
   */
  show(picture: DrawTarget, { width, height }: Size, depth: ProgramInputs): void {
    const { gl } = this;
    this.#passes.alone(() => {
      gl.enable(gl.BLEND);
      gl.blendEquation(gl.FUNC_ADD);
      gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
      gl.enable(gl.DEPTH_TEST);
      gl.depthMask(false);
      for (const side of [0, 1]) {
        gl.depthFunc(side ? gl.LESS : gl.GEQUAL);
        const uniforms = { uGatheredPixel: [1 / width, 1 / height], uLeastJump: leastJump, uFarSide: side };
        this.#passes.drawCorners(this.#program, joinInputs(depth, { uniforms, units: picture.units }));
      }
      gl.depthMask(true); // Else the next frame would not be cleared.
    });
  }

  dispose(): void {
    this.#passes.dispose();
    this.gl.deleteProgram(this.#program);
  }
}
