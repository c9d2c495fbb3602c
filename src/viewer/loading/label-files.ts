import { VolumeViewError } from '../../core/errors.ts';
import { loadPart } from '../../core/load-part.ts';
import { fetchBytes } from '../../sources/fetch-bytes.ts';
import type { LoadRequest } from '../../formats/base/load-request.ts';
import type { SourceSettings } from '../../formats/base/source-settings.ts';
import type { LabelTable } from '../../formats/label-tables/label-table.ts';
import { maxTableBytes, readLabelTable } from '../../formats/label-tables/read-label-table.ts';
import { findLabels } from '../../volume/resample-labels.ts';
import type { FoundLabels, LabelProblem, LabelVoxels } from '../../volume/resample-labels.ts';
import type { NamedLabel } from '../../volume/labels.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';
import { loadAttachment } from './load-attachment.ts';
import type { AttachmentOptions } from './load-attachment.ts';

/** A label file, and its contents. */
export interface LabelFile {
  readonly voxels: LabelVoxels;
  readonly found: FoundLabels;
  /** Names that the file gives its labels. */
  readonly named?: readonly NamedLabel[];
  /** What of the file is not shown, in words. */
  readonly left?: readonly string[];
  readonly format: string;
  /** Whether its place is that of a patient. */
  readonly anatomical?: boolean;
}

/** Labels are never made smaller by averaging: a file above these limits is refused, or a coarser level of its pyramid is read. */
const limits = { maxVoxelsPerAxis: 2 ** 14, maxAtlasSize: null, maxBytes: 2 ** 30 };

/**
 * Load a file with labels, by the readers of volume files.
 * @throws {VolumeViewError} as loading volumes does, and `format/unsupported` where its values are not labels
 */
export async function loadLabelFile(
  url: string,
  signal: AbortSignal,
  fetch?: Fetch,
  settings?: LabelPart,
): Promise<LabelFile> {
  if (/\s/.test(url.trim()))
    throw new VolumeViewError('attribute/invalid', 'src of <volume-labels> names several files; expected one.');
  const file = await labelFileOf({ url: url.trim(), ...(settings && { settings }) }, signal, { fetch });
  // Like the unusable parts of a table, this is reported to the author of the page.
  if (file.left)
    console.warn(`<volume-labels>: not all of ${url.trim().slice(0, 200)} is shown.\n${file.left.join('\n')}`);
  return file;
}

/** What of a pyramid of labels is read. */
export type LabelPart = Required<Pick<SourceSettings, 'region' | 'labelDetail'>>;

/** Instead of the browser's own `fetch`, where there is one. */
type Fetch = AttachmentOptions['fetch'];

/** The same for a file with more reading options. @param change - changes its values first */
export async function labelFileOf(
  request: Omit<LoadRequest, 'limits'>,
  signal: AbortSignal,
  { fetch, change = (volume) => volume }: { readonly fetch?: Fetch; readonly change?: (volume: Volume) => Volume } = {},
): Promise<LabelFile> {
  const volume = await loadAttachment({ ...request, limits }, signal, { fetch });
  const { format, anatomical, named, left } = volume;
  // Of a pyramid of labels a coarser level was read; nothing was averaged.
  const isLevel = request.settings?.labelDetail !== undefined && /Zarr/.test(format);
  const labels = isLevel ? { ...volume, reduced: undefined } : volume;
  return { ...labelsIn(change(labels), request.url), format, anatomical, named, left };
}

/** A volume's values as labels. @throws {VolumeViewError} `format/unsupported`, `format/too-large` */
export function labelsIn(volume: Volume, url: string): Pick<LabelFile, 'voxels' | 'found'> {
  const name = url.slice(0, 200);
  if (isPolar(volume))
    throw new VolumeViewError(
      'format/unsupported',
      `${name} is a radar scan; expected labels, a whole number for each voxel of a CT or MRI.`,
    );
  if (volume.reduced)
    throw new VolumeViewError(
      'format/too-large',
      `${name} is too large to hold its labels; expected at most 1 GiB. Make its voxels larger, by the nearest one.`,
    );
  const { grid, samples, slope, intercept, ids, indexed } = volume;
  const voxels: LabelVoxels = { grid, samples, slope, intercept, ids, ...indexed } as LabelVoxels;
  const found: FoundLabels | LabelProblem = volume.rounded
    ? { problem: 'too-large', value: volume.range[1] }
    : findLabels(voxels);
  if (!('problem' in found)) return { voxels, found };
  if (found.problem === 'too-large') {
    throw new VolumeViewError(
      'format/unsupported',
      `${name} has ids that can not be distinguished, up to about ${found.value.toLocaleString('en')}; expected at most 65,536 different ones, up to 9,007,199,254,740,991. Give them new numbers, from 1.`,
    );
  }
  const got = found.problem === 'too-many' ? 'more than 65,536 different values' : `the value ${found.value}`;
  throw new VolumeViewError(
    'format/unsupported',
    `${name} has no labels: it got ${got}; expected whole numbers that stand for things, at most 65,536 of them. A file of intensities is for src of <volume-view>.`,
  );
}

/** Load a table of names and colours. @throws {VolumeViewError} */
export async function loadLabelTable(url: string, signal: AbortSignal, fetch?: Fetch): Promise<LabelTable> {
  const name = url.trim().slice(0, 200);
  let absolute: string;
  try {
    absolute = new URL(url.trim(), Reflect.get(Node.prototype, 'baseURI', document)).href;
  } catch (cause) {
    throw new VolumeViewError('source/not-found', `table got "${name}"; expected a URL`, { cause });
  }
  const { bytes } = await fetchBytes(absolute, {
    signal,
    pageOrigin: origin,
    maxBytes: maxTableBytes,
    onProgress: () => {},
    fetch: fetch && (await loadPart(import('../../worker/serve-fetch.ts'), 'reads files')).checkedFetch(fetch),
  });
  return readLabelTable(bytes, name);
}
