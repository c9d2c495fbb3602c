import { evaluate } from '../../src/optics/transfer/transfer-function.ts';
import type { TransferFunction } from '../../src/optics/transfer/transfer-function.ts';
import type { RayStyle } from '../../src/optics/rays/ray-style.ts';
import type { RaySetup } from '../../src/optics/rays/rays.ts';
import { stepLengthOf } from '../../src/quality/steps.ts';
import { programKey } from '../../src/renderer/ray/compose-ray.ts';
import type { RayProgram } from '../../src/renderer/ray/compose-ray.ts';
import { cuttingSteps } from '../../src/renderer/ray/substep-part.ts';
import { provideSubsteps } from '../../src/renderer/ray/substep-provider.ts';
import { composeStudyShader } from '../../src/renderer/study.ts';
import type { StudyProgram } from '../../src/renderer/study.ts';
import { maxSubsteps } from '../../src/optics/rays/segment.ts';
import { allSubsteps } from '../../src/optics/cells/substeps.ts';
import type { Substeps } from '../../src/optics/cells/substeps.ts';
import type { Volume } from '../../src/volume/volume.ts';
import type { Device } from '../../src/renderer/device/device.ts';
import { describe } from '../../src/renderer/probes/probe-device.ts';
import { probeTwoByteFilter } from '../../src/renderer/probes/probe-filter.ts';
import type { DrawTarget } from '../../src/renderer/device/draw-target.ts';
import { PassDrawing } from '../../src/renderer/passes/pass-drawing.ts';
import type { Caster, Pass } from '../../src/renderer/passes/pass-drawing.ts';
import { startReading } from '../../src/renderer/device/read-picture.ts';
import { createProbeTarget } from '../../src/renderer/probes/probe-target.ts';
import { compileProgram } from '../../src/renderer/device/program.ts';
import { joinInputs } from '../../src/renderer/device/inputs.ts';
import type { ProgramInputs } from '../../src/renderer/device/inputs.ts';
import { AdaptivePicture } from '../../src/renderer/pictures/adaptive-picture.ts';
import { wholePass } from '../../src/renderer/pictures/volume-pictures.ts';
import { VolumeLayer } from '../../src/renderer/layers/volume-layer.ts';
import { textureUnit } from '../../src/renderer/device/texture-unit.ts';
import type { TextureUnit } from '../../src/renderer/device/texture-unit.ts';

provideSubsteps(cuttingSteps);

/** What one picture of the study shows. */
export interface StudyPicture {
  readonly volume: Volume;
  readonly rays: RaySetup;
  readonly transferFunction: TransferFunction;
  /** World length. */
  readonly referenceLength: number;
  readonly method: StudyProgram;
  /** The fetching loop: what the program `shown` draws at this size. */
  readonly shown?: Float32Array;
  /** On the longest ray; for the paper's method on every ray. */
  readonly steps: number;
  /** Ours: maximum number of substeps; 1 for a limit, whose steps are fine enough. As shipped if absent. */
  readonly maxSubsteps?: number;
  /** Ours: how steps are cut, in place of `maxSubsteps`. */
  readonly cut?: Substeps;
  /** Ours: whether rays cross empty space without looking; as shipped where absent. */
  readonly skipping?: boolean;
  /** Ours: the largest curvature where pixels get no rays of their own, 1/255; all get one if absent or 0. */
  readonly maxCurvature?: number;
  /** The paper's method alone knows these. */
  readonly paper?: PaperFactors;
}

/** The paper's two global factors. */
export interface PaperFactors {
  /** O_f: what the opacities of a ray add up to where all samples have the largest. */
  readonly opacity: number;
  /** L_f: multiplies the colour. */
  readonly light: number;
}

/** A draw call that takes much longer may be taken for a hung one by the browser. */
const longestCallMs = 500;

/** Steps across the picture that a first call is given; later ones follow from how long it took. */
const firstCallSteps = 2_000_000;

/** Draws pictures of the study into floats, one after the other, and reads them back. */
export class StudyGl {
  readonly device: Device;
  readonly renderer: string;
  /** Bits of a channel of the pictures: 32, or 16 where the device draws no floats. */
  readonly channelBits: 32 | 16;
  readonly #gl: WebGL2RenderingContext;
  readonly #programs = new Map<string, WebGLProgram>();
  readonly #volumes = new Map<Volume, VolumeLayer>();
  readonly #colors = new Map<TransferFunction, TextureUnit>();
  readonly #adaptive: AdaptivePicture;
  #shown: { of: Float32Array; unit: TextureUnit } | null = null;
  readonly #passes: PassDrawing;
  readonly #target: DrawTarget;
  #stepsPerMs = firstCallSteps / longestCallMs;

