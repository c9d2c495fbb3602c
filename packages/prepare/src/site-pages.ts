import { escapeMarkup } from '../../lesson-writers/src/index.ts';
import type { DoneLine, SiteForm } from './job.ts';

/** The script of the element; it lies next to index.html. */
export const scriptName = 'volume-view.iife.js';

/** The folder next to it, of which it loads what a page needs. */
export const partsName = 'classic';

/** The library that draws; the element loads it from the folder of its own script. */
export const x3domName = 'x3dom.js';

const head = (title: string, more = ''): string => `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>${escapeMarkup(title)}</title>
<style>
  :root { color-scheme: light dark }
  body { margin: 1.5rem auto; max-width: 70rem; padding: 0 1rem; font: 1rem/1.5 system-ui, sans-serif }
  ${more}
</style>
`;

/** What an element says of a volume to people who do not see it. */
export function altOf({ format, dimensions, unit }: Pick<DoneLine, 'format' | 'dimensions' | 'unit'>): string {
  return `A volume (${format}) of ${dimensions.join(' x ')} ${/radar|polar|ODIM|CfRadial|NEXRAD/i.test(format) ? 'gates, rays and sweeps' : 'voxels'}${unit ? `, values in ${unit}` : ''}`;
}

/** The page of one volume. @param src - the URL of its manifest, or the manifest itself as a `data:` URL */
export function writeScanPage(line: Omit<DoneLine, 'page'>, src: string, hasPoster: boolean): string {
  const { title } = line;
  const poster = hasPoster ? ' poster="poster.png"' : '';
  return `${head(title, 'volume-view { width: 100%; height: min(75vh, 44rem) }')}<h1>${escapeMarkup(title)}</h1>
<volume-view controls alt="${escapeMarkup(altOf(line))}" src="${escapeMarkup(src)}"${poster}></volume-view>
<p>${escapeMarkup(describe(line))}</p>
<p><a href="../index.html">All scans</a></p>
<script src="../${scriptName}"></script>
</html>
`;
}

/** The page of the scans of one series. @param src - the URL of their manifest */
export function writeSeriesPage(lines: readonly Omit<DoneLine, 'page'>[], src: string, hasPoster: boolean): string {
  const [first] = lines;
  const poster = hasPoster ? ' poster="poster.png"' : '';
  return `${head(first.title, 'volume-view { width: 100%; height: min(70vh, 44rem) }')}<h1>${escapeMarkup(first.title)}</h1>
<volume-view id="view" controls alt="${escapeMarkup(altOf(first))}" src="${escapeMarkup(src)}"${poster}></volume-view>
<volume-timeline for="view"></volume-timeline>
<p>${escapeMarkup(describeScans(lines))}</p>
<p><a href="../index.html">All scans</a></p>
<script src="../${scriptName}"></script>
</html>
`;
}

/**
 * The page of the newest scans of a radar, `scans.json` next to it. It looks for a new list from time to time: a reader who has the newest
 * scan before him gets the next one, another stays where he is.
 */
export function writeRollingPage(
  title: string,
  newest: Omit<DoneLine, 'page'>,
  { seconds, hasPoster }: { readonly seconds: number; readonly hasPoster: boolean },
): string {
  const poster = hasPoster ? ' poster="poster.png"' : '';
  return `${head(title, 'volume-view { width: 100%; height: min(70vh, 44rem) }')}<h1>${escapeMarkup(title)}</h1>
<volume-view id="view" controls alt="${escapeMarkup(altOf(newest))}" src="scans.json" time="${endOfTime}"${poster}></volume-view>
<volume-timeline for="view"></volume-timeline>
<p><a href="../index.html">All scans</a></p>
<script src="../${scriptName}"></script>
<script>
  const view = document.getElementById('view');
  let known = null;
  let count = 0;
  async function look() {
    const answer = await fetch('scans.json', { cache: 'no-cache' });
    if (!answer.ok) return;
    const text = await answer.text();
    if (known !== null && text !== known) {
      const { scan, paused } = view;
      const isNewest = !scan || scan.index === scan.count - 1;
      view.time = isNewest || !paused ? '${endOfTime}' : scan.time;
      view.src = 'scans.json?' + ++count;
      if (!paused) view.play().catch(() => {});
    }
    known = text;
  }
  look().catch(() => {});
  setInterval(() => look().catch(() => {}), ${1000 * seconds});
</script>
</html>
`;
}

