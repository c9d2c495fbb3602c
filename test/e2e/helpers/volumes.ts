import type { Volume } from '../../../src/volume/volume.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

/** What most specs show. Its edges are 24, 30 and 32 long: no two the same, so that a mixed-up axis shows. */
export const field: Volume = syntheticVolume({ dimensions: [24, 20, 16], spacing: [1, 1.5, 2] });

/** Something else than the field, with no value in common places. */
export const ball: Volume = syntheticVolume({
  dimensions: [12, 12, 12],
  kind: 'float32',
  field: (x, y, z) => Math.max(0, 1 - 2.2 * Math.hypot(x - 0.5, y - 0.5, z - 0.5)),
});
