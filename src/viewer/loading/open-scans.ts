// Opens a source with several scans. Loaded with the first such source.
import type { LoadRequest, ScansListener } from '../../formats/base/load-request.ts';
import type { Volume } from '../../volume/volume.ts';
import type { ScanSource } from '../model/scans-of-view.ts';
import type { Opening, SourceHost } from './opening.ts';
import { ScanPlayer } from './scan-player.ts';

/** A player of the scans that a manifest, or a file of several volumes, holds; it aims at the one that is wanted. */
export function openScans(
  url: string,
  [times, data]: Parameters<ScansListener>,
  host: SourceHost,
  { wanted, signal }: Opening,
): ScanPlayer {
  return startPlayer(
    times.map((time, index) => ({ url, index, time, data: data?.[index] })),
    host,
    signal,
  ).aim(wanted);
}

/** Loads the wanted one of several files, which are scans in time; but those of NEXRAD Level III may be tilts of one scan. */
export async function openList(urls: readonly string[], host: SourceHost, opening: Opening): Promise<Volume> {
  const { wanted, signal, onProgress } = opening;
  const player = startPlayer(
    urls.map((url) => ({ url })),
    host,
    signal,
  );
  const volume = await player.load(wanted, signal, onProgress);
  if (!isTilt(volume) || !(await hasOtherTilts(volume, urls, host, signal))) return volume;
  const tilts = await openTilts(urls, host, opening);
  player.stop();
  return tilts;
}

function startPlayer(sources: readonly ScanSource[], host: SourceHost, signal: AbortSignal): ScanPlayer {
  signal.throwIfAborted();
  const player = new ScanPlayer(sources, {
    ...host,
    load: (request, loading, onLoading) => host.load(request, { signal: loading, onProgress: onLoading }),
  });
  host.opened(player);
  return player;
}

const isTilt = ({ format }: Volume): boolean => format.startsWith('NEXRAD Level III');

const elevationOf = ({ radar }: Volume): number | undefined => radar?.sweeps[0]?.elevation;

/** Whether a file after the first, or the last one, has another elevation: a list that has none goes on as scans in time. */
async function hasOtherTilts(
  first: Volume,
  urls: readonly string[],
  host: SourceHost,
  signal: AbortSignal,
): Promise<boolean> {
  for (const url of new Set([urls[0], urls[1], urls.at(-1)!])) {
    // A file that can't be read is no reason to show none.
    const other = await host.load({ url }, { signal, onProgress: () => {} }).catch(() => null);
    signal.throwIfAborted();
    if (other && isTilt(other) && elevationOf(other) !== elevationOf(first)) return true;
  }
  return false;
}

/** All files together: one scan, or several in time, each of the sweeps that it has. */
async function openTilts(urls: readonly string[], host: SourceHost, opening: Opening): Promise<Volume> {
  const { wanted, signal, onProgress } = opening;
  const [url] = urls;
  const request: Pick<LoadRequest, 'url' | 'files'> = { url, files: urls };
  let found: Parameters<ScansListener> | null = null;
  const onScans: ScansListener = (...scans) => (found = scans);
  const volume = await host.load({ ...request, scan: wanted }, { signal, onProgress, onScans });
  const player = found ? openScans(url, found, host, opening) : startPlayer([request], host, signal);
  player.keep(volume);
  return found ? player.load(wanted, signal, onProgress) : volume;
}
