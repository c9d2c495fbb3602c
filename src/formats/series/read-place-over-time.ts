import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';
import type { PlaceData, ScanBytes } from '../base/scan-data.ts';
import { countBytes, readPart, storeScan } from './read-scan.ts';
import type { ScanAccess } from './read-scan.ts';

/** Parts of a file with fewer bytes between them are fetched together: another request takes longer than these bytes. */
const maxGap = 2 ** 16;

/** Bytes of a request for several parts. */
const maxTogether = 2 ** 22;

/** The number of requests at a time. */
const maxRequests = 6;

/** What is read at once, and which parts it holds, by their numbers. */
interface Group {
  from: ScanBytes;
  readonly members: number[];
}

/**
 * Reads the numbers of one place over all times, as a volume of as many voxels.
 * @param data - its parts of a file with ranges are in their order, so that near ones are fetched together
 * @throws {VolumeViewError} `format/corrupt`, `format/too-large`, and what fetching throws
 */
export async function readPlaceOverTime(data: PlaceData, access: ScanAccess): Promise<DecodedCartesianVolume> {
  return storeScan(await joinParts(data.from, data.format, access), data, access);
}

/** Bytes of parts, one after another. @param format - for messages */
async function joinParts(
  parts: readonly ScanBytes[],
  format: string,
  access: ScanAccess,
): Promise<Uint8Array<ArrayBuffer>> {
  const lengths = parts.map((from) => countBytes({ from }));
  let total = 0;
  const starts = lengths.map((length) => (total += length) - length);
  const kept = parts.filter((part) => part instanceof Blob);
  if (kept.length === parts.length) return readPart({ from: new Blob(kept), format }, 0, total, access);
  access.budget.take(total, `${format} of the file`);
  const joined = new Uint8Array(total);
  const groups = groupParts(parts);
  let [next, done] = [0, 0];
  const work = async (): Promise<void> => {
    for (let group = groups[next++]; group; group = groups[next++]) {
      const { from, members } = group;
      const bytes = await readPart({ from, format }, 0, countBytes(group), access);
      for (const i of members) {
        const at = startOf(parts[i]) - startOf(from);
        joined.set(bytes.subarray(at, at + lengths[i]), starts[i]);
      }
      access.budget.giveBack(bytes.length);
      done += members.length;
      access.onProgress?.(done, parts.length);
    }
  };
  await Promise.all(Array.from({ length: maxRequests }, work));
  return joined;
}

function groupParts(parts: readonly ScanBytes[]): Group[] {
  const groups: Group[] = [];
  for (const [i, part] of parts.entries()) {
    const last = groups.at(-1);
    const together = last && spanOf(last.from, part);
    if (together) {
      last.from = together;
      last.members.push(i);
    } else groups.push({ from: part, members: [i] });
  }
  return groups;
}

/** From the start of one part to the end of another that follows it soon in the same file; null for any other. */
function spanOf(before: ScanBytes, part: ScanBytes): ScanBytes | null {
  if (before instanceof Blob || part instanceof Blob || part.url !== before.url) return null;
  const gap = part.start - before.end;
  const isNear = gap >= 0 && gap <= maxGap && part.end - before.start <= maxTogether;
  return isNear ? { ...before, end: part.end } : null;
}

const startOf = (part: ScanBytes): number => (part instanceof Blob ? 0 : part.start);
