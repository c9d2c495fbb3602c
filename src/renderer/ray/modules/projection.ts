import average from '../../../../shaders/chunks/average.glsl?raw';
import emptySpace from '../../../../shaders/chunks/empty-space.glsl?raw';
import extreme from '../../../../shaders/chunks/extreme.glsl?raw';
import { measureCellLimits } from '../../../optics/cell-limits.ts';
import { cellCodes, encodeCells, measureEmptySpace } from '../../../optics/empty-space-distance.ts';
import { refinements } from '../../../optics/projection.ts';
import type { ProjectionKind } from '../../../optics/ray-style.ts';
import { powerOfSteps } from '../../../optics/power-of-steps.ts';
import { uploadCells } from '../../cell-texture.ts';
import type { CellTexture } from '../../cell-texture.ts';
import type { Device, Gl } from '../../device.ts';
import { Kept } from '../../kept.ts';
import type { RayFrame, RayModule, RayText } from '../ray-module.ts';

export { projectionGather as twin } from '../../../optics/projection.ts';

/** Largest value, and byte, of a cell that nothing is known of. */
const anything = 255;

/** @param isLocal - whether there is a threshold, from which on the first local extreme counts */
export function projectionText(kind: ProjectionKind, isLocal = false): RayText {
  const shared = { name: kind, stage: 'gather' } as const;
  if (kind === 'average') return { ...shared, defines: { CELL_CODES: cellCodes.toFixed(1) }, chunks: [emptySpace, average], samplers: ['uEmptySpaceDistance'] };
  const sign = kind === 'max' ? '1.0' : '-1.0';
  return { ...shared, defines: { EXTREME_SIGN: sign, REFINEMENTS: refinements, LOCAL_EXTREME: Number(isLocal) }, chunks: [extreme], samplers: ['uCellLimits'] };
}

/** What of a ray's values is shown. */
interface Projection {
  readonly kind: ProjectionKind;
  /** See `RayStyle.intensityThreshold`. */
  readonly threshold?: number;
}

/** The largest, the smallest or the mean value along each ray, in the transfer function's colours. */
export function createProjection({ kind, threshold }: Projection, gl: Gl, device: Device): RayModule<'gather'> {
  const cells = new Kept<CellTexture>();
  const isLocal = threshold !== undefined && kind !== 'average';
  const text = projectionText(kind, isLocal);
  const [samplerName] = text.samplers;
  return {
    ...text,
    stage: 'gather',
    // From one local extreme to another the picture jumps.
    sparesRays: !isLocal,
    order: isLocal ? 1 : kind === 'average' ? 2 : 4,
    inputs(frame) {
      const { volume: { macrocells }, skipping, volume, domain } = frame;
      const key = kind === 'average' ? [volume, skipping] : [volume, skipping, ...domain];
      const { unit, uniforms } = cells.get(key, (previous) =>
        uploadCells(gl, describeCells(kind, frame), macrocells.dimensions, { previous, device, samplerName }));
      return { uniforms: { ...uniforms, uDetailPower: powerOfSteps(0), ...(isLocal && { uThreshold: shareOf(threshold, domain) * (kind === 'max' ? 1 : -1) }) }, units: [unit] };
    },
    dispose: () => gl.deleteTexture(cells.last?.unit.texture ?? null),
  };
}

function shareOf(value: number, [low, high]: readonly [number, number]): number {
  return (value - low) / (high - low);
}

/** What tells which cells a ray may cross without looking; opacity does not. */
function describeCells(kind: ProjectionKind, { volume, skipping, domain: [low, high] }: RayFrame): Uint8Array<ArrayBuffer> {
  const { macrocells, slope, intercept } = volume;
  if (kind === 'average') return skipping ? encodeCells(measureEmptySpace(macrocells, [], volume)) : new Uint8Array(macrocells.low.length);
  if (!skipping) return new Uint8Array(macrocells.low.length).fill(anything);
  return measureCellLimits(macrocells, { scale: slope / (high - low), offset: (intercept - low) / (high - low) }, kind === 'max' ? 1 : -1);
}
