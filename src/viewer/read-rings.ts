import { buildRings, maxRings, planRings, ringsFit } from '../radar/range-rings.ts';
import type { Rings } from '../radar/range-rings.ts';
import type { GridFrame } from '../volume/grid.ts';
import type { Volume } from '../volume/volume.ts';
import { invalid, parseLength } from './parse-attributes.ts';

/**
 * The rings that an attribute asks for: empty for round distances, else their distance in kilometres.
 * @param region - what is shown of the volume, if not all: the rings are cut to it
 * @throws {VolumeViewError} `attribute/invalid`
 */
export function readRings(text: string | null, { grid }: Pick<Volume, 'grid'>, region: GridFrame | null): Rings | null {
  if (text === null) return null;
  if (grid.kind !== 'polar') throw invalid('rings', text, 'a radar scan, which alone has rings');
  const plan = planRings(grid, region, text.trim() === '' ? null : parseLength('rings', text) * 1000);
  if (!ringsFit(plan)) {
    const [nearest, farthest] = plan.extent;
    throw invalid('rings', text, `kilometres from ring to ring, of which 1 to ${maxRings} fit into the ${Math.round((farthest - nearest) / 1000)} km that are shown`);
  }
  return buildRings(plan);
}
