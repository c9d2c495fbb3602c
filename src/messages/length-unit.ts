// The unit in which a length is written: 10 µm, not 0.01 mm.

/** A unit of length, and how many of it are one millimetre. */
export interface LengthUnit {
  readonly unit: 'mm' | 'µm' | 'nm';
  readonly perMillimetre: number;
}

/** What writes lengths, with their units, in a language. */
export type LengthMessages = Readonly<
  Record<'millimetres' | 'micrometres' | 'nanometres', (lengths: string) => string>
>;

const units = [
  { unit: 'mm', perMillimetre: 1 },
  { unit: 'µm', perMillimetre: 1e3 },
  { unit: 'nm', perMillimetre: 1e6 },
] as const;

/** In volumes from this size on, mm, lengths are in millimetres as long as that takes one decimal: the thickness of a CT's slice is 0.7 mm. */
const coarse = 10;

/** Errors of a float: a length of 1 µm may be 0.00099999999 mm. */
const nearly = 1 - 1e-6;

/** The unit for one length, mm. @param extent - the largest side of the volume, mm */
export function unitOfLength(length: number, extent: number): LengthUnit {
  if (!(length > 0)) return unitOfPlaces(extent);
  if (length >= nearly * (extent >= coarse ? 0.1 : 1)) return units[0];
  return length >= nearly * 1e-3 ? units[1] : units[2];
}

/** The unit for all places of a volume, which does not change from place to place. @param extent - the largest side of the volume, mm */
export function unitOfPlaces(extent: number): LengthUnit {
  return extent > 0 && extent < nearly ? units[extent < nearly * 1e-3 ? 2 : 1] : units[0];
}

/** The unit for a box or a sphere of this many mm³: from a tenth of a unit along each side on. */
export function unitOfVolume(volume: number): LengthUnit {
  const [millimetres, micrometres, nanometres] = units;
  if (!(volume > 0) || volume >= nearly * 1e-3) return millimetres;
  return volume >= nearly * 1e-12 ? micrometres : nanometres;
}

/** The largest side of a volume. @param spacing - world units from voxel to voxel */
export function extentOf({
  dimensions,
  spacing,
}: {
  readonly dimensions: readonly number[];
  readonly spacing: readonly number[];
}): number {
  return Math.max(...dimensions.map((count, axis) => count * spacing[axis]));
}

/** Lengths as text, with their unit. */
export function nameLengths(text: string, { unit }: LengthUnit, messages: LengthMessages): string {
  const { millimetres, micrometres, nanometres } = messages;
  return { mm: millimetres, µm: micrometres, nm: nanometres }[unit](text);
}
