// Ready-made appearances with one-word names: loaded with the first page that names one.
import { invalidAttribute } from '../../core/errors.ts';
import { colorSliceStops, ctSliceStops, isGraySlice, sliceStops } from '../../volume/slice-stops.ts';
import { otsuBin } from '../../optics/transfer/window.ts';
import { isPolar } from '../../volume/volume.ts';
import type { ScanModel } from '../model/scan-model.ts';
import type { AppearanceSettings } from '../model/settings.ts';
import { litLook, scanKindOf } from './default-look.ts';

/** The settings behind a name. Stops and factor belong together: where an author writes stops, the factor is not used. */
type NamedLook = Partial<
  Pick<ResolvedSettings, 'transferFunction' | 'window' | 'opacityFactor' | 'projection' | 'shading'>
>;

/** Settings whose window is in numbers. */
export type ResolvedSettings = Omit<AppearanceSettings, 'window'> & {
  readonly window: readonly [number, number] | null;
};

/**
 * What the values mean, as far as an appearance depends on it. `intensity`: values without a known scale, as in MRI. `scale`: each
 * colour stands for a value that people read from it, as in a radar scan, a map of statistics, or PET, or where the file says so;
 * light would change what a colour means. `mask`: two values. `things`: labels.
 */
type Kind = 'ct' | 'intensity' | 'mask' | 'scale' | 'things';

/**
 * The names that suit each kind of data, in the order in which messages list them. A mean of values of both signs, or of a scale,
 * is no X-ray; and between the numbers of two labels there is no value that a ray could show.
 */
const words = {
  things: ['textbook', 'flat'],
  scale: ['textbook', 'flat', 'mip'],
  mask: ['textbook', 'flat', 'mip'],
  intensity: ['textbook', 'flat', 'mip', 'xray', 'skin'],
  ct: ['textbook', 'flat', 'mip', 'xray', 'skin', 'bone', 'vessels'],
} as const satisfies Record<Kind, readonly string[]>;

type Word = (typeof words)['ct'][number];

/** Opaque enough that light shows how a surface is inclined, and that nothing behind it shines through. */
const looks: Readonly<Record<'ct' | 'intensity', Partial<Record<Word, (volume: ScanModel) => NamedLook>>>> = {
  ct: {
    textbook: () => bone,
    bone: () => bone,
    skin: () => ({ transferFunction: '-400 #c98f73 0, -250 #d9a489 60%, 200 #f0c8a8 90%', shading: 'lit' }),
    vessels: () => ({ transferFunction: 'ct-angio', opacityFactor: 3, shading: 'lit' }),
    mip: (volume) => ({ transferFunction: 'gray', window: windowOfMaxima(volume, -100), projection: 'max' }),
  },
  intensity: {
    textbook: () => litLook('intensity'),
    skin: () => ({
      transferFunction: '0% #b47a60 0, 12% #c98f73 60%, 60% #e3b498 90%, 100% #f6dcc6 95%',
      shading: 'lit',
    }),
    mip: (volume) => ({
      transferFunction: 'gray',
      window: windowOfMaxima(volume, volume.window?.[0] ?? volume.range[0]),
      projection: 'max',
    }),
  },
};

const bone: NamedLook = { transferFunction: 'ct-bone', ...litLook('ct') };

/**
 * The author's settings, completed by those of the named appearance.
 * @throws {VolumeViewError} `attribute/invalid`
 */
export function applyNamedLook(settings: ResolvedSettings, text: string, volume: ScanModel): ResolvedSettings {
  const kind = kindOf(volume);
  const word = text.trim().toLowerCase();
  const known: readonly string[] = words[kind];
  if (!known.includes(word)) throw invalidAttribute('look', text, `${known.join(', ')}${explain(word)}`);
  const said = appearanceOf(word as Word, kind, volume);
  const hasStops = settings.transferFunction !== null;
  return {
    ...settings,
    transferFunction: settings.transferFunction ?? said.transferFunction ?? null,
    window: settings.window ?? said.window ?? null,
    opacityFactor: settings.opacityFactor ?? (hasStops ? null : (said.opacityFactor ?? null)),
    projection: settings.projection ?? said.projection ?? null,
    shading: settings.shading ?? said.shading ?? null,
  };
}

