// The windows that a file has for its values: from black to white.
import type { ValueWindow } from '../../volume/volume.ts';
import type { DataSet } from './data-set.ts';
import type { RealWorld } from './real-world.ts';
import { sequences, tags } from './tags.ts';

export interface FileWindows {
  /** In the order of the file; several may be alike. */
  readonly windows: readonly ValueWindow[];
  /** What of them is shown in another way than the file says, in words. */
  readonly left: readonly string[];
}

/** How the numbers of a window become those of the volume: `factor * x`, or `mirror - factor * x` where dark and bright are turned. */
export interface WindowScale {
  readonly factor: number;
  readonly mirror: number | null;
  /** How stored numbers, which the window is for, become values; null where the window is for values. */
  readonly real: Pick<RealWorld, 'slope' | 'intercept'> | null;
  /** Whether values may be below 0. */
  readonly isNegative: boolean;
}

/** Files in use have up to four. */
const maxWindows = 16;

/**
 * Names that say which part of the body, or what kind of picture, a window is for. The file's own names are texts of people, who may write
 * anything there: so none of them is shown, only the word of this list that it stands for.
 */
const knownNames: readonly (readonly [name: string, written: RegExp])[] = [
  ['abdomen', /^abd(omen|ominal)?$/],
  ['bone', /^bones?$/],
  ['brain', /^(brain|cerebrum)$/],
  ['chest', /^(chest|thorax)$/],
  ['head', /^(head|skull)$/],
  ['liver', /^(liver|hepatic)$/],
  ['lung', /^lungs?$/],
  ['mediastinum', /^mediastin(um|al)$/],
  ['neck', /^neck$/],
  ['pelvis', /^pelvi[sc]$/],
  ['soft tissue', /^soft ?tissues?$/],
  ['spine', /^(c |l |t )?spine$/],
  ['vessels', /^(vessels?|angio(graphy)?|cta)$/],
  ['normal', /^normal$/],
  ['harder', /^harder$/],
  ['softer', /^softer$/],
];

/** The word for a name of a file, or its number. @param number - from 1 */
function nameOf(written: string, number: number): string {
  const plain = written
    .slice(0, 64)
    .toLowerCase()
    .replace(/[^a-z]+/g, ' ')
    .replace(/\b(ct|window)\b/g, '')
    .trim();
  return knownNames.find(([, known]) => known.test(plain))?.[0] ?? `Window ${number}`;
}

/** Width below which a window is a threshold, as a share of its place. */
const narrow = 2 ** -20;

/**
 * The windows of a picture.
 * @param set - has the centres and widths: the file, or the group of a frame
 * @param file - has the tables
 * Source: PS3.3, C.11.2
 */
export function readWindows(set: DataSet, file: DataSet, scale: WindowScale): FileWindows {
  const [centers, widths] = [set.numbers(tags.windowCenter), set.numbers(tags.windowWidth)];
  const given = set.text(tags.windowFunction).toUpperCase();
  const explanations = set.texts(tags.windowExplanation);
  const stated = centers.map((center, i) => ({
    ...endsOf(center, widths[i], given !== 'LINEAR_EXACT' && given !== 'SIGMOID'),
    written: explanations[i] ?? '',
    isTable: false,
  }));
  const tables = file.items(sequences.windowTables).map((table) => ({
    ...spanOf(table, scale.isNegative),
    written: table.text(tags.tableExplanation),
    isTable: true,
  }));
  const usable = [...stated, ...tables]
    .map((one) => ({ ...one, ...scaleWindow(one, scale) }))
    .filter(({ from, to, level }) => Number.isFinite(to - from) && Number.isFinite(level) && to > from);
  const read = usable.slice(0, maxWindows);
  const windows = read.map(({ written, isTable: _isTable, ...window }, i) => ({
    name: nameOf(written, i + 1),
    ...window,
  }));
  const hasTables = read.some(({ isTable }) => isTable);
  const isCurve = given === 'SIGMOID' && !read.every(({ isTable }) => isTable);
  return {
    windows,
    left: [
      ...(isCurve ? ['windows with a curve from black to white (SIGMOID): a straight line is used'] : []),
      ...(hasTables ? ['tables from values to greys (VOI LUT): a straight line over the same values is used'] : []),
      ...(usable.length > maxWindows
        ? [`${(usable.length - maxWindows).toLocaleString('en')} windows after the first ${maxWindows}`]
        : []),
    ],
  };
}

type Ends = Omit<ValueWindow, 'name'>;

/**
 * Black and white. `LINEAR`, which counts where a file names no function, has white one value lower, as it is made for whole numbers; below
 * a width of 1, which it may not have, it can only be meant exactly. Source: PS3.3, C.11.2.1.2.1 and C.11.2.1.3.2
 */
function endsOf(level: number, width: number | undefined, isLinear: boolean): Ends {
  if (!(width !== undefined && width > 0)) return { from: NaN, to: NaN, width: NaN, level };
  const from = level - width / 2;
  const ramp = isLinear && width >= 1 ? width - 1 : width;
  return { from, to: from + Math.max(ramp, narrow * Math.max(1, Math.abs(from))), width, level };
}

/** The values between which a table changes. Source: PS3.3, C.11.1.1.1 and C.11.2.1.1 */
function spanOf(table: DataSet, isNegative: boolean): Ends {
  const [entries, start] = table.numbers(tags.tableDescriptor);
  const count = entries === 0 ? 2 ** 16 : entries;
  // Many writers store a negative value as if it had no sign.
  const first = isNegative && start >= 2 ** 15 ? start - 2 ** 16 : start;
  const greys = table.numbers(tags.tableData);
  let [begin, end] = [0, count - 1];
  // Tables of bytes may be packed in several ways: of those the whole span is taken.
  if (greys.length === count) {
    while (begin < end && greys[begin + 1] === greys[0]) begin++;
    while (end > begin && greys[end - 1] === greys[count - 1]) end--;
  }
  const [from, to] = [first + begin, first + end];
  return { from, to, width: to - from, level: (from + to) / 2 };
}

function scaleWindow({ from, to, width, level }: Ends, { factor, mirror, real }: WindowScale): Ends {
  const { slope, intercept } = real ?? { slope: 1, intercept: 0 };
  const scaled = [from, to, level]
    .map((number) => factor * (slope * number + intercept))
    .map((value) => (mirror === null ? value : mirror - value));
  return {
    from: Math.min(scaled[0], scaled[1]),
    to: Math.max(scaled[0], scaled[1]),
    width: factor * Math.abs(slope) * width,
    level: scaled[2],
  };
}
