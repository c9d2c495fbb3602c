import styled from '../../../../shaders/chunks/shade/styled.glsl?raw';
import styledSample from '../../../../shaders/chunks/shade/styled-sample.glsl?raw';
import { maxOpacity, perGradientReach, perReferenceLength, splitMaterial } from '../../../optics/rays/styled.ts';
import { flatChange } from '../../../optics/rays/gradient.ts';
import { domainOf } from '../../../optics/transfer/emission.ts';
import {
  buildStyleTable,
  flatFactor,
  flatOf,
  hasEdges,
  maxChains,
  shadedOf,
  shareOfChange,
  styleColumns,
  styleRows,
} from '../../../optics/transfer/volume-styles.ts';
import type { StyleChain } from '../../../optics/transfer/volume-styles.ts';
import { isWebGl2 } from '../../device/device.ts';
import type { Gl } from '../../device/device.ts';
import { prepareUpload } from '../../textures/fill-texture.ts';
import type { ProgramInputs, Uniforms } from '../../device/inputs.ts';
import { textureUnit } from '../../device/texture-unit.ts';
import { hasRoomFor } from '../has-room.ts';
import type { RayFrame, RayModule, RayText, RayTwin, TwinFrame } from '../ray-module.ts';
import type { Sample } from '../../../optics/rays/ray-stages.ts';
import type { Ray } from '../../../optics/rays/rays.ts';
import type { Styled } from '../../../optics/transfer/volume-styles.ts';
import { litScene, perFlat, shadedTwin, shadingText, shadingUniforms } from './lit.ts';
import { shadingTwins } from './field-taps.ts';
import type { LitOptions, LitSurroundings } from './lit.ts';

export { withLight } from '../../../optics/transfer/volume-styles.ts';

/** The parts of a text that styles places: chunks up to `styleSample`. The text is the same for all styles; the styles are in a table. */
export function stylingText(options: LitOptions): Pick<RayText, 'defines' | 'chunks' | 'samplers'> {
  const { defines, chunks } = shadingText(options);
  return {
    defines: {
      ...defines,
      STYLE_COLUMNS: styleColumns.toFixed(1),
      STYLE_ROWS: styleRows.toFixed(1),
      STYLE_CHANGES: (2 * shareOfChange(1)).toFixed(6),
    },
    chunks: [...chunks, styledSample],
    samplers: ['uStyleTable'],
  };
}

export function styledText(options: LitOptions): RayText {
  const { defines, chunks, samplers } = stylingText(options);
  return {
    name: 'styled',
    stage: 'shade',
    defines: { ...defines, STYLE_MAX: String(maxOpacity) },
    chunks: [...chunks, styled],
    samplers,
  };
}

/** Whether a sampler is left for the table. If there is none, styles are left out. */
export const hasRoom = (others: readonly RayText[], device: { readonly webgl2: boolean }): boolean =>
  hasRoomFor(
    'this device has no room for rendering styles in addition to shapes, a transfer function of steep stops, and labels, a layer or a radar. They are left out.',
    others,
    device,
  );

const styledTwin = (chains: readonly StyleChain[], options: LitOptions, scene: LitSurroundings): RayTwin =>
  shadedTwin(options, (frame) => {
    const {
      optics: { referenceLength, opacityFactor },
      rays,
    } = frame;
    return {
      shades: [
        shadingTwins.code.styledShade({
          ...litScene(frame, options, scene),
          chains,
          referenceLength,
          opticalScale: (rays.diameter / referenceLength) * opacityFactor,
        }),
      ],
    };
  });

/** Styles in float64: a function of the place on a ray. */
export type StylesTwin = (frame: TwinFrame) => (ray: Ray) => (known: Sample) => Styled;

const stylesTwin =
  (chains: readonly StyleChain[], flatPart: number, options: LitOptions, scene: LitSurroundings): StylesTwin =>
  (frame) =>
    shadingTwins.code.stylesAt({
      ...litScene(frame, options, scene),
      chains,
      flatPart,
      referenceLength: frame.optics.referenceLength,
    });

/** X3D's rendering styles, and their table on the GPU. */
export class StyledRays {
  #table: WebGLTexture | null = null;

  /** @param flatPart - see `StyledPlaces` */
  constructor(
    readonly gl: Gl,
    readonly chains: readonly StyleChain[],
    readonly flatPart = flatOf(chains),
  ) {}

  module(options: LitOptions, scene: LitSurroundings): RayModule<'shade'> {
    return {
      ...styledText(options),
      stage: 'shade',
      sparesRays: true,
      order: this.chains.some(({ styles }) => hasEdges(styles)) ? 1 : 2,
      twin: styledTwin(this.chains, options, scene),
      inputs: (frame) => this.inputs(frame, options, scene),
    };
  }

  /** The chunks of `stylingText` in float64. */
  stylesTwin(options: LitOptions, scene: LitSurroundings): StylesTwin {
    return stylesTwin(this.chains, this.flatPart, options, scene);
  }

  /** The inputs of the chunks of `stylingText`. */
  inputs(frame: RayFrame, options: LitOptions, scene: LitSurroundings): ProgramInputs {
    return {
      uniforms: {
        ...shadingUniforms(frame, options.taps, scene),
        uPerFlat: perFlat(frame) / this.flatPart,
        ...this.#uniforms(frame),
      },
      units: [
        textureUnit(this.gl, {
          type: this.gl.TEXTURE_2D,
          texture: (this.#table ??= this.#upload()),
          filter: this.gl.NEAREST,
          samplerName: 'uStyleTable',
        }),
      ],
    };
  }

  #uniforms({ volume, optics }: RayFrame): Uniforms {
    const both = (read: (chain: StyleChain) => number): number[] =>
      Array.from({ length: maxChains }, (_, i) => (this.chains[i] ? read(this.chains[i]) : 0));
    const lit = this.chains.flatMap(({ styles }) => shadedOf(styles) ?? []);
    const { shares, colors } = splitMaterial(lit[0]?.material ?? null);
    return {
      uStyleMaterial: [shares.ambient, shares.diffuse, shares.specular, shares.shininess],
      uStyleWeights: both(({ weight }) => weight),
      uStyleFlat: both(({ styles }) => flatFactor(styles)),
      uStyleLit: both(({ styles }) => Number(shadedOf(styles) !== undefined)),
      uStylePerReach: both(({ styles }) =>
        perGradientReach(styles, flatChange(domainOf(optics.transferFunction), volume.range), optics.referenceLength),
      ),
      uStyleDiffuse: colors.diffuse,
      uStyleSpecular: colors.specular,
      uStyleEmissive: colors.emissive,
      uStyleChange: this.flatPart * perReferenceLength(volume.finer?.finest ?? volume.grid, optics.referenceLength),
    };
  }

  #upload(): WebGLTexture {
    const { gl } = this;
    const texels = new Float32Array(4 * styleColumns * styleRows * maxChains);
    this.chains.forEach(({ styles }, i) => texels.set(buildStyleTable(styles), i * 4 * styleColumns * styleRows));
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    prepareUpload(gl);
    gl.texImage2D(
      gl.TEXTURE_2D,
      0,
      isWebGl2(gl) ? gl.RGBA32F : gl.RGBA,
      styleColumns,
      styleRows * maxChains,
      0,
      gl.RGBA,
      gl.FLOAT,
      texels,
    );
    return texture;
  }

  dispose(): void {
    this.gl.deleteTexture(this.#table);
  }
}
