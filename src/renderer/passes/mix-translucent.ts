import translucent from '../../../shaders/programs/translucent.frag.glsl?raw';
import wholePicture from '../../../shaders/programs/whole-picture.vert.glsl?raw';
import { composeStage } from '../device/compose-stage.ts';
import type { ShaderTexts } from '../device/compose-stage.ts';
import { isWebGl2 } from '../device/device.ts';
import type { Gl } from '../device/device.ts';
import { PassDrawing } from './pass-drawing.ts';
import type { Size } from './pass-drawing.ts';
import { compileProgram } from '../device/program.ts';
import type { TextureUnit } from '../device/texture-unit.ts';

export function composeTranslucent(webgl2: boolean): ShaderTexts {
  return {
    vertex: composeStage({ webgl2, stage: 'VERTEX_STAGE' }, [wholePicture]),
    fragment: composeStage({ webgl2, stage: 'FRAGMENT_STAGE' }, [translucent]),
  };
}

/** The textures from which a translucent shape is mixed into the picture. */
export interface TranslucentParts {
  /** The part of the volume that is in front of the shape. */
  readonly before: TextureUnit;
  readonly color: TextureUnit;
  readonly depth: TextureUnit;
}

/** Mixes translucent shapes into the content of the framebuffer. */
export class TranslucentMixing {
  readonly #passes: PassDrawing;
  readonly #program: WebGLProgram;

  constructor(readonly gl: Gl) {
    this.#passes = new PassDrawing(gl);
    this.#program = compileProgram(gl, composeTranslucent(isWebGl2(gl)));
  }

  /**
   * Draw where the stencil is 1, and set the stencil to 0 there.
   * @param size - of the framebuffer
   */
  draw({ before, color, depth }: TranslucentParts, { width, height }: Size): void {
    const { gl } = this;
    this.#passes.alone(() => {
      gl.enable(gl.BLEND);
      gl.blendEquation(gl.FUNC_ADD);
      gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
      gl.enable(gl.STENCIL_TEST);
      gl.stencilFunc(gl.EQUAL, 1, 1);
      gl.stencilOp(gl.KEEP, gl.KEEP, gl.ZERO);
      this.#passes.drawCorners(this.#program, {
        uniforms: { uGatheredPixel: [1 / width, 1 / height] },
        units: [before, { ...color, samplerName: 'uShapeColor' }, { ...depth, samplerName: 'uShapeDepth' }],
      });
      gl.disable(gl.STENCIL_TEST);
    });
  }

  dispose(): void {
    this.#passes.dispose();
    this.gl.deleteProgram(this.#program);
  }
}
