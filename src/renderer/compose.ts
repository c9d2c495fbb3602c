import betweenPixels from '../../shaders/chunks/between-pixels.glsl?raw';
import box from '../../shaders/chunks/box.glsl?raw';
import decode from '../../shaders/chunks/decode.glsl?raw';
import emptiness from '../../shaders/chunks/empty-space.glsl?raw';
import interpolateVoxels from '../../shaders/chunks/interpolate.glsl?raw';
import language100 from '../../shaders/chunks/language-100.glsl?raw';
import language300 from '../../shaders/chunks/language-300.glsl?raw';
import region from '../../shaders/chunks/region.glsl?raw';
import sampleVolume from '../../shaders/chunks/sample-volume.glsl?raw';
import ray from '../../shaders/chunks/ray.glsl?raw';
import surfaces from '../../shaders/chunks/surfaces.glsl?raw';
import transferFunction from '../../shaders/chunks/transfer-function.glsl?raw';
import volume3d from '../../shaders/chunks/volume-3d.glsl?raw';
import volumeMosaic from '../../shaders/chunks/volume-mosaic.glsl?raw';
import betweenPixelsStage from '../../shaders/between-pixels.frag.glsl?raw';
import gathered from '../../shaders/gathered.frag.glsl?raw';
import rayCaster from '../../shaders/ray-caster.frag.glsl?raw';
import raysOfPixels from '../../shaders/rays.vert.glsl?raw';
import wholePicture from '../../shaders/whole-picture.vert.glsl?raw';
import { substepTableDomain, substepTableSize } from '../optics/substep-table.ts';
import { maxSubsteps, substepsPerRoot } from '../optics/segment.ts';
import { coneSearch, minSliceOpacity, maxSlices } from '../radar/slices.ts';
import { noFeatures } from './features.ts';
import type { ShaderFeatures } from './features.ts';

/** The texts of one shader program. */
export interface ShaderTexts {
  readonly vertex: string;
  readonly fragment: string;
}

/**
 * Steps after which a ray ends whatever is left of it; GLSL ES 1.00 wants a constant. Ten thousand steps and more must
 * fit; the element refuses larger values of `steps`.
 */
export const maxSteps = 16384;

const cache = new Map<string, ShaderTexts>();

/** A name that tells combinations of features apart. */
export function featureKey(features: ShaderFeatures): string {
  return Object.entries(features)
    .map(([name, on]) => `${name}=${on ? 1 : 0}`)
    .join(' ');
}

/**
 * The shader texts that do what the features say, and nothing else.
 * @param polarSampling - of a polar volume: the text of radar/gpu/polar-shader.ts, which other pages do not load
 */
export function composeShader(features: ShaderFeatures, polarSampling?: string): ShaderTexts {
  const key = featureKey(features);
  let texts = cache.get(key);
  if (!texts) {
    texts = {
      vertex: composeRays(features),
      fragment: composeStage(features, 'FRAGMENT_STAGE', [...samplingChunks(features, polarSampling), ...rayChunks(features)]),
    };
    cache.set(key, texts);
  }
  return texts;
}

/** The vertices of rays. */
export function composeRays(features: ShaderFeatures): string {
  return composeStage(features, 'VERTEX_STAGE', [...(features.adaptive ? [betweenPixels] : []), raysOfPixels]);
}

/** What is done with pictures of the volume, whatever it is: to interpolate pixels, and to show what has been drawn before. */
export type PictureProgram = 'between' | 'gathered';

/** The shader texts that draw a picture from another one. */
export function composePictureShader(program: PictureProgram, webgl2: boolean): ShaderTexts {
  const features = noFeatures(webgl2);
  const chunks = { between: [betweenPixels, betweenPixelsStage], gathered: [gathered] }[program];
  return {
    vertex: composeStage(features, 'VERTEX_STAGE', [wholePicture]),
    fragment: composeStage(features, 'FRAGMENT_STAGE', chunks),
  };
}

/** The chunks up to and including `sampleVolume` and `countSubsteps`: what the tests of single chunks run. */
export function samplingChunks(features: ShaderFeatures, polarSampling = ''): string[] {
  if (features.polar) return ['uniform vec3 uDimensions;\n', decode, transferFunction, polarSampling];
  return [
    'uniform vec3 uDimensions;\n',
    decode,
    features.texture3d ? volume3d : volumeMosaic,
    ...(features.filterInShader ? [interpolateVoxels] : []),
    sampleVolume,
    transferFunction,
  ];
}

function rayChunks(features: ShaderFeatures): string[] {
  return [ray, box, region, emptiness, ...(features.surfaces ? [surfaces] : []), rayCaster];
}

/** Version, defines, language and chunks of one stage. Exported for the tests of single chunks. */
export function composeStage(
  features: ShaderFeatures,
  stage: 'VERTEX_STAGE' | 'FRAGMENT_STAGE',
  chunks: readonly string[],
): string {
  const defines: [string, number | string][] = [
    [stage, 1],
    ['MAX_SAMPLES', maxSteps * maxSubsteps],
    ['WEBGL2', Number(features.webgl2)],
    ['TWO_BYTES', Number(features.twoBytes)],
    ['POLAR', Number(features.polar)],
    ['RADIAL_ELEVATIONS', Number(features.radialElevations)],
    ['NO_DATA', Number(features.noData)],
    ['FILTER_IN_SHADER', Number(features.filterInShader)],
    ['TABLE_IN_SHADER', Number(features.tableInShader)],
    ['SURFACES', Number(features.surfaces)],
    ['SLICES', Number(features.slices)],
    ['ADAPTIVE', Number(features.adaptive)],
    ['MAX_SLICES', maxSlices],
    ['CONE_INTERVALS', coneSearch.intervals],
    ['CONE_HALVINGS', coneSearch.halvings],
    ['MIN_SLICE_OPACITY', minSliceOpacity.toExponential(1)],
    ['SUBSTEPS_PER_ROOT', substepsPerRoot.toFixed(1)],
    ['SUBSTEP_TABLE_COLUMNS', substepTableSize.columns.toFixed(1)],
    ['SUBSTEP_TABLE_ROWS', substepTableSize.rows.toFixed(1)],
    ['SUBSTEP_TABLE_FROM', substepTableDomain.from.toFixed(3)],
    ['SUBSTEP_TABLE_WIDTH', (substepTableDomain.to - substepTableDomain.from).toFixed(3)],
  ];
  return [
    features.webgl2 ? '#version 300 es\n' : '',
    defines.map(([name, value]) => `#define ${name} ${value}\n`).join(''),
    features.webgl2 ? language300 : language100,
    ...chunks,
  ].join('\n').trimStart();
}
