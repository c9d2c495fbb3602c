import { loadPart } from '../../core/load-part.ts';
import type { ScansListener } from '../../formats/base/load-request.ts';
import type { Volume } from '../../volume/volume.ts';
import type { Opening, Source, SourceHost } from './opening.ts';
import type { ScanPlayer } from './scan-player.ts';

/** Load the volume of a source; of several scans, the requested one. */
export async function openSource({ src, stack }: Source, host: SourceHost, opening: Opening): Promise<Volume> {
  const { wanted, signal, onProgress, onCoarse } = opening;
  const urls = src.trim().split(/\s+/);
  if (urls.length > 1 && !stack) return (await loadScans()).openList(urls, host, opening);
  const [url] = urls;
  const files = stack ? urls : undefined;
  let starting: Promise<ScanPlayer> | null = null;
  const onScans: ScansListener = (times, data) => {
    starting = loadScans().then(({ openScans }) => openScans(url, [times, data], host, opening));
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
const loadScans = () => loadPart(import('./open-scans.ts'), 'shows scans');
