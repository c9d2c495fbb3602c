import polarTaps from '../../../shaders/chunks/radar/gradient-polar.glsl?raw';
import type { FieldTaps } from '../../renderer/ray/modules/field-taps.ts';
import { partOf } from '../../renderer/ray/part-of-twins.ts';
import { beamTaps } from '../polar-gradient.ts';
import { stretchOf } from '../polar-geometry.ts';
import { radarTwins } from './radar-twins.ts';

/** How a radar's field is lit. It is loaded together with light. */
export const polarTapsOf: FieldTaps = {
  chunk: polarTaps,
  uniforms: ({ grid }) => {
    if (grid.kind !== 'polar') throw new TypeError('polarTapsOf got a cartesian grid; expected a polar one');
    const { range, angle } = beamTaps(grid);
    return { uBeamTaps: [range, angle] };
  },
  normals: ({ grid }) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 / stretchOf(grid), 0, 0, 0, 0, 1],
  slopes: partOf(radarTwins, ({ polarSlopes }) => polarSlopes),
};
