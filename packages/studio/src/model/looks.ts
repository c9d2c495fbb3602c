// The looks that an author chooses from, as attributes of a view.
import { lookAttributes } from './lesson.ts';
import type { ViewAttributes } from './lesson.ts';

export interface Look {
  readonly name: string;
  readonly attributes: ViewAttributes;
}

/** What of the data decides which looks suit. */
export interface LookData {
  readonly unit: string;
  /** Smallest and largest value. */
  readonly range: readonly [number, number];
  readonly isRadar: boolean;
}

/** Air is at -1000 HU; not all files of CT say their unit. */
const isCt = ({ unit, range: [low] }: LookData): boolean =>
  unit === 'HU' || (unit === '' && low <= -900 && low >= -4096);

const words = ['textbook', 'flat', 'skin', 'xray', 'mip'] as const;
const wordsOfCt = ['textbook', 'flat', 'skin', 'bone', 'vessels', 'xray', 'mip'] as const;
const wordsOfRadar = ['flat', 'mip'] as const;
const ofCt = ['ct-bone', 'ct-soft-tissue', 'ct-angio', 'ct-lung'] as const;
const ofRadar = ['radar-dbz', 'radar-velocity'] as const;
const tables = ['gray', 'viridis', 'inferno', 'magma', 'plasma', 'cividis', 'turbo'] as const;

/** In the order in which they are shown. A word that does not suit the data is an error of the view: then there is no picture of it. */
export function looksFor(data: LookData): readonly Look[] {
  const { isRadar, range } = data;
  const ct = isCt(data);
  const hasSigns = !ct && !isRadar && range[0] < 0 && range[1] > 0;
  const presets = [
    ...(ct ? ofCt : []),
    ...(isRadar ? ofRadar : []),
    ...tables,
    ...(hasSigns ? (['diverging'] as const) : []),
  ];
  return [
    { name: 'auto', attributes: {} },
    ...(isRadar ? wordsOfRadar : ct ? wordsOfCt : words).map((word) => ({
      name: word,
      attributes: { look: word },
    })),
    ...presets.map((preset) => ({ name: preset, attributes: { 'transfer-function': preset } })),
  ];
}

/** Attributes that take away all of a look, and set another one. */
export function changesFor(look: Look): Record<string, string | null> {
  return { ...Object.fromEntries(lookAttributes.map((name) => [name, null])), ...look.attributes };
}

/** Whether a view has a look, whatever light and density it has in addition. */
export function hasLook(view: ViewAttributes, { attributes }: Look): boolean {
  return ['look', 'transfer-function'].every((name) => view[name] === attributes[name]);
}
