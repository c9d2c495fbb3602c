import type { ScanTarget } from '../../formats/base/choose-scan.ts';
import type { LoadOptions } from '../../worker/load.ts';
import type {
  CoarseListener,
  LoadProgressListener,
  LoadRequest,
  ScansListener,
} from '../../formats/base/load-request.ts';
import { loadPart } from '../../core/load-part.ts';
import type { Volume } from '../../volume/volume.ts';
import type { ScanHost, ScanPlayer } from './scan-player.ts';
import type { ScanSource } from '../model/scans-of-view.ts';

/** A file, or several files of one volume, and which scan of a manifest. */
export type SourceRequest = Pick<LoadRequest, 'url' | 'files' | 'scan' | 'data'>;

/** What an author says about the source. */
export interface Source {
  /** One URL, or several, separated by blanks. */
  readonly src: string;
  /** Whether several are the files of one volume, instead of scans in time. */
  readonly stack: boolean;
}

/** What opening a source needs of its caller. */
export interface SourceHost extends Omit<ScanHost, 'load'> {
  readonly load: (request: SourceRequest, options: LoadOptions) => Promise<Volume>;
  /** Called if the source has several scans: this player shows one after another. */
  readonly opened: (player: ScanPlayer) => void;
}

interface Opening {
  /** The requested scan, where there are several. */
  readonly wanted: ScanTarget;
  readonly signal: AbortSignal;
  readonly onProgress: LoadProgressListener;
  /** Not called for scans that follow another one: a picture is already there. */
  readonly onCoarse: CoarseListener;
}

/** Load the volume of a source; of several scans, the requested one. */
export async function openSource({ src, stack }: Source, host: SourceHost, opening: Opening): Promise<Volume> {
  const { wanted, signal, onProgress, onCoarse } = opening;
  const urls = src.trim().split(/\s+/);
  if (urls.length > 1 && !stack) {
    const player = await startPlayer(
      urls.map((url) => ({ url })),
      host,
      signal,
    );
    return player.load(wanted, signal, onProgress);
  }
  const [url] = urls;
  const files = stack ? urls : undefined;
  let starting: Promise<ScanPlayer> | null = null;
  const onScans: ScansListener = (times, data) => {
    starting = startPlayer(
      times.map((time, index) => ({ url, index, time, data: data?.[index] })),
      host,
      signal,
    ).then((one) => one.aim(wanted));
    starting.catch(() => {}); // It is awaited below.
  };
  // If one scan fails, the others can still be shown.
  const [loaded] = await Promise.allSettled([
    host.load({ url, files, scan: wanted }, { signal, onProgress, onScans, onCoarse }),
  ]);
  const player = await (starting as Promise<ScanPlayer> | null);
  if (loaded.status === 'rejected') throw loaded.reason;
  if (!player) return loaded.value;
  player.keep(loaded.value);
  return player.load(wanted, signal, onProgress);
}

/** The code for sources with several scans is loaded with the first such source. */
async function startPlayer(sources: readonly ScanSource[], host: SourceHost, signal: AbortSignal): Promise<ScanPlayer> {
  const { ScanPlayer } = await loadPart(import('./scan-player.ts'), 'shows several scans');
  signal.throwIfAborted();
  const player = new ScanPlayer(sources, {
    ...host,
    load: (request, loading, onLoading) => host.load(request, { signal: loading, onProgress: onLoading }),
  });
  host.opened(player);
  return player;
}