  constructor() {
    const gl = document.createElement('canvas').getContext('webgl2');
    if (!gl) throw new Error('The study needs WebGL 2, which this browser does not offer here.');
    this.#gl = gl;
    this.device = { ...describe(gl), twoByteLinear: probeTwoByteFilter(gl) };
    const info = gl.getExtension('WEBGL_debug_renderer_info');
    this.renderer = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
    const target = createProbeTarget(gl);
    if (!target)
      throw new Error('The study needs pictures in floats (EXT_color_buffer_float), which this device does not draw.');
    this.channelBits = target.attachments[0].internal === gl.RGBA32F ? 32 : 16;
    this.#target = target;
    this.#adaptive = new AdaptivePicture(gl);
    this.#passes = new PassDrawing(gl);
  }

  /**
   * Draw a picture, in several calls where it takes long, with a rest for the page between them.
   * @param size - pixels along each side
   * @returns RGBA, premultiplied, 0..1, bottom row first
   */
  async draw(picture: StudyPicture, size: number, signal: AbortSignal): Promise<Float32Array> {
    await this.prepare(picture);
    const caster = this.#caster(picture, size);
    const passes = this.#passesOf(picture, size);
    for (const pass of passes.slice(0, -1)) this.#passes.draw(pass, caster, { width: size, height: size });
    const last = passes[passes.length - 1];
    const max = Math.max(1, Math.floor((longestCallMs * this.#stepsPerMs) / (size * picture.steps)));
    for (let firstRow = 0; firstRow < size; firstRow += max) {
      signal.throwIfAborted();
      const rows = Math.min(max, size - firstRow);
      const began = performance.now();
      this.#passes.draw(last, caster, { width: size, height: size }, { firstRow, rows });
      this.#finish();
      const took = performance.now() - began;
      if (took > 50) this.#stepsPerMs = (rows * size * picture.steps) / took;
      if (took > 20) await rest();
    }
    signal.throwIfAborted(); // Another picture may be on its way.
    return this.#read();
  }

  /** Load what only some transfer functions need. `draw` does so by itself. @param style - stays where absent */
  prepare(
    {
      volume,
      transferFunction,
      referenceLength,
    }: Pick<StudyPicture, 'volume' | 'transferFunction' | 'referenceLength'>,
    style?: RayStyle | null,
  ): Promise<void> {
    const optics = { transferFunction, referenceLength, opacityFactor: 1, lightFactor: 1 };
    return this.#layer(volume).setAppearance(style === undefined ? { optics } : { optics, style });
  }

  /**
   * Milliseconds until the GPU has drawn a whole picture at once.
   * @param repeat - pictures to draw, for times too short for the clock
   */
  time(picture: StudyPicture, size: number, repeat = 1): number {
    const caster = this.#caster(picture, size);
    const passes = this.#passesOf(picture, size);
    const whole = { width: size, height: size };
    this.#passes.draw(passes[0], caster, whole, { firstRow: 0, rows: 1 });
    this.#finish(); // Waits for what went before.
    const began = performance.now();
    for (let i = 0; i < repeat; i++) for (const pass of passes) this.#passes.draw(pass, caster, whole);
    this.#finish();
    return (performance.now() - began) / repeat;
  }

  /** Forget a volume, on the GPU too. */
  forget(volume: Volume): void {
    this.#volumes.get(volume)?.dispose();
    this.#volumes.delete(volume);
  }

  dispose(): void {
    this.#gl.getExtension('WEBGL_lose_context')?.loseContext();
  }

  #caster(picture: StudyPicture, size: number): Caster {
    const { method, rays, volume } = picture;
    const layer = this.#layer(volume);
    const inputs = this.#inputs(picture, layer, size); // First, as the program depends on what they are of.
    const program = layer.program(false);
    return {
      program: this.#program(method, { ...program, adaptive: program.adaptive && method === 'shipped' }),
      inputs,
      rays,
      stepLength: stepLengthOf(volume.grid, picture.steps),
      maxCurvature: picture.maxCurvature ?? 0,
    };
  }

  /** What a picture is drawn from, one after the other. */
  #passesOf({ maxCurvature = 0 }: StudyPicture, size: number): Pass[] {
    const whole = { width: size, height: size };
    this.#target.resize(size, size);
    return maxCurvature > 0 ? this.#adaptive.passes(whole, this.#target) : [wholePass(whole, this.#target)];
  }

  #inputs(picture: StudyPicture, layer: VolumeLayer, size: number): ProgramInputs {
    const { method, rays, transferFunction, referenceLength, steps, paper, shown } = picture;
    void layer.setAppearance({ optics: { transferFunction, referenceLength, opacityFactor: 1, lightFactor: 1 } });
    if (layer.optics?.transferFunction !== transferFunction)
      throw new TypeError('prepare() has to be awaited before a picture is drawn');
    layer.skipping = picture.skipping ?? true;
    layer.plan = {
      ...layer.plan,
      substeps: picture.cut ?? { ...allSubsteps, max: picture.maxSubsteps ?? maxSubsteps },
    };
    const shipped = layer.inputs(rays, null);
    if (method === 'printed') {
      const uniforms = { uSteps: steps, uOpacityFactor: paper?.opacity ?? 1, uLightFactor: paper?.light ?? 1 };
      return joinInputs({ uniforms, units: [this.#colorUnit(picture)] }, shipped);
    }
    return joinInputs(shipped, { uniforms: {}, units: shown ? [this.#shownUnit(shown, size)] : [] });
  }

  /** Reading a pixel waits for all that was drawn; `finish` need not. */
  #finish(): void {
    const gl = this.#gl;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.#target.framebuffer);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, new Float32Array(4));
  }

  #read(): Float32Array {
    const gl = this.#gl;
    const { framebuffer, width, height } = this.#target;
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    const pixels = startReading(gl, { width, height }, new Float32Array(4 * width * height))();
    const error = gl.getError();
    if (error) throw new Error(gl.isContextLost() ? 'The graphics driver stopped.' : `WebGL error ${error}`);
    return pixels;
  }

  #program(method: StudyProgram, shipped: RayProgram): WebGLProgram {
    const key = `${method} ${programKey(shipped)}`;
    let program = this.#programs.get(key);
    if (!program) this.#programs.set(key, (program = compileProgram(this.#gl, composeStudyShader(method, shipped))));
    return program;
  }

  #layer(volume: Volume): VolumeLayer {
    let layer = this.#volumes.get(volume);
    if (!layer) {
      this.#volumes.set(volume, (layer = new VolumeLayer(this.#gl, this.device)));
      layer.set(volume);
    }
    return layer;
  }

  #shownUnit(shown: Float32Array, size: number): TextureUnit {
    const gl = this.#gl;
    if (this.#shown?.of !== shown) {
      if (this.#shown) gl.deleteTexture(this.#shown.unit.texture);
      const texture = gl.createTexture();
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, size, size, 0, gl.RGBA, gl.FLOAT, shown);
      this.#shown = {
        of: shown,
        unit: textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter: gl.NEAREST, samplerName: 'uShown' }),
      };
    }
    return this.#shown.unit;
  }

  #colorUnit({ transferFunction, volume }: StudyPicture): TextureUnit {
    let unit = this.#colors.get(transferFunction);
    if (!unit) this.#colors.set(transferFunction, (unit = uploadColors(this.#gl, transferFunction, volume)));
    return unit;
  }
}

/**
 * The paper's transfer function: 256 texels over all 8-bit values, straight colour and opacity with 8 bits. The largest
 * opacity is brought to 1, so that no bit is lost; its O_f makes up for that.
 */
function uploadColors(gl: WebGL2RenderingContext, transferFunction: TransferFunction, volume: Volume): TextureUnit {
  const max = Math.max(...transferFunction.map((stop) => stop.opacity)) || 1;
  // A trace of opacity, so that invisible stops have a colour that can be told.
  const visible = transferFunction.map((stop) => ({ ...stop, opacity: Math.max(stop.opacity, 1e-6) }));
  const texels = new Uint8Array(256 * 4);
  for (let i = 0; i < 256; i++) {
    const value = volume.slope * ((i + 0.5) / 256) * 255 + volume.intercept;
    const [red, green, blue, alpha] = evaluate(visible, value);
    const texel = [red / alpha, green / alpha, blue / alpha, evaluate(transferFunction, value)[3] / max];
    texels.set(
      texel.map((channel) => Math.round(channel * 255)),
      i * 4,
    );
  }
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, texels);
  return textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter: gl.LINEAR, samplerName: 'uTransferFunction' });
}

/** Let the page paint and hear. */
function rest(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve));
}