function appearanceOf(word: Word, kind: Kind, volume: ScanModel): NamedLook {
  // Light would change the grays of a picture.
  if (word === 'flat' || (word === 'textbook' && isPicture(volume))) return {};
  if (word === 'xray') return { transferFunction: 'gray', window: windowOfMeans(volume), projection: 'average' };
  if (kind === 'ct' || kind === 'intensity') return looks[kind][word]!(volume);
  // The white of a slice in colours is the same for all brightnesses, and a projection has no colours.
  if (word === 'mip' && volume.transferFunction === colorSliceStops)
    return { transferFunction: sliceStops, projection: 'max' };
  if (word === 'mip') return { projection: 'max' };
  return kind === 'mask' ? { opacityFactor: 3, shading: 'lit' } : {};
}

/** Why an existing name does not suit these data. */
function explain(word: string): string {
  const others: readonly string[] = words.ct;
  if (!others.includes(word)) return '';
  const scans: readonly string[] = words.intensity;
  return `; "${word}" is for ${!scans.includes(word) ? 'CT, in Hounsfield units' : word === 'mip' ? 'data that are no labels' : 'CT and MRI'}`;
}

const isPicture = ({ transferFunction }: ScanModel): boolean =>
  typeof transferFunction === 'string' && isGraySlice(transferFunction);

function kindOf(volume: ScanModel): Kind {
  const { transferFunction } = volume;
  const ofValues = transferFunction === ctSliceStops ? 'ct-bone' : undefined;
  const scan = scanKindOf(isPicture(volume) ? { ...volume, transferFunction: ofValues } : volume);
  if (scan) return scan;
  if (volume.isDiscrete) return 'things';
  const isMask = volume.transferFunction && !isPolar(volume);
  return isMask && volume.histogram.counts.filter(Boolean).length === 2 ? 'mask' : 'scale';
}

/** The mean of rays through the middle of the scanned object, above air, as a share of the mean of tissue: they also cross some air. */
const middleRays = 0.8;

/**
 * From air, which in a CT has a value of its own, to the mean of rays through the middle. A scanner writes values below air where
 * it has not scanned.
 */
function windowOfMeans(volume: ScanModel): readonly [number, number] {
  const { low, high, counts } = volume.histogram;
  const from = kindOf(volume) === 'ct' ? Math.max(low, -1000) : low;
  // What was not scanned is neither air nor tissue.
  const air = Math.min(
    counts.length - 1,
    Math.floor((counts.length * (from - low)) / Math.max(high - low, Number.MIN_VALUE)),
  );
  const first = air + otsuBin(counts.subarray(air));
  let [sum, total] = [0, 0];
  counts.subarray(first).forEach((count, bin) => {
    sum += count * (first + bin + 0.5);
    total += count;
  });
  const tissue = low + ((high - low) * sum) / (counts.length * Math.max(1, total));
  const to = from + middleRays * (tissue - from);
  return to > from ? [from, to] : volume.range;
}

/**
 * The share of voxels that are brighter than white in a projection of the largest values. It is small, because each ray may meet
 * some of them.
 */
const beyondWhite = 0.001;

/** From where tissue begins to where nearly all values end. */
function windowOfMaxima(
  { histogram: { low, high, counts }, range }: ScanModel,
  from: number,
): readonly [number, number] {
  let left = beyondWhite * counts.reduce((sum, count) => sum + count, 0);
  let bin = counts.length;
  while (bin > 0 && left >= counts[bin - 1]) left -= counts[--bin];
  const to = low + ((high - low) * bin) / counts.length;
  return to > from ? [from, to] : range;
}
