import { decodeFile } from '../../src/formats/decode.ts';
import { finishVolume } from '../../src/formats/finish-volume.ts';
import { Budget } from '../../src/formats/base/budget.ts';
import type { ScanTarget, ScanTimes } from '../../src/formats/base/choose-scan.ts';
import type { DecodeInput } from '../../src/formats/base/decoded-volume.ts';
import type { ScanData } from '../../src/formats/base/scan-data.ts';
import { readPlacedScan } from '../../src/formats/read-placed-scan.ts';
import { fetchInOrder } from '../../src/sources/fetch-files.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { fixtureContext, roomyLimits, urlOf } from './decode.ts';

/** A file of several volumes, open. */
export interface OpenScans {
  /** The one that was wanted. */
  readonly first: Volume;
  readonly times: ScanTimes;
  readonly data: readonly ScanData[];
  /** Reads one of them, as the worker does when it is shown. */
  read(index: number): Promise<Volume>;
}

/** Opens a file as the worker does. @param parts - what its server sends of ranges, where it was not fetched as a whole */
export async function openScans(
  bytes: Uint8Array<ArrayBuffer>,
  name: string,
  {
    scan = { index: 0 },
    files,
    budget,
    input = {},
    fetchFile,
  }: {
    scan?: ScanTarget;
    files?: readonly string[];
    budget?: Budget;
    input?: Partial<DecodeInput>;
    fetchFile?: ReturnType<typeof fixtureContext>['fetchFile'];
  } = {},
): Promise<OpenScans> {
  let times: ScanTimes = [];
  let data: readonly ScanData[] = [];
  const context = fixtureContext();
  const access = fetchFile
    ? {
        ...context,
        fetchFile,
        fetchFiles: (urls: readonly string[]) =>
          fetchInOrder(
            urls,
            (url) => fetchFile(url),
            () => {},
          ),
      }
    : context;
  const decoded = await decodeFile(
    { bytes, url: urlOf(name), contentType: '', ...input },
    { scan },
    {
      ...access,
      files,
      budget,
      onScans: (found, places = []) => {
        times = found;
        data = structuredClone(places); // As a message brings it to the page.
      },
    },
  );
  return {
    first: await finishVolume(decoded, roomyLimits),
    times,
    data,
    read: async (index) =>
      finishVolume(
        await readPlacedScan(data[index], {}, { fetchFile: access.fetchFile, budget: budget ?? new Budget() }),
        roomyLimits,
      ),
  };
}
