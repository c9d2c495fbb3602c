import type * as GroundMaps from '../../radar/ground-map.ts';
import type { GroundMap } from '../../radar/ground-map.ts';
import type { EarthPoint } from '../../radar/place-on-earth.ts';
import { stretchOf } from '../../radar/polar-geometry.ts';
import { buildRings, buildSpokes, maxRings, planRings, ringsFit } from '../../radar/range-rings.ts';
import type { Rings } from '../../radar/range-rings.ts';
import type { GridFrame } from '../../volume/grid.ts';
import type { Volume } from '../../volume/volume.ts';
import { invalid } from '../model/parse-attributes.ts';
import type { RingSetting } from '../model/parse-attributes.ts';
import { RingLabels } from './ring-labels.ts';
import type { RingWriter, ScanFacts } from './ring-labels.ts';

/** Rings, the map below them, and the code for their labels, which is loaded with them. */
export interface LabelledRings extends Rings {
  /** Coasts and borders; absent until they have been loaded, and where the place of the radar is not known. */
  readonly map?: GroundMap;
  /** Facts about the scan that people need to read the picture. */
  readonly facts: ScanFacts;
  labelsAfter(picture: Element, write: RingWriter): RingLabels;
}

/** The place of a radar; null where its file does not give one. */
export function placeOfRadar({ radar }: Pick<Volume, 'radar'>): EarthPoint | null {
  const { latitude, longitude } = radar?.site ?? {};
  return latitude !== undefined && longitude !== undefined ? { latitude, longitude } : null;
}

/**
 * The rings that an author requests.
 * @param kilometres - from ring to ring; auto: round distances; null: round distances and a ground, for a radar
 * @param region - the visible part of the volume, if not all: the rings are cut to it
 * @param maps - the code that makes the map below them, once it has been loaded
 * @throws {VolumeViewError} `attribute/invalid`
 */
export function readRings(
  kilometres: RingSetting | null,
  volume: Pick<Volume, 'grid' | 'radar'>,
  region: GridFrame | null,
  maps: typeof GroundMaps | null = null,
): LabelledRings | null {
  const { grid } = volume;
  if (kilometres === 'none' || (kilometres === null && grid.kind !== 'polar')) return null;
  const text = typeof kilometres === 'number' ? String(kilometres) : ''; // As the author wrote it.
  if (grid.kind !== 'polar') throw invalid('rings', text, 'a radar scan, which alone has rings');
  const plan = planRings(grid, region, typeof kilometres === 'number' ? kilometres * 1000 : null);
  if (!ringsFit(plan)) {
    if (kilometres === null) return null;
    const [nearest, farthest] = plan.extent;
    throw invalid(
      'rings',
      text,
      `kilometres from ring to ring, of which 1 to ${maxRings} fit into the ${Math.round((farthest - nearest) / 1000)} km that are shown`,
    );
  }
  const rings = buildRings(plan);
  const lines = kilometres === null && !region ? [...rings.lines, ...buildSpokes(plan)] : rings.lines;
  const place = placeOfRadar(volume);
  const map = maps && place && !region ? { map: maps.buildGroundMap(place, plan.outermost) } : {};
  const facts = { name: volume.radar?.site.name ?? '', stretch: stretchOf(grid) };
  return { ...rings, ...map, lines, facts, labelsAfter: (picture, write) => RingLabels.after(picture, write) };
}
