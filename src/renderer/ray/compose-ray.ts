import betweenPixels from '../../../shaders/chunks/depth/between-pixels.glsl?raw';
import cells from '../../../shaders/chunks/walk/cells.glsl?raw';
import interval from '../../../shaders/chunks/walk/interval.glsl?raw';
import ray from '../../../shaders/chunks/walk/ray.glsl?raw';
import segment from '../../../shaders/chunks/walk/segment.glsl?raw';
import values from '../../../shaders/chunks/field/values.glsl?raw';
import walk from '../../../shaders/chunks/walk/walk.glsl?raw';
import walkSteps from '../../../shaders/chunks/walk/walk-steps.glsl?raw';
import rayCaster from '../../../shaders/programs/ray-caster.frag.glsl?raw';
import raysOfPixels from '../../../shaders/programs/rays.vert.glsl?raw';
import type { StepCode } from '../../optics/cells/substeps.ts';
import { maxSubsteps } from '../../optics/transfer/substep-limits.ts';
import { composeStage } from '../device/compose-stage.ts';
import type { Defines, ShaderTexts } from '../device/compose-stage.ts';
import { fieldChain, intervalChain, sampleStruct, shadeChain } from './generate-chains.ts';
import type { RayText, StageName } from './ray-module.ts';
import { readUniformsOnce } from './read-uniforms-once.ts';
import { substepPart } from './substep-provider.ts';

/**
 * The maximum steps of a ray: it ends there even if it has not left the volume. GLSL ES 1.00 needs a constant for the loop. Rays of
 * ten thousand steps and more must be possible; the element refuses larger values of `steps`.
 */
export const maxSteps = 16384;

/**
 * The number of samplers that every device guarantees to one program. Source: WebGL 1, MAX_COMBINED_TEXTURE_IMAGE_UNITS; WebGL 2,
 * MAX_TEXTURE_IMAGE_UNITS
 */
export function maxSamplers(webgl2: boolean): number {
  return webgl2 ? 16 : 8;
}

/** A program that casts rays. */
export interface RayProgram {
  /** True: GLSL ES 3.00; false: GLSL ES 1.00. */
  readonly webgl2: boolean;
  /** Some quads of pixels are interpolated, and get no rays. */
  readonly adaptive: boolean;
  /** The samples at a step's ends may cut it into substeps; else only the cells' needs do, which costs less. */
  readonly substeps: boolean;
  /** Where there are no substeps: for steps that are longer than a voxel. */
  readonly long?: StepCode;
  readonly modules: readonly RayText[];
}

/** A key that is different for different programs. */
export function programKey({ webgl2, adaptive, substeps, long, modules }: RayProgram): string {
  const keys = modules.map(({ name, defines }) => [name, defines]);
  return JSON.stringify([webgl2, adaptive, substeps ? 'substeps' : long?.name, keys]);
}

/**
 * Compose the shader texts of a ray's modules.
 * @throws {TypeError} if the modules make no ray: a stage lacks its module, or they need more samplers than a device has
 */
export function composeRay(program: RayProgram): ShaderTexts {
  checkModules(program);
  const { webgl2, substeps, long, modules } = program;
  const cutting: (Pick<StepCode, 'count' | 'defines'> & { readonly walk?: string }) | undefined = substeps
    ? substepPart()
    : long;
  const defines = Object.assign(
    { MAX_SAMPLES: maxSteps * maxSubsteps },
    cutting?.defines,
    ...modules.map((module) => module.defines),
  ) as Defines;
  const of = (stage: StageName): RayText[] => modules.filter((module) => module.stage === stage);
  const chunksOf = (stage: StageName): readonly string[] => of(stage).flatMap(({ chunks }) => chunks);
  const chunks = new Set([
    ...fieldChunks(modules),
    interval,
    ray,
    segment,
    cutting?.count ?? '',
    ...chunksOf('classify'),
    ...chunksOf('shade'),
    shadeChain(of('shade')),
    // Interval chunks come after the classify chunks, because a slice at a ray's end may have to be classified too.
    ...chunksOf('interval'),
    intervalChain(of('interval')),
    walk,
    cells,
    ...chunksOf('gather'),
    of('gather')[0].walk ?? cutting?.walk ?? walkSteps,
  ]);
  return {
    vertex: composeRays(program),
    fragment: composeStage({ webgl2, stage: 'FRAGMENT_STAGE', defines }, readUniformsOnce([...chunks], rayCaster)),
  };
}

/** Compose the vertex shader of a program that casts rays. */
export function composeRays({ webgl2, adaptive, modules }: Omit<RayProgram, 'substeps'>): string {
  const texts = adaptive ? modules.flatMap((module) => module.between ?? []) : [];
  const needs = texts.map(({ needsRays }) => needsRays).join(' || ');
  const defines = Object.assign(
    { ADAPTIVE: Number(adaptive) },
    needs && { NEEDS_RAYS: needs },
    ...texts.map((text) => text.defines),
  ) as Defines;
  const chunks = new Set(texts.flatMap((text) => text.chunks));
  return composeStage({ webgl2, stage: 'VERTEX_STAGE', defines }, [
    ...(adaptive ? [betweenPixels] : []),
    ...chunks,
    raysOfPixels,
  ]);
}

/** The chunks up to the function `sampleField`, which is included. */
export function fieldChunks(modules: readonly RayText[]): string[] {
  const fields = modules.filter(({ stage }) => stage === 'field');
  return [values, sampleStruct(fields), ...fields.flatMap(({ chunks }) => chunks), fieldChain(fields)];
}

/** The samplers of a program, including those of its vertex shader. If `substeps` is absent, it counts as true. */
export function listSamplers({
  adaptive,
  substeps = true,
  modules,
}: Pick<RayProgram, 'adaptive' | 'modules'> & Partial<RayProgram>): string[] {
  const between = adaptive ? ['uHalfPicture', ...modules.flatMap((module) => module.between?.samplers ?? [])] : [];
  return [
    ...new Set([...modules.flatMap(({ samplers }) => samplers), ...(substeps ? ['uSubstepTable'] : []), ...between]),
  ];
}

function checkModules(program: RayProgram): void {
  for (const stage of ['field', 'classify', 'gather'] as const) {
    const count = program.modules.filter((module) => module.stage === stage && !module.members).length;
    if (count !== 1) throw new TypeError(`the stage ${stage} got ${count} modules; expected 1`);
  }
  const samplers = listSamplers(program);
  const max = maxSamplers(program.webgl2);
  if (samplers.length > max) {
    throw new TypeError(
      `the program got ${samplers.length} samplers (${samplers.join(', ')}); expected ${max} at most`,
    );
  }
}
