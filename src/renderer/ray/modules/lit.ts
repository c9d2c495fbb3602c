import gradientTaps from '../../../../shaders/chunks/field/gradient-taps.glsl?raw';
import lights from '../../../../shaders/chunks/shade/lights.glsl?raw';
import lit from '../../../../shaders/chunks/shade/lit.glsl?raw';
import litBegin from '../../../../shaders/chunks/shade/lit-begin.glsl?raw';
import litCuts from '../../../../shaders/chunks/shade/lit-cuts.glsl?raw';
import litSample from '../../../../shaders/chunks/shade/lit-sample.glsl?raw';
import type { LitScene } from '../../../optics/rays/lit.ts';
import { domainOf } from '../../../optics/transfer/emission.ts';
import { flatChange } from '../../../optics/rays/gradient.ts';
import {
  fogFlat,
  fogMaterial,
  headlightAlone,
  plainMaterial,
  softFacing,
  softSpecular,
} from '../../../optics/transfer/lights.ts';
import type { LitMaterial, SceneLights } from '../../../optics/transfer/lights.ts';
import { mapShares } from '../../../optics/transfer/share-map.ts';
import { unitToWorld } from '../../../volume/grid.ts';
import type { Matrix4 } from '../../../volume/matrix.ts';
import type { Uniforms } from '../../device/inputs.ts';
import type { RayFrame, RayModule, RayText, RayTwin, TwinFrame } from '../ray-module.ts';
import { shadingTwins } from './field-taps.ts';
import type { FieldTaps } from './field-taps.ts';
import { cutUniforms } from './lit-cuts.ts';
import type { CutsOfRays } from './lit-cuts.ts';
import { lightUniforms } from './lit-lights.ts';

/** Segments that are left unlit change a picture by at most this: a quarter of 1/255. */
const minLit = 1 / 1024;

/** The options of the module's text. */
export interface LitOptions {
  readonly taps: FieldTaps;
  /** Whether there are lights in addition to the light at the eye. */
  readonly lights: boolean;
  /** Whether a region, planes or a box cut the volume, in addition to its own bounds. */
  readonly cuts: boolean;
}

/** The parts of a text that shades places: the chunks up to `shadeSample`, and their options. */
export function shadingText({ taps, ...options }: LitOptions): Pick<RayText, 'defines' | 'chunks'> {
  return {
    defines: {
      LIT_LIGHTS: Number(options.lights),
      LIT_CUTS: Number(options.cuts),
      MIN_LIT: minLit.toExponential(),
      ...(options.lights && { SOFT_FACING: softFacing.toFixed(2), SOFT_SPECULAR: softSpecular.toFixed(2) }),
    },
    chunks: [
      litBegin,
      ...(options.lights ? [lights] : []),
      ...(options.cuts ? [litCuts] : []),
      taps.chunk,
      gradientTaps,
      litSample,
    ],
  };
}

export function litText(options: LitOptions): RayText {
  const { defines, chunks } = shadingText(options);
  return { name: 'lit', stage: 'shade', defines, chunks: [...chunks, lit], samplers: [] };
}

/** The lights on a volume, and the cuts of it. */
export interface LitSurroundings {
  readonly lights: SceneLights;
  readonly cuts: CutsOfRays;
}

/** The twin of a module that shades. @param parts - called after the code of twins and of gradients has been loaded */
export function shadedTwin({ taps }: LitOptions, parts: RayTwin['parts']): RayTwin {
  return { load: () => Promise.all([shadingTwins.load(), taps.slopes.load()]), parts };
}

/** The scene that lights places in float64. For picks it has only the light at the eye, because only places matter to them. */
export function litScene(
  { volume, optics, rays, placesOnly }: TwinFrame,
  { taps }: LitOptions,
  { lights: shining, cuts }: LitSurroundings,
): LitScene {
  return {
    grid: volume.finer?.finest ?? volume.grid,
    gradient: taps.slopes.code(volume).gradient,
    flat: flatChange(domainOf(optics.transferFunction), volume.range),
    lights: placesOnly ? headlightAlone : shining,
    cuts: { ...cuts, unitToRegion: rays.unitToRegion },
  };
}

/** If only places matter, light is left out, and its code is not loaded. */
function litTwin(options: LitOptions, scene: LitSurroundings): RayTwin {
  const { load, parts } = shadedTwin(options, (frame) => ({
    shades: [shadingTwins.code.litShade(litScene(frame, options, scene))],
  }));
  return {
    load: (frame) => (frame.placesOnly ? Promise.resolve() : load(frame)),
    parts: (frame, before) => (frame.placesOnly ? {} : parts(frame, before)),
  };
}

/** Light on every place of a field, with its gradient as the normal of a surface. */
export function createLit(options: LitOptions, scene: LitSurroundings): RayModule<'shade'> {
  return {
    ...litText(options),
    stage: 'shade',
    sparesRays: true,
    order: 2,
    twin: litTwin(options, scene),
    inputs: (frame) => ({
      uniforms: {
        ...shadingUniforms(frame, options.taps, scene),
        uPerFlat: perFlat(frame) / fogFlat,
        uFogMaterial: toVector(fogMaterial),
      },
      units: [],
    }),
  };
}

/** The uniforms of the chunks of `shadingText`. */
export function shadingUniforms(
  { volume, rays }: RayFrame,
  taps: FieldTaps,
  { lights: shining, cuts }: LitSurroundings,
): Uniforms {
  return {
    ...taps.uniforms(volume),
    uMaterial: toVector(plainMaterial),
    uUnitToWorld: columnsOf(unitToWorld(volume.grid)),
    uNormalToWorld: columnsOf(taps.normals(volume)),
    ...lightUniforms(shining, volume),
    ...cutUniforms({ ...cuts, unitToRegion: rays.unitToRegion }, volume),
  };
}

/** A material in the order in which the shader reads it. */
function toVector({ ambient, diffuse, specular, shininess }: LitMaterial): number[] {
  return [ambient, diffuse, specular, shininess];
}

/** 1 / the change of value that counts as flat, as a share of the domain. */
export function perFlat({ volume, field, optics, domain }: RayFrame): number {
  // The data value of one share of the domain.
  const share =
    (volume.slope * field.storedScale) / mapShares({ ...volume, storedScale: field.storedScale }, domain).scale;
  return share / flatChange(domainOf(optics.transferFunction), volume.range);
}

/** The linear part of a matrix, column by column. */
function columnsOf(m: Matrix4): number[] {
  return [m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10]];
}
