// Where the place of a <volume-note> is.
import { VolumeViewError, invalidAttribute } from '../../core/errors.ts';
import { placeFromEarth } from '../../radar/place-from-earth.ts';
import { stretchOf } from '../../radar/polar-geometry.ts';
import { longest } from '../../volume/grid-limits.ts';
import type { CartesianGrid } from '../../volume/grid.ts';
import { findLargestPart } from '../../volume/largest-part.ts';
import type { ShownLabels } from '../../volume/labels.ts';
import { transformPoint } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';
import { isNumber, parseNumbers, parseWord } from '../model/parse-attributes.ts';

/** From which state on a note is not shown: see `NoteSight`. */
export type NoteHide = 'never' | 'veiled' | 'hidden';

const hides: readonly NoteHide[] = ['never', 'veiled', 'hidden'];

/** What the attributes of a note say about its place. */
export type NotePlace =
  | { readonly kind: 'world'; readonly at: Vector3 }
  | { readonly kind: 'earth'; readonly latitude: number; readonly longitude: number; readonly height: number }
  | { readonly kind: 'label'; readonly id: number };

const owner = ' of <volume-note>';

/** @param text - of the attribute `hide`; null where it is absent @throws {VolumeViewError} `attribute/invalid` */
export function readNoteHide(text: string | null): NoteHide {
  return text?.trim() ? parseWord(`hide${owner}`, text, hides) : 'hidden';
}

/** @param text - returns the text of an attribute, null where it is absent @throws {VolumeViewError} `attribute/invalid` */
export function readNotePlace(text: (name: string) => string | null): NotePlace {
  const given = (name: string): string | null => text(name)?.trim() || null;
  const [position, label, latitude, longitude] = ['position', 'of', 'latitude', 'longitude'].map(given);
  if (position) {
    const at = parseNumbers(`position${owner}`, position, 3) as unknown as Vector3;
    if (Math.max(...at.map(Math.abs)) > longest)
      throw invalidAttribute(`position${owner}`, position, 'a place nearer than 1e12');
    return { kind: 'world', at };
  }
  if (label) {
    if (!/^[+-]?\d{1,15}$/.test(label)) throw invalidAttribute(`of${owner}`, label, 'the number of a label, like "23"');
    return { kind: 'label', id: Number(label) };
  }
  if (latitude || longitude)
    return {
      kind: 'earth',
      latitude: readDegrees('latitude', latitude, 90),
      longitude: readDegrees('longitude', longitude, 360),
      height: readHeight(given('height')),
    };
  throw new VolumeViewError(
    'attribute/invalid',
    '<volume-note> got no place; expected position="x y z", of="the number of a label", or latitude, longitude and height.',
  );
}

function readDegrees(name: string, text: string | null, max: number): number {
  const degrees = text && isNumber(text) ? Number(text) : NaN;
  if (!(Math.abs(degrees) <= max))
    throw invalidAttribute(
      name + owner,
      text ?? '',
      `degrees from -${max} to ${max}, together with ${name === 'latitude' ? 'longitude' : 'latitude'}`,
    );
  return degrees;
}

function readHeight(text: string | null): number {
  const height = text === null ? 0 : isNumber(text) ? Number(text) : NaN;
  if (!(Math.abs(height) <= longest))
    throw invalidAttribute(`height${owner}`, text!, 'metres above the sea, like "2000"');
  return height;
}

/** What a note's place may depend on. */
export interface NotedVolume {
  readonly volume: Volume;
  /** The labels that are shown on it; null where there are none, or not yet. */
  readonly labels: ShownLabels | null;
  /** Whether labels may still come. */
  readonly labelsMayCome: boolean;
}

/**
 * The place in the world as it is drawn: for a radar with the exaggeration of heights.
 * @returns null where it is not known yet
 * @throws {VolumeViewError} `attribute/invalid`
 */
export function locateNote(place: NotePlace, noted: NotedVolume): Vector3 | null {
  const { volume } = noted;
  if (place.kind === 'label') return locateLabel(place.id, noted);
  const [x, y, z] = place.kind === 'world' ? place.at : locateOnEarth(place, volume);
  return [x, y, z * stretchOf(volume.grid)];
}

function locateOnEarth(place: Extract<NotePlace, { kind: 'earth' }>, volume: Volume): Vector3 {
  const site = isPolar(volume) ? volume.radar?.site : undefined;
  if (site?.latitude === undefined || site.longitude === undefined)
    throw new VolumeViewError(
      'attribute/invalid',
      `latitude${owner} got a volume that does not say where on Earth it is; expected the scan of a radar, or position in place of latitude and longitude.`,
    );
  const [east, north] = placeFromEarth({ latitude: site.latitude, longitude: site.longitude }, place);
  return [east, north, place.height - (site.height ?? 0)];
}

function locateLabel(id: number, { volume, labels, labelsMayCome }: NotedVolume): Vector3 | null {
  const { grid } = volume;
  const found = labels ?? (volume.isDiscrete ? 'volume' : null);
  if (!found || grid.kind !== 'cartesian') {
    if (labelsMayCome && grid.kind === 'cartesian') return null;
    throw invalidAttribute(
      `of${owner}`,
      String(id),
      'a label in a volume with labels: add <volume-labels> to the <volume-view>, or give position',
    );
  }
  const numbers = labels ? labels.map.numbers : volume.samples;
  const center = centerOf(numbers, grid, labels ? labels.map.ids.indexOf(id) : numberOf(id, volume));
  if (!center) throw invalidAttribute(`of${owner}`, String(id), 'a label that the volume has');
  return transformPoint(grid.indexToWorld, center);
}

/** The stored sample of a label, where the volume is labels itself. */
function numberOf(id: number, { ids, slope, intercept }: Volume): number {
  return ids ? ids.indexOf(id) : (id - intercept) / slope;
}

/** Centres that were searched, by the labels' numbers: notes are read often, and labels rarely change. */
const centers = new WeakMap<ArrayLike<number> & object, Map<number, Vector3 | null>>();

function centerOf(numbers: ArrayLike<number> & object, grid: CartesianGrid, wanted: number): Vector3 | null {
  const known = centers.get(numbers) ?? new Map<number, Vector3 | null>();
  centers.set(numbers, known);
  if (!known.has(wanted)) known.set(wanted, findLargestPart(numbers, grid, wanted)?.center ?? null);
  return known.get(wanted)!;
}