/** A page with this time shows the newest scan. */
const endOfTime = '9999-12-31T00:00:00Z';

/** The page of all volumes: a series of scans has one place in it. */
export function writeIndex(lines: readonly (DoneLine & { readonly hasPoster: boolean })[]): string {
  const series = new Map<string, (DoneLine & { readonly hasPoster: boolean })[]>();
  for (const line of lines) {
    const page = line.scans ?? line.page;
    series.set(page, [...(series.get(page) ?? []), line]);
  }
  const cards = [...series].map(
    ([
      page,
      [line, ...more],
    ]) => `  <li><a href="${escapeMarkup(page)}">${line.hasPoster ? `<img src="${line.id}/poster.png" loading="lazy" alt="">` : ''}
    <strong>${escapeMarkup(line.title)}</strong></a><br>${escapeMarkup(describeScans([line, ...more]))}</li>`,
  );
  return `${head(
    'Scans',
    `ul { list-style: none; padding: 0; display: grid; grid-template-columns: repeat(auto-fill, minmax(min(15rem, 100%), 1fr)); gap: 1.5rem }
  li { overflow-wrap: anywhere }
  img { display: block; width: 100%; height: auto; aspect-ratio: 1; object-fit: contain; background: #0001 }`,
  )}<h1>${series.size} ${series.size === 1 ? 'scan' : 'scans'}</h1>
<ul>
${cards.join('\n')}
</ul>
</html>
`;
}

/** One scan; or the first one, how many there are, and from when to when. */
export function describeScans(lines: readonly Omit<DoneLine, 'page'>[]): string {
  const [first, last] = [lines[0], lines[lines.length - 1]];
  if (lines.length === 1) return describe(first);
  const when = first.time !== undefined && last.time !== undefined ? `, ${first.time} to ${last.time}` : '';
  const worst = lines.reduce((a, b) => (b.error.max > a.error.max ? b : a));
  return `${lines.length} times${when}: ${describe({ ...first, format: first.format.replace(/, volume 1 of \d+$/, ''), time: undefined, error: worst.error })}`;
}

/** What a form is, in words; nothing where it is a mosaic, as most are. */
const forms: Readonly<Partial<Record<SiteForm, string>>> = {
  'ome-zarr': 'levels of detail (OME-Zarr), of which the page loads what it shows; ',
  video: 'a video of 8 bits; ',
  scorm: 'a package for a course (SCORM 1.2); ',
  'scorm-2004': 'a package for a course (SCORM 2004); ',
  cmi5: 'a package for a course (cmi5); ',
  h5p: 'a package of H5P; ',
};

function describe({ form, format, dimensions, from, error, unit, time }: Omit<DoneLine, 'page'>): string {
  const say = (value: number): string => `${Number(value.toPrecision(2))}${unit ? ` ${unit}` : ''}`;
  const changed =
    error.changedLabels === undefined
      ? error.max > 0
        ? `values within ${say(error.max)} of the file's (root mean square ${say(error.rms)})`
        : 'values as in the file'
      : `${(100 * error.changedLabels).toFixed(1)} % of the voxels have the label of a neighbour`;
  const size = from ? `${from.join(' x ')}, made smaller to ${dimensions.join(' x ')}` : dimensions.join(' x ');
  return `${format}${time ? `, ${time}` : ''}: ${size}; ${forms[form] ?? ''}${changed}.`;
}
