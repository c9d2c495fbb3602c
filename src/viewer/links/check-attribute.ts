import { parseWord, parseNumbers } from '../model/parse-attributes.ts';
import { plainAppearance } from '../model/plain-appearance.ts';
import { readSettings } from '../model/settings.ts';
import type { GivenAttributes } from '../model/settings.ts';
import type { ScanModel } from '../model/scan-model.ts';
import { resolveAppearance } from '../appearance/resolve-appearance.ts';
import type { Aspect } from '../model/error-state.ts';

/** The readings of the settings that a link can change, and the name under which a view shows their errors. */
const readings = { time: 'time', look: 'optics', camera: 'camera', region: 'region', rings: 'rings' } as const;

/** The error of an attribute, and what it is about. */
export interface AttributeProblem {
  readonly aspect: Aspect;
  readonly error: unknown;
}

/** Stands for a volume that has not been loaded: a CT, for which all looks are known. */
const anyVolume = {
  unit: 'HU',
  isDiscrete: false,
  grid: { kind: 'cartesian' },
  range: [0, 1],
  window: [0, 1],
  referenceLength: 1,
  histogram: { low: 0, high: 1, counts: new Float64Array(4) },
} as unknown as ScanModel;

/**
 * Read the text of one attribute as the view does, before the view has it: so a bad text of a link does not replace a good one of the tag.
 * @param volume - of the view; null where it is not known yet
 * @returns null where the text can be read
 */
export async function checkAttribute(
  name: string,
  text: string,
  volume: ScanModel | null,
): Promise<AttributeProblem | null> {
  const property = name.replace(/-(\w)/g, (_, letter: string) => letter.toUpperCase());
  const given = new Proxy({}, { get: (_, key) => (key === property ? text : null) }) as GivenAttributes;
  const settings = readSettings(given);
  for (const [reading, aspect] of Object.entries(readings) as [keyof typeof readings, Aspect][]) {
    const { error } = settings[reading];
    if (error) return { aspect, error };
  }
  try {
    if (name === 'cutout' && text.trim() !== '') parseNumbers(name, text, 6);
    if (name === 'cursor' && text.trim() !== '') parseNumbers(name, text, 3);
    if (name === 'crosshair' && text.trim() !== '') parseWord(name, text, ['auto', 'none']);
  } catch (error) {
    return { aspect: 'slices', error };
  }
  try {
    const look = { ...plainAppearance, ...settings.look.value };
    // Which windows a file has is known when it is there.
    const window = !volume && typeof look.window === 'string' ? null : look.window;
    await resolveAppearance({ ...look, window }, volume ?? anyVolume);
    return null;
  } catch (error) {
    return { aspect: 'optics', error };
  }
}
