import { headlightAlone } from '../../../optics/transfer/lights.ts';
import { isPolar } from '../../../volume/volume.ts';
import type { VolumeData } from '../../../volume/volume.ts';
import { cartesianTapsOf } from '../modules/field-taps.ts';
import type { FieldTaps } from '../modules/field-taps.ts';
import type { LitOptions, LitSurroundings } from '../modules/lit.ts';
import { cutsOf, hasCuts } from '../modules/lit-cuts.ts';
import type { StyledLayer } from './style-modules.ts';

/** The light of a layer's volume. */
export interface LayerLight {
  /** The current light; null if the volume can't be lit. */
  (): { readonly options: LitOptions; readonly surroundings: LitSurroundings } | null;
  /** Load what lights such a volume, before it is set. */
  readonly prepare: (volume: Pick<VolumeData, 'grid'>) => Promise<void>;
}

export function lightLayer(layer: StyledLayer): LayerLight {
  let polarTaps: FieldTaps | null = null;
  const prepare = async (volume: Pick<VolumeData, 'grid'>): Promise<void> => {
    if (isPolar(volume)) polarTaps ??= (await layer.providers.polarTaps?.()) ?? null;
  };
  const light = (): ReturnType<LayerLight> => {
    const volume = layer.volume!;
    const taps = isPolar(volume) ? polarTaps : cartesianTapsOf;
    if (volume.isDiscrete || !taps) return null;
    const lights = layer.lights() ?? headlightAlone;
    const cuts = cutsOf(layer.plan.cuts);
    return {
      options: { taps, lights: lights.lights.length > 0, cuts: layer.plan.region !== null || hasCuts(cuts) },
      surroundings: { lights, cuts },
    };
  };
  return Object.assign(light, { prepare });
}
