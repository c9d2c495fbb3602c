// The float64 twins of a radar's modules. They are loaded with the first ray that is cast through one on the processor.
import type { ShownOverlay } from '../optics/attachments/overlay.ts';
import type { FieldStage } from '../optics/rays/ray-stages.ts';
import type { SlopedField } from '../optics/shading-twins.ts';
import { isPolar } from '../volume/volume.ts';
import type { PolarData, VolumeData } from '../volume/volume.ts';
import { polarBeamField, secondMomentField } from './polar-field.ts';
import { polarGradient } from './polar-gradient.ts';

export { polarField } from './polar-field.ts';
export { sliceInterval, sliceMeeter } from './slices.ts';

/** The gradients of a radar's volume. */
export function polarSlopes(volume: VolumeData): SlopedField {
  const polar = asPolar(volume);
  const field = polarBeamField(polar);
  return { gradient: polarGradient(field, polar.grid), isFolded: field.isFolded };
}

/** The field of another moment of the gates below a layer. */
export function secondMoment({ over, volume }: ShownOverlay): FieldStage {
  return secondMomentField(asPolar(over), asPolar(volume));
}

function asPolar(volume: VolumeData): PolarData {
  if (!isPolar(volume)) throw new TypeError("a radar's twin got a cartesian grid; expected a polar one");
  return volume;
}
