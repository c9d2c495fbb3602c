import average from '../../../../shaders/chunks/classify/average.glsl?raw';
import cubic from '../../../../shaders/chunks/field/cubic.glsl?raw';
import emptySpace from '../../../../shaders/chunks/walk/empty-space.glsl?raw';
import extreme from '../../../../shaders/chunks/gather/extreme.glsl?raw';
import voxelPlanes from '../../../../shaders/chunks/walk/voxel-planes.glsl?raw';
import walkVoxels from '../../../../shaders/chunks/walk/walk-voxels.glsl?raw';
import { measureCellLimits } from '../../../optics/cells/cell-limits.ts';
import { lastCode, encodeCells, measureEmptySpace } from '../../../optics/cells/empty-space-distance.ts';
import { refinements } from '../../../optics/rays/projection.ts';
import type { ProjectionKind } from '../../../optics/rays/ray-style.ts';
import { powerOfSteps } from '../../../optics/transfer/power-of-steps.ts';
import { uploadCells } from '../../textures/cell-texture.ts';
import type { CellTexture } from '../../textures/cell-texture.ts';
import type { Device, Gl } from '../../device/device.ts';
import { Kept } from '../../device/kept.ts';
import type { RayFrame, RayModule, RayText, RayTwin } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';

/** The largest byte: the limit of a cell about which nothing is known. */
const anything = 255;

/** How rays are projected. */
export interface ProjectionOptions {
  /** Whether there is a threshold: the first local extreme beyond it counts. */
  readonly isLocal?: boolean;
  /** Whether rays go from plane to plane of voxels instead of by steps, so that they miss no value. */
  readonly isExact?: boolean;
}

export function projectionText(
  kind: ProjectionKind,
  { isLocal = false, isExact = false }: ProjectionOptions = {},
): RayText {
  const shared = { name: kind, stage: 'gather', ...(isExact && { walk: walkVoxels }) } as const;
  const planes = isExact ? [cubic, voxelPlanes] : [];
  const defines = { EXACT: Number(isExact) };
  if (kind === 'average')
    return {
      ...shared,
      defines: { ...defines, LAST_CODE: lastCode.toFixed(1) },
      chunks: [...planes, average, emptySpace],
      samplers: ['uEmptySpaceDistance'],
    };
  const sign = kind === 'max' ? '1.0' : '-1.0';
  return {
    ...shared,
    defines: { ...defines, EXTREME_SIGN: sign, REFINEMENTS: refinements, LOCAL_EXTREME: Number(isLocal) },
    chunks: [...planes, extreme],
    samplers: ['uCellLimits'],
  };
}

/** Which of a ray's values is shown. */
interface Projection {
  readonly kind: ProjectionKind;
  /** See `RayStyle.intensityThreshold`. */
  readonly threshold?: number;
}

export const projectionTwin = ({ kind, threshold }: Projection): RayTwin =>
  twinOf(usualTwins, ({ projectionGather }) => ({ gather: projectionGather(kind, threshold) }));

/**
 * The largest, the smallest or the mean value along each ray, in the transfer function's colours.
 * @returns one module that takes steps, and one that goes from plane to plane of voxels
 */
export function createProjection(
  { kind, threshold }: Projection,
  gl: Gl,
  device: Device,
): { readonly stepped: RayModule<'gather'>; readonly exact: RayModule<'gather'> } {
  const cells = new Kept<CellTexture>();
  const isLocal = threshold !== undefined && kind !== 'average';
  const [samplerName] = projectionText(kind).samplers;
  const stepped: RayModule<'gather'> = {
    ...projectionText(kind, { isLocal }),
    stage: 'gather',
    // The picture jumps where the first local extreme is another one.
    sparesRays: !isLocal,
    twin: projectionTwin({ kind, threshold }),
    order: isLocal ? 1 : kind === 'average' ? 2 : 4,
    inputs(frame) {
      const {
        volume: { macrocells },
        skipping,
        volume,
        domain,
      } = frame;
      const key = kind === 'average' ? [volume, skipping] : [volume, skipping, ...domain];
      const { unit, uniforms } = cells.get(key, (previous) =>
        uploadCells(gl, describeCells(kind, frame), macrocells, { previous, device, samplerName }),
      );
      return {
        uniforms: {
          ...uniforms,
          uDetailPower: powerOfSteps(0),
          ...(isLocal && { uThreshold: shareOf(threshold, domain) * (kind === 'max' ? 1 : -1) }),
        },
        units: [unit],
      };
    },
    dispose: () => gl.deleteTexture(cells.last?.unit.texture ?? null),
  };
  return {
    stepped,
    exact: { ...stepped, ...projectionText(kind, { isLocal, isExact: true }), stage: 'gather', order: Infinity },
  };
}

function shareOf(value: number, [low, high]: readonly [number, number]): number {
  return (value - low) / (high - low);
}

/** A byte for each cell that says whether a ray may skip the cell; it does not depend on opacity. */
function describeCells(
  kind: ProjectionKind,
  { volume, skipping, domain: [low, high] }: RayFrame,
): Uint8Array<ArrayBuffer> {
  const { macrocells, slope, intercept } = volume;
  if (kind === 'average')
    return skipping ? encodeCells(measureEmptySpace(macrocells, [], volume)) : new Uint8Array(macrocells.low.length);
  if (!skipping) return new Uint8Array(macrocells.low.length).fill(anything);
  return measureCellLimits(
    macrocells,
    { scale: slope / (high - low), offset: (intercept - low) / (high - low) },
    kind === 'max' ? 1 : -1,
  );
}
