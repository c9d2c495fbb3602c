// The values of one place in all scans of a view: loaded when somebody asks for them.
import { hasNumbers } from '../../formats/base/scan-data.ts';
import type { ScanData, ScanNumbers } from '../../formats/base/scan-data.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';
import type { ScansOfView } from '../model/scans-of-view.ts';
import type { SocketView } from '../model/view-socket.ts';
import { VolumeCache } from '../model/volume-cache.ts';
import type { VolumePick } from '../model/volume-pick.ts';
import { valueInVolume } from './pick.ts';
import { placeDataOf, valuesOfPlace } from './place-data.ts';

/** A place in the volume that a pick has found. */
export type TimedPlace = Pick<VolumePick, 'world' | 'voxel' | 'radar'>;

/** The values of a place, as far as they are known. */
export interface ValuesOverTime {
  /** For each scan: its value, NaN where it has no data there, undefined where it is not read. */
  readonly values: readonly (number | undefined)[];
  /** Share of the work that is done, 0..1. */
  readonly done: number;
  /** The number of scans that could not be read. */
  readonly failed: number;
}

interface Reading {
  readonly signal: AbortSignal;
  /** Called whenever more is known, the last time with all. */
  readonly onValues: (known: ValuesOverTime) => void;
}

/** Whether a place has values: a surface where the volume has no data has none. */
export const hasValues = ({ voxel, radar }: TimedPlace): boolean => voxel !== null || radar !== null;

/**
 * Reads the values of a place in all scans. Of a file of several volumes, whose numbers lie one after another, only those of that voxel are read. Else scans are opened,
 * a few at a time, and are not kept: those that are in memory come first.
 * @throws {VolumeViewError} where nothing can be read; the signal's reason
 */
export async function readOverTime(view: SocketView | null, place: TimedPlace, reading: Reading): Promise<void> {
  const scans = view?.user.loader?.scans;
  const volume = view?.volume;
  if (!scans || !volume) return;
  const data = scans.sources.map((source) => source.data);
  reading.onValues({ values: data.map(() => undefined), done: 0, failed: 0 });
  // A cleaned volume, and one that was made smaller for the device, has other values than its file.
  const isAsInFile = !volume.reduced && (view.settings.source?.clean ?? null) === null;
  if (place.voxel && isAsInFile && data.every(isOfNumbers)) await readVoxel(scans, data, place.voxel, reading);
  else await readScans(scans, { world: place.world, shown: volume }, reading);
}

const isOfNumbers = (data: ScanData | undefined): data is ScanNumbers => data !== undefined && hasNumbers(data);

/** So many volumes are asked for at a time: their numbers are read as a volume of as many voxels, which each device can hold. */
const together = 256;

/** Reads one voxel of all volumes of a file, in the worker. */
async function readVoxel(
  scans: ScansOfView,
  data: readonly ScanNumbers[],
  voxel: Vector3,
  { signal, onValues }: Reading,
): Promise<void> {
  const values: number[] = [];
  const notify = (read: number): void =>
    onValues({ values: data.map((_, i) => values[i]), done: read / data.length, failed: 0 });
  while (values.length < data.length) {
    const start = values.length;
    const some = data.slice(start, start + together);
    const read = await scans.loadAside(
      start,
      signal,
      ({ loaded, total, phase }) => phase === 'decode' && total > 0 && notify(start + (some.length * loaded) / total),
      placeDataOf(some, voxel),
    );
    signal.throwIfAborted();
    values.push(...valuesOfPlace(read, some));
    notify(values.length);
  }
}

/** So many scans are opened at a time, where the device can hold as many volumes: reading one waits for its file most of the time. */
const opened = 3;

/** Opens the scans that are not in memory, a few at a time. One that can't be read is counted, and the others go on. */
async function readScans(
  scans: ScansOfView,
  { world, shown }: { readonly world: Vector3; readonly shown: Volume },
  { signal, onValues }: Reading,
): Promise<void> {
  const { sources } = scans;
  const values = sources.map((): number | undefined => undefined);
  const isKept = sources.map((_, index) => scans.findKept(index) !== null);
  const order = [...sources.keys()];
  order.sort((a, b) => Number(isKept[b]) - Number(isKept[a]) || a - b);
  let [next, done, failed] = [0, 0, 0];
  const work = async (): Promise<void> => {
    for (let index = order[next++]; index !== undefined; index = order[next++]) {
      try {
        const volume = scans.findKept(index) ?? (await scans.loadAside(index, signal));
        values[index] = await valueInVolume(volume, world);
      } catch (error) {
        signal.throwIfAborted();
        failed++;
        if (failed === sources.length) throw error;
      }
      done++;
      onValues({ values: [...values], done: done / order.length, failed });
    }
  };
  await Promise.all(Array.from({ length: VolumeCache.holds(shown, opened) ? opened : 1 }, work));
}
