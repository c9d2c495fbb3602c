// Of NIfTI files, what only those of several volumes, or of several numbers a voxel, need.
import { cartesianGrid } from '../../volume/grid.ts';
import { bytesOfColors } from '../base/channels.ts';
import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';
import { listLeft } from '../base/list-left.ts';
import type { NumberType } from '../base/number-types.ts';
import type { SeriesInfo } from '../base/scan-data.ts';
import { yieldOnce } from '../base/piece-reader.ts';
import { gunzip, isGzip } from '../codecs/gunzip.ts';
import { keepVolumes, listRanges } from '../series/keep-volumes.ts';
import { openSeries } from '../series/open-series.ts';
import { shortest, timeAt } from '../series/scan-times.ts';
import type { TimeSteps } from '../series/scan-times.ts';
import { scanTypes } from '../series/scan-types.ts';
import { resolveAffine } from './nifti-affine.ts';
import { niftiHeaderBytes, readDimensions, readWindow } from './nifti-header.ts';
import type { NiftiHeader } from './nifti-header.ts';
import { describeLost } from './nifti-rare-types.ts';
import type { NiftiSource } from './nifti-source.ts';

/** The numbers of one volume. */
interface VolumeNumbers {
  readonly type: NumberType;
  readonly rescale: { readonly slope: number; readonly intercept: number };
  readonly bytes: number;
}

/** What of a file is left out where its first volume is shown, and which one it is. */
function describeFirst(header: NiftiHeader, type: NumberType): Pick<DecodedCartesianVolume, 'format' | 'left'> {
  const { volumes, numbers } = readDimensions(header);
  const count = volumes * numbers;
  return {
    format: `NIfTI-${header.version}${count > 1 ? `, volume 1 of ${count}` : ''}`,
    ...listLeft(volumes, ...listOmitted(numbers, type)),
  };
}

function listOmitted(numbers: number, type: NumberType): (string | null)[] {
  return [numbers > 1 ? `number${numbers > 2 ? 's 2 to' : ''} ${numbers} of each voxel` : null, describeLost(type)];
}

/**
 * Opens the volumes of a file as scans. Along the fourth axis lie times; where a voxel has several numbers, the scans are those of
 * the first number.
 * @returns what is to be said of the first volume where only that is wanted, or its numbers are of a type that scans can't have
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`, and what fetching throws
 */
export async function openScans(
  { scans, head, describe, atMost, onProgress, budget }: NiftiSource,
  header: NiftiHeader,
  { type, rescale, bytes }: VolumeNumbers,
): Promise<DecodedCartesianVolume | Pick<DecodedCartesianVolume, 'format' | 'left'>> {
  const { dimensions, volumes, numbers } = readDimensions(header);
  const [, , , , times = 1] = header.dim.slice(0, 1 + header.dim[0]);
  const count = numbers > 1 ? times : volumes;
  if (type.colors) budget.take((bytesOfColors * bytes) / type.bytesPerSample, 'the colours of the NIfTI file');
  const [input, settings, context] = scans ?? [];
  if (!settings?.scan || !input || !context || context.isPart) return describeFirst(header, type);
  if (!scanTypes.has(type.name) || !(count > 1)) return describeFirst(header, type);
  const span = { what: 'the NIfTI file', offset: header.offset, bytes, count };
  const { missing = 0 } = input;
  const kept =
    missing > 0
      ? listRanges(input, missing, span)
      : await keepVolumes(isGzip(input.bytes) ? gunzip(input.bytes) : yieldOnce(input.bytes), span, {
          atMost,
          onProgress,
          budget,
        });
  const steps = count === times ? await readSteps(header, head ? new Blob([head]) : kept.file) : null;
  const { indexToWorld, anatomical } = resolveAffine(header, dimensions);
  const info: SeriesInfo = {
    grid: cartesianGrid(dimensions, indexToWorld),
    anatomical,
    unit: '',
    format: `NIfTI-${header.version}`,
    isLabels: header.intent === 1002,
    intent: header.intent,
    ...readWindow(header),
    ...listLeft(
      1,
      kept.left,
      numbers > 1 && volumes > count ? 'volumes along the sixth and the seventh axis' : null,
      ...listOmitted(numbers, type),
    ),
  };
  return openSeries(
    {
      info: { ...info, ...describe?.(info) },
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
async function readSteps({ version, littleEndian, units, pixdim }: NiftiHeader, file: Blob): Promise<TimeSteps | null> {
  const unit = timeUnits.get(units & 0x38);
  const step = shortest(pixdim[4]);
  if (!unit || !(step > 0 && Number.isFinite(step))) return null;
  const view = new DataView(await file.slice(0, niftiHeaderBytes).arrayBuffer());
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
