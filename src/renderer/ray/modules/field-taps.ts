// Samples around a place of a field, for gradients.
import cartesianTaps from '../../../../shaders/chunks/field/gradient-cartesian.glsl?raw';
import { loadPart } from '../../../core/load-part.ts';
import { normalsToWorld } from '../../../optics/rays/gradient.ts';
import type { SlopedField } from '../../../optics/shading-twins.ts';
import type { Matrix4 } from '../../../volume/matrix.ts';
import type { VolumeData } from '../../../volume/volume.ts';
import type { Uniforms } from '../../device/inputs.ts';
import { partOf } from '../part-of-twins.ts';
import { later } from '../ray-twin.ts';
import type { Later } from '../ray-twin.ts';

/** How a kind of field takes taps (samples around a place) for gradients: its chunk, and the uniforms that the chunk reads. */
export interface FieldTaps {
  readonly chunk: string;
  uniforms(volume: VolumeData): Uniforms;
  /** Row-major matrix: from the direction in which values grow, as the chunk returns it, to a direction in the world. */
  normals(volume: VolumeData): Matrix4;
  /** The same field in float64. */
  readonly slopes: Later<(volume: VolumeData) => SlopedField>;
}

/** The code of all twins that need gradients. */
export const shadingTwins = later(() =>
  loadPart(import('../../../optics/shading-twins.ts'), 'lights rays on the processor'),
);

export const cartesianTapsOf: FieldTaps = {
  chunk: cartesianTaps,
  uniforms: () => ({}),
  normals: (volume) => normalsToWorld(volume.finer?.finest ?? volume.grid),
  slopes: partOf(shadingTwins, ({ cartesianSlopes }) => cartesianSlopes),
};
