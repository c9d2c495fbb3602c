import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';
import { listLeft } from '../base/list-left.ts';
import type { NumberType } from '../base/number-types.ts';
import type { PieceReader } from '../base/piece-reader.ts';
import type { SeriesInfo } from '../base/scan-data.ts';
import { keepVolumes, listRanges } from '../series/keep-volumes.ts';
import { openSeries } from '../series/open-series.ts';
import { shortest, timeAt } from '../series/scan-times.ts';
import type { TimeSteps } from '../series/scan-times.ts';
import { scanTypes } from '../series/scan-types.ts';
import { niftiHeaderBytes, viewOf } from './nifti-header.ts';
import type { NiftiHeader } from './nifti-header.ts';
import type { NiftiSource } from './nifti.ts';

/** What the reader knows of a file when it finds several volumes in it. */
interface NiftiSeries {
  readonly header: NiftiHeader;
  /** Of one volume. */
  readonly span: { readonly offset: number; readonly bytes: number };
  readonly type: NumberType;
  readonly rescale: { readonly slope: number; readonly intercept: number };
  readonly info: SeriesInfo;
  readonly volumes: number;
  /** What is left out besides volumes. */
  readonly omitted: readonly (string | null)[];
}

/**
 * Opens the volumes of a file as scans. Along the fourth axis lie times; where a voxel has several numbers, the scans are those of
 * the first number.
 * @returns null where its numbers are of a type that only single volumes have
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`, and what fetching throws
 */
export async function openNiftiScans(
  reader: PieceReader,
  source: NiftiSource,
  { header, span: { offset, bytes }, type, rescale, info, volumes, omitted }: NiftiSeries,
): Promise<DecodedCartesianVolume | null> {
  const { input, settings, context } = source.scans!;
  const [, , , , times = 1, numbers = 1] = header.dim.slice(0, 1 + header.dim[0]);
  const count = numbers > 1 ? times : volumes;
  if (!scanTypes.has(type.name) || count < 2) return null;
  const span = { what: 'the NIfTI file', offset, bytes, count };
  const steps = count === times ? readSteps(header, await reader.readStart(niftiHeaderBytes)) : null;
  const kept =
    input.wholeBytes === undefined
      ? await keepVolumes(reader, source, span)
      : listRanges(input.url, input.wholeBytes, span);
  return openSeries(
    {
      info: {
        ...info,
        ...listLeft(1, kept.left, numbers > 1 && volumes > count ? `volumes along axes 6 and 7` : null, ...omitted),
      },
      volumes: kept.volumes,
      count,
      type: type.name,
      littleEndian: header.littleEndian,
      scaleOf: () => rescale,
      timeOf: (index) => timeAt(index, steps),
    },
    settings,
    context,
  );
}

/**
 * Times of the volumes; null where the header gives no unit, or no step above 0.
 * Source: nifti1.h, xyzt_units, pixdim[4] and toffset
 */
function readSteps({ version, littleEndian, units, pixdim }: NiftiHeader, start: Uint8Array): TimeSteps | null {
  const unit = timeUnits.get(units & 0x38);
  const step = shortest(pixdim[4]);
  if (!unit || !(step > 0 && Number.isFinite(step))) return null;
  const view = viewOf(start);
  const offset = version === 1 ? shortest(view.getFloat32(136, littleEndian)) : view.getFloat64(224, littleEndian);
  const [name, per] = unit;
  return { first: Number.isFinite(offset) ? offset / per : 0, step: step / per, unit: name };
}

/** Units of the fourth axis, and how many of the file's are one of ours. */
const timeUnits: ReadonlyMap<number, readonly [name: string, per: number]> = new Map([
  [8, ['s', 1]],
  [16, ['s', 1e3]],
  [24, ['s', 1e6]],
  [32, ['Hz', 1]],
  [40, ['ppm', 1]],
  [48, ['rad/s', 1]],
]);
