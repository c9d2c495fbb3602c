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
import { maxSubsteps } from '../../optics/transfer/substep-limits.ts';
import { composeStage } from '../device/compose-stage.ts';
import type { Defines, ShaderTexts } from '../device/compose-stage.ts';
import { fieldChain, intervalChain, sampleStruct, shadeChain } from './generate-chains.ts';
import type { RayText, StageName } from './ray-module.ts';
import { readUniformsOnce } from './read-uniforms-once.ts';
import { substepPart } from './substep-provider.ts';

/**
 * Steps after which a ray ends whatever is left of it; GLSL ES 1.00 wants a constant. Ten thousand steps and more must
 * fit; the element refuses larger values of `steps`.
 */
export const maxSteps = 16384;

/** Samplers of one program that are guaranteed. Source: WebGL 1, MAX_COMBINED_TEXTURE_IMAGE_UNITS; WebGL 2, MAX_TEXTURE_IMAGE_UNITS */
export function maxSamplers(webgl2: boolean): number {
  return webgl2 ? 16 : 8;
}

/** What casts rays. */
export interface RayProgram {
  /** GLSL ES 3.00, else 1.00. */
  readonly webgl2: boolean;
  /** Quads of pixels may do without rays of their own. */
  readonly adaptive: boolean;
  /** Steps may be cut by what is at their ends; else by what cells need alone, which takes less. */
  readonly substeps: boolean;
  readonly modules: readonly RayText[];
}

/** Tells programs apart. */
export function programKey({ webgl2, adaptive, substeps, modules }: RayProgram): string {
  const keys = modules.map(({ name, defines }) => [name, ...Object.entries(defines).map(([option, value]) => `${option}=${value}`)].join(' '));
  return [webgl2 ? 2 : 1, ...(adaptive ? ['adaptive'] : []), ...(substeps ? ['substeps'] : []), ...keys].join('; ');
}

/**
 * The shader texts of a ray's modules, and nothing else.
 * @throws {TypeError} for modules that are no ray: a stage without the one that it needs, or more samplers than there are
 */
export function composeRay(program: RayProgram): ShaderTexts {
  checkModules(program);
  const { webgl2, substeps, modules } = program;
  const cutting = substeps ? substepPart() : null;
  const defines = Object.assign({ MAX_SAMPLES: maxSteps * maxSubsteps }, cutting?.defines, ...modules.map((module) => module.defines)) as Defines;
  const of = (stage: StageName): RayText[] => modules.filter((module) => module.stage === stage);
  const chunksOf = (stage: StageName): readonly string[] => of(stage).flatMap(({ chunks }) => chunks);
  const chunks = new Set([
    ...fieldChunks(modules),
    interval, ray, segment, ...(cutting ? [cutting.count] : []), ...chunksOf('classify'), ...chunksOf('shade'), shadeChain(of('shade')),
    // Last, as what stands at a ray's end may have to be classified too.
    ...chunksOf('interval'), intervalChain(of('interval')),
    walk, cells, ...chunksOf('gather'), of('gather')[0].walk ?? cutting?.walk ?? walkSteps,
  ]);
  return { vertex: composeRays(program), fragment: composeStage({ webgl2, stage: 'FRAGMENT_STAGE', defines }, readUniformsOnce([...chunks], rayCaster)) };
}

/** The vertices of rays. */
export function composeRays({ webgl2, adaptive, modules }: Omit<RayProgram, 'substeps'>): string {
  const texts = adaptive ? modules.flatMap((module) => module.between ?? []) : [];
  const needs = texts.map(({ needsRays }) => needsRays).join(' || ');
  const defines = Object.assign({ ADAPTIVE: Number(adaptive) }, needs && { NEEDS_RAYS: needs }, ...texts.map((text) => text.defines)) as Defines;
  const chunks = new Set(texts.flatMap((text) => text.chunks));
  return composeStage({ webgl2, stage: 'VERTEX_STAGE', defines }, [...(adaptive ? [betweenPixels] : []), ...chunks, raysOfPixels]);
}

/** The chunks up to and including `sampleField`. */
export function fieldChunks(modules: readonly RayText[]): string[] {
  const fields = modules.filter(({ stage }) => stage === 'field');
  return [values, sampleStruct(fields), ...fields.flatMap(({ chunks }) => chunks), fieldChain(fields)];
}

/** Samplers of a program, those of its vertices among them; where it is not said, its steps may be cut by what is at their ends. */
export function listSamplers({ adaptive, substeps = true, modules }: Pick<RayProgram, 'adaptive' | 'modules'> & Partial<RayProgram>): string[] {
  const between = adaptive ? ['uHalfPicture', ...modules.flatMap((module) => module.between?.samplers ?? [])] : [];
  return [...new Set([...modules.flatMap(({ samplers }) => samplers), ...(substeps ? ['uSubstepTable'] : []), ...between])];
}

function checkModules(program: RayProgram): void {
  for (const stage of ['field', 'classify', 'gather'] as const) {
    const count = program.modules.filter((module) => module.stage === stage && !module.members).length;
    if (count !== 1) throw new TypeError(`the stage ${stage} got ${count} modules; expected 1`);
  }
  const samplers = listSamplers(program);
  const most = maxSamplers(program.webgl2);
  if (samplers.length > most) {
    throw new TypeError(`the program got ${samplers.length} samplers (${samplers.join(', ')}); expected ${most} at most`);
  }
}
