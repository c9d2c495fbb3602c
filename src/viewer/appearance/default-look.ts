// The appearance of a scan whose page asks for nothing: lit, because an unlit scan looks like wax.
import { isPolar } from '../../volume/volume.ts';
import type { ScanModel } from '../model/scan-model.ts';
import type { AppearanceSettings } from '../model/settings.ts';

/** How many times as dense a lit scan is drawn: light shows a surface only where little shines through from behind. */
const litFactors = { intensity: 6, ct: 3 };

/**
 * What the values of a scan of matter are. `intensity`: values without a known scale, as in MRI. null: labels, masks, and values whose
 * colours people read as numbers, as in a radar scan, a map of statistics or PET. Light would change what those colours mean.
 */
export function scanKindOf({
  transferFunction,
  unit,
  isDiscrete,
  grid,
}: Pick<ScanModel, 'transferFunction' | 'unit' | 'isDiscrete' | 'grid'>): keyof typeof litFactors | null {
  if (isDiscrete || isPolar({ grid })) return null;
  if (transferFunction) return typeof transferFunction === 'string' && transferFunction.startsWith('ct-') ? 'ct' : null;
  return unit === 'HU' ? 'ct' : unit === '' ? 'intensity' : null;
}

/** The settings of a lit scan of one kind; the colours are those that the data choose. */
export function litLook(kind: keyof typeof litFactors): Pick<AppearanceSettings, 'opacityFactor' | 'shading'> {
  return { opacityFactor: litFactors[kind], shading: 'lit' };
}

/** Whether the settings leave the appearance open. */
function isOpen(said: AppearanceSettings): boolean {
  const { window: _window, referenceLength: _length, lightFactor: _light, ...rest } = said;
  return Object.values(rest).every((value) => value === null);
}

/** Whether a volume with these settings is lit, or is if it is a scan of matter. */
export const mayBeLit = (said: AppearanceSettings): boolean => said.shading === 'lit' || isOpen(said);

/**
 * The author's settings; where they leave the appearance open, completed by that of a lit scan. Window and reference length don't
 * decide it: people change the window while they look.
 */
export function withDefaultLook(said: AppearanceSettings, volume: ScanModel): AppearanceSettings {
  const kind = isOpen(said) && scanKindOf(volume);
  return kind ? { ...said, ...litLook(kind) } : said;
}

/** Children of a view that are seen in or on its scan: a lit scan is so dense that it would hide them. */
const inScan = 'volume-labels, volume-layer, volume-surface, volume-terrain, shape';

/** Whether a view shows something else in its scan. */
export function showsMore(host: Element): boolean {
  return host.querySelector(inScan) !== null;
}
