import translucent from '../../shaders/translucent.frag.glsl?raw';
import wholePicture from '../../shaders/whole-picture.vert.glsl?raw';
import { composeStage } from './compose-stage.ts';
import type { ShaderTexts } from './compose-stage.ts';
import { isWebGl2 } from './device.ts';
import type { Gl } from './device.ts';
import { PassDrawing } from './pass-drawing.ts';
import type { Size } from './pass-drawing.ts';
import { compileProgram } from './program.ts';
import type { TextureUnit } from './texture-unit.ts';

export function composeTranslucent(webgl2: boolean): ShaderTexts {
  return {
    vertex: composeStage({ webgl2, stage: 'VERTEX_STAGE' }, [wholePicture]),
    fragment: composeStage({ webgl2, stage: 'FRAGMENT_STAGE' }, [translucent]),
  };
}

/** What a translucent shape is mixed from. */
export interface TranslucentParts {
  /** The volume's part before it. */
  readonly before: TextureUnit;
  readonly color: TextureUnit;
  readonly depth: TextureUnit;
  /** Depth of the opaque shapes. */
  readonly opaque: TextureUnit;
}

/** Mixes translucent shapes into what is in the framebuffer. */
export class TranslucentMixing {
  readonly #passes: PassDrawing;
  readonly #program: WebGLProgram;

  constructor(readonly gl: Gl) {
    this.#passes = new PassDrawing(gl);
    this.#program = compileProgram(gl, composeTranslucent(isWebGl2(gl)));
  }

  /** @param size - of that */
  draw({ before, color, depth, opaque }: TranslucentParts, { width, height }: Size): void {
    const { gl } = this;
    this.#passes.alone(() => {
      gl.enable(gl.BLEND);
      gl.blendEquation(gl.FUNC_ADD);
      gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
      this.#passes.drawCorners(this.#program, {
        uniforms: { uGatheredPixel: [1 / width, 1 / height] },
        units: [before, { ...color, samplerName: 'uShapeColor' }, { ...depth, samplerName: 'uShapeDepth' }, opaque],
      });
    });
  }

  dispose(): void {
    this.#passes.dispose();
    this.gl.deleteProgram(this.#program);
  }
}
