// A transfer function of value and gradient in rays that are cast on the CPU: loaded with the first pick of a volume that has one.
import { cartesianGradient } from '../../optics/rays/gradient.ts';
import { pointField } from '../../optics/rays/lit.ts';
import { lightPatches, patchClassify } from '../../optics/rays/patch-classify.ts';
import type { Patch } from '../../optics/transfer/patches.ts';
import { cartesianField } from '../../optics/rays/ray-field.ts';
import type { ReferenceScene } from '../../optics/reference.ts';
import type { RaySetup } from '../../optics/rays/rays.ts';
import { polarBeamField } from '../../radar/polar-field.ts';
import { polarGradient } from '../../radar/polar-gradient.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';

interface PatchedRays {
  readonly volume: Volume;
  readonly optics: Pick<ReferenceScene, 'referenceLength' | 'opacityFactor' | 'lightFactor'> & { readonly patches: readonly Patch[] };
  readonly setup: RaySetup;
}

/** Volumes of labels have no gradients. */
export function patchedStages({ volume, optics, setup }: PatchedRays): Pick<ReferenceScene, 'classifyBy'> & Required<Pick<ReferenceScene, 'moreFields' | 'shades'>> {
  if (volume.isDiscrete) return { moreFields: [], shades: [] };
  const { grid } = volume;
  const { patches, referenceLength, opacityFactor, lightFactor } = optics;
  const beams = isPolar(volume) ? polarBeamField(volume) : null;
  const own = cartesianField({ ...volume, dimensions: grid.dimensions });
  const field = beams ?? own;
  const gradient = isPolar(volume) ? polarGradient(beams!, volume.grid) : cartesianGradient(own, grid);
  const scene = { patches: lightPatches(patches, lightFactor), grid, gradient, field, opticalScale: (setup.diameter / referenceLength) * opacityFactor };
  return { moreFields: [pointField], shades: [], classifyBy: (usual) => patchClassify(usual, scene) };
}
