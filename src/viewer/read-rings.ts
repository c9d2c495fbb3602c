import { buildRings, buildSpokes, maxRings, planRings, ringsFit } from '../radar/range-rings.ts';
import type { Rings } from '../radar/range-rings.ts';
import type { GridFrame } from '../volume/grid.ts';
import type { Volume } from '../volume/volume.ts';
import { invalid } from './parse-attributes.ts';
import type { RingSetting } from './parse-attributes.ts';
import { RingLabels } from './ring-labels.ts';

/** Rings, and what labels them: it is loaded with them. */
export interface LabelledRings extends Rings {
  labelsAfter(picture: Element, write: (radius: number | null) => string): RingLabels;
}

/**
 * The rings that an author asks for.
 * @param kilometres - from ring to ring; round ones where auto; where null, round ones and a ground if it is a radar
 * @param region - what is shown of the volume, if not all: the rings are cut to it
 * @throws {VolumeViewError} `attribute/invalid`
 */
export function readRings(kilometres: RingSetting | null, { grid }: Pick<Volume, 'grid'>, region: GridFrame | null): LabelledRings | null {
  if (kilometres === 'none' || (kilometres === null && grid.kind !== 'polar')) return null;
  const text = typeof kilometres === 'number' ? String(kilometres) : ''; // As it was written.
  if (grid.kind !== 'polar') throw invalid('rings', text, 'a radar scan, which alone has rings');
  const plan = planRings(grid, region, typeof kilometres === 'number' ? kilometres * 1000 : null);
  if (!ringsFit(plan)) {
    if (kilometres === null) return null;
    const [nearest, farthest] = plan.extent;
    throw invalid('rings', text, `kilometres from ring to ring, of which 1 to ${maxRings} fit into the ${Math.round((farthest - nearest) / 1000)} km that are shown`);
  }
  const rings = buildRings(plan);
  const lines = kilometres === null && !region ? [...rings.lines, ...buildSpokes(plan)] : rings.lines;
  return { ...rings, lines, labelsAfter: (picture, write) => RingLabels.after(picture, write) };
}
