import { axialIndexToWorld, cartesianGrid } from '../../volume/grid.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { countSampleBytes } from '../base/count-sample-bytes.ts';
import type { DecodedCartesianVolume } from '../base/decoded-volume.ts';
import { corruptFile } from '../base/file-problem.ts';
import type { FormatReader, ReadContext } from '../base/format.ts';
import { listLeft } from '../base/list-left.ts';
import { nameOf } from '../base/name-of.ts';
import { hostIsLittleEndian } from '../base/number-types.ts';
import { placeVolume } from '../base/place-volume.ts';
import { storeSamples, wholeNumbersOf } from '../base/store-samples.ts';
import { gunzipAll } from '../codecs/gunzip-all.ts';
import { isGzip } from '../codecs/gunzip.ts';
import { countKept, describeKept } from '../series/keep-volumes.ts';
import { openSeries } from '../series/open-series.ts';
import { timeText } from '../series/scan-times.ts';
import { allocateColors, decodePage, pageBytes, whiteOf } from './decode-page.ts';
import { checkLike, joinParts, joinScales, plain } from './join-files.ts';
import { openTiff } from './open-tiff.ts';
import type { TiffStack } from './open-tiff.ts';
import { what } from './tiff-file.ts';

/**
 * Reads the pages of a file as the slices of a volume; of several files of a stack, the pages of all of them. The first channel is shown.
 * Several times are scans.
 */
export const readTiff: FormatReader = async (input, settings, context) => {
  const { budget } = context;
  const open = async (bytes: Uint8Array<ArrayBuffer>): Promise<TiffStack> =>
    openTiff(isGzip(bytes) ? await gunzipAll(bytes, budget, what) : bytes, budget);
  const stack = await open(input.bytes);
  if (stack.layout.times > 1 && context.further.length === 0 && settings.scan && !context.isPart)
    return placeVolume(await openTimes(stack, settings, context), settings);
  const stacks = [stack];
  const parts = [decodeTime(stack, 0, context, true)];
  for await (const { bytes, url } of context.fetchFiles(context.further)) {
    const next = await open(bytes);
    checkLike(stack, next, nameOf(url));
    stacks.push(next);
    parts.push(decodeTime(next, 0, context, true));
    next.use.left.forEach((one) => stack.use.left.add(one));
  }
  const { type, scale, window, prepare } = joinScales(stacks, budget);
  const bytes = joinParts(
    parts.map((part, i) => prepare(stacks[i], part.bytes)),
    budget,
  );
  const colors = parts.flatMap(({ rgb }) => rgb ?? []);
  const stored = storeSamples(bytes, type, hostIsLittleEndian, {
    slope: 1,
    intercept: 0,
    budget,
    chooseWhole: await wholeNumbersOf(type),
  });
  const slices = stacks.reduce((sum, { layout }) => sum + layout.slices, 0);
  const { times } = stack.layout;
  const { slope, intercept } = scale ?? plain;
  return placeVolume(
    {
      ...describe({ ...stack, layout: { ...stack.layout, scale, window } }, slices),
      ...listLeft(times, ...listOmitted(stack)),
      samples: stored.samples,
      slope: slope * stored.scale,
      intercept: slope * stored.offset + intercept,
      indexed: stored.indexed,
      rounded: stored.rounded,
      unkept: stored.unkept,
      ...(colors.length === parts.length && {
        colors: { rgb: joinParts(colors, budget), range: [0, whiteOf(stack.page)] },
      }),
    },
    settings,
  );
};

type Described = Pick<DecodedCartesianVolume, 'grid' | 'unit' | 'format' | 'window'>;

function describe({ layout, page }: TiffStack, slices: number): Described {
  const { format, times, spacing, window, scale } = layout;
  const dimensions: Vector3 = [page.columns, page.rows, slices];
  return {
    grid: cartesianGrid(dimensions, axialIndexToWorld(dimensions, spacing ?? [1, 1, 1])),
    unit: scale?.unit ?? '',
    format: `${format}${times > 1 ? `, volume 1 of ${times}` : ''}`,
    ...(window ? { window: [...window] as [number, number] } : {}),
  };
}

function listOmitted({ layout, use, page }: TiffStack): (string | null)[] {
  return [
    ...layout.left,
    ...use.left,
    page.type.complex ? 'the phase of complex numbers, whose magnitudes are shown' : null,
  ];
}

/** Steps for each slice, in addition to those of its pixels. */
const stepsPerSlice = 64;

/** The numbers of all slices of a time, and their red, green and blue. */
interface TimeNumbers {
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly rgb?: Uint8Array<ArrayBuffer>;
}

/** All slices of a time; those that the file does not have are an error. The bytes stay taken from the budget. */
function decodeTime(
  stack: TiffStack,
  time: number,
  { budget, onProgress }: ReadContext,
  keepsColors = false,
): TimeNumbers {
  const { file, pages, layout, page, readPageAt, use } = stack;
  const size = pageBytes(page);
  const all = countSampleBytes(what, [page.columns, page.rows, layout.slices], page.type);
  budget.step(layout.slices * stepsPerSlice, 'the slices of the TIFF file');
  let missing = 0;
  const absent = layout.mayLack ? -1 : pages;
  for (; missing < layout.slices; missing++) if ((layout.pageOf(missing, time) ?? absent) >= pages) break;
  if (missing < layout.slices)
    throw corruptFile(
      what,
      `has ${pages.toLocaleString('en')} pages, and none for slice ${missing + 1} of ${layout.slices.toLocaleString('en')}; the file is cut short, or its description is that of another one`,
    );
  budget.take(all, what);
  const bytes = new Uint8Array(all);
  const pixels = page.columns * page.rows;
  const rgb = keepsColors ? allocateColors(stack, layout.slices) : undefined;
  for (let k = 0; k < layout.slices; k++) {
    onProgress(k, layout.slices);
    const at = layout.pageOf(k, time);
    if (at === null) continue;
    const to = {
      numbers: bytes.subarray(k * size, (k + 1) * size),
      rgb: rgb?.subarray(3 * k * pixels, 3 * (k + 1) * pixels),
    };
    decodePage(file, readPageAt(at), to, use);
  }
  return { bytes, rgb };
}

/** Several times: each is unpacked once, and kept by the browser. */
async function openTimes(
  stack: TiffStack,
  settings: Parameters<FormatReader>[1],
  context: ReadContext,
): Promise<DecodedCartesianVolume> {
  const { layout, page } = stack;
  const { budget } = context;
  const bytes = pageBytes(page) * layout.slices;
  const kept = countKept({ bytes, count: layout.times }, budget);
  const volumes: Blob[] = [];
  for (let time = 0; time < kept; time++) {
    volumes.push(new Blob([decodeTime(stack, time, context).bytes]));
  }
  const left = listLeft(1, describeKept(kept, layout.times), ...listOmitted(stack));
  return openSeries(
    {
      info: { ...describe({ ...stack, layout: { ...layout, times: 1 } }, layout.slices), ...left },
      volumes,
      count: layout.times,
      type: page.type.name,
      littleEndian: hostIsLittleEndian,
      scaleOf: () => layout.scale ?? plain,
      timeOf: (index) => (layout.timeStep === null ? null : timeText(index * layout.timeStep, 's')),
    },
    settings,
    context,
  );
}
