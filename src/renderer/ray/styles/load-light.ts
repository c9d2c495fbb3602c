import { headlightAlone } from '../../../optics/transfer/lights.ts';
import { isPolar } from '../../../volume/volume.ts';
import { cartesianTapsOf } from '../modules/lit.ts';
import type { FieldTaps, LitOptions, LitSurroundings } from '../modules/lit.ts';
import { cutsOf, hasCuts } from '../modules/lit-cuts.ts';
import type { StyledLayer } from './style-modules.ts';

/** Load the code for light. The returned function gives the current light of a layer's volume; null if the volume can't be lit. */
export async function loadLight(
  layer: StyledLayer,
): Promise<() => { readonly options: LitOptions; readonly surroundings: LitSurroundings } | null> {
  const polarTaps: FieldTaps | null = (await layer.providers.polarTaps?.()) ?? null;
  return () => {
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
}
