import type { MomentKind, RadarMoment } from './radar-file.ts';

/** What files say about a quantity; what they do not say is absent. */
export interface MomentNames {
  /** The file's name of it: 'DBZH', 'REF', 'corrected_velocity', … */
  readonly name: string;
  /** CF's name, such as 'equivalent_reflectivity_factor'. */
  readonly standardName?: string;
  readonly unit?: string;
}

/**
 * CF's names. Sources: CF standard names, CfRadial 1.4 (chapter 6), CfRadial 2.1 (chapter 7). The first match counts,
 * so the specific ones come first.
 */
const kindsByStandardName: readonly (readonly [RegExp, MomentKind])[] = [
  [/specific_differential_phase/, 'other'],
  [/differential_reflectivity/, 'differential-reflectivity'],
  [/differential_phase/, 'differential-phase'],
  [/cross_correlation|correlation_ratio/, 'correlation'],
  [/spectrum_width/, 'spectrum-width'],
  [/radial_velocity/, 'velocity'],
  [/reflectivity_factor/, 'reflectivity'],
];

/**
 * Names of ODIM_H5 (table 16), NEXRAD Level II (ICD 2620002, table XVII-B), and those that Py-ART, LROSE and others
 * write into CfRadial. Compared in lower case.
 */
const kindsByName: readonly (readonly [RegExp, MomentKind])[] = [
  [/^class$/, 'kinds'],
  [/texture|variance|deviation|error|mask|flag/, 'other'],
  [/^u?zdr|differential_reflectivity/, 'differential-reflectivity'],
  [/^u?kdp|specific_differential_phase/, 'other'],
  [/^u?phi(dp)?|differential_phase/, 'differential-phase'],
  [/^u?rho(hv)?|cross_correlation|correlation_coefficient/, 'correlation'],
  [/^u?wrad|^sw\d?$|^width|spectr(um|al)_width/, 'spectrum-width'],
  [/^u?vrad|^vel|^v[rehv]?$|velocity/, 'velocity'],
  [/^u?dbz|^u?t[hvx]$|^ref$|^zh?h?$|^cz$|reflectivity/, 'reflectivity'],
];

/** The kind of a quantity: by CF's name, else by the file's, unless the unit contradicts it. */
export function momentKindOf({ name, standardName = '', unit = '' }: MomentNames): MomentKind {
  const lower = name.toLowerCase();
  const found =
    kindsByStandardName.find(([pattern]) => pattern.test(standardName.toLowerCase())) ??
    kindsByName.find(([pattern]) => pattern.test(lower));
  const kind = found?.[1] ?? 'other';
  const expected = unitsOfKind[kind];
  const shown = normaliseUnit(unit);
  return expected && shown !== '' && shown !== expected ? 'other' : kind;
}

/**
 * Names of velocities that have been unfolded already. Sources: ODIM_H5 2.3 (VRADDH, VRADDV), Py-ART's default field
 * names (corrected_velocity), and words that others use for it.
 */
const unfoldedNames = /^u?vradd[hv]?$|^(corrected|dealiased|unfolded|unwrapped)_|(dealias|unfold|unwrap)/i;

/** Whether a moment wraps around at the Nyquist velocity. */
export function isFolding({ name, kind }: RadarMoment): boolean {
  return kind === 'velocity' && !unfoldedNames.test(name);
}

/** How a value between two gates follows from theirs. */
export type Mixing = 'linear' | 'unless-folded' | 'nearest';

export function mixingOf(moment: RadarMoment): Mixing {
  if (moment.kind === 'kinds') return 'nearest';
  return isFolding(moment) ? 'unless-folded' : 'linear';
}

const unitsOfKind: Readonly<Partial<Record<MomentKind, string>>> = {
  reflectivity: 'dBZ',
  velocity: 'm/s',
  'spectrum-width': 'm/s',
};

const units: readonly (readonly [RegExp, string])[] = [
  [/^dbz$/i, 'dBZ'],
  [/^db$/i, 'dB'],
  [/^(m\/s|m\.?\s?s\*{0,2}\^?-1|m(et(er|re))?s?[ _]?per[ _]?s(ec(ond)?)?)$/i, 'm/s'],
  [/^(deg(ree)?s?|°)$/i, 'degrees'],
  [/^deg(ree)?s?([ _]?per[ _]?|\/|\s)(km|kilomet(er|re))(-1)?$/i, 'degrees/km'],
  [/^(unit_?less|dimensionless|ratio|none|1|-)?$/i, ''],
];

/** A unit in one spelling: 'm/s' for 'meters_per_second'; '' for none; unchanged if it is unknown here. */
export function normaliseUnit(unit: string): string {
  const trimmed = unit.trim();
  return units.find(([pattern]) => pattern.test(trimmed))?.[1] ?? trimmed;
}
