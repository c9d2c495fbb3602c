// Values and gradients of a volume, for a histogram: collected when an editor needs them, a few milliseconds at a time.
import { cartesianGradient } from '../../optics/rays/gradient.ts';
import { perWorldUnit } from '../../optics/rays/patch-classify.ts';
import { cartesianField } from '../../optics/rays/ray-field.ts';
import { polarBeamField, polarField } from '../../radar/polar-field.ts';
import { polarGradient } from '../../radar/polar-gradient.ts';
import { length } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';

/** Values (data units) and gradients (data units per world unit) at places of a volume. */
export interface SampledPlane {
  readonly values: Float32Array;
  readonly gradients: Float32Array;
}

/** The maximum number of samples: enough for a picture of a few thousand bins. */
const maxSamples = 120_000;

/** The maximum number of places to try; places without data give no sample. */
const maxPlaces = 4 * maxSamples;

/** The number of places between two checks of the clock. */
const batch = 64;

/** The page is blocked for no longer than this at a time, milliseconds. */
const slice = 8;

/** Steps between evenly spread places of a volume, which are always the same. Source: Roberts 2018, the R3 sequence */
const steps: Vector3 = [0.8191725133961645, 0.6710436067037893, 0.5497004779019703];

/** Collect the samples, step by step. Volumes of labels have no gradients. @returns null for these */
export function* samplePlane(volume: Volume, max = maxSamples): Generator<undefined, SampledPlane | null> {
  if (volume.isDiscrete) return null;
  const { grid } = volume;
  const field = isPolar(volume) ? polarField(volume) : cartesianField({ ...volume, dimensions: grid.dimensions });
  const gradient = isPolar(volume)
    ? polarGradient(polarBeamField(volume), volume.grid)
    : cartesianGradient(field, grid);
  const toWorld = perWorldUnit(grid);
  const [values, gradients] = [new Float32Array(max), new Float32Array(max)];
  let count = 0;
  for (let i = 1; i <= (maxPlaces / maxSamples) * max && count < max; i++) {
    if (i % batch === 0) yield;
    const place = steps.map((x) => (i * x) % 1) as unknown as Vector3;
    const known = field.sampleAt(place);
    if (!known.valid) continue;
    values[count] = known.value;
    gradients[count] = toWorld * length(gradient(place, known).world);
    count++;
  }
  return { values: values.subarray(0, count), gradients: gradients.subarray(0, count) };
}

/** The same in small parts, so that the page can work in between. @returns null also where it is no longer needed */
export async function collectSamples(volume: Volume, signal: AbortSignal): Promise<SampledPlane | null> {
  const work = samplePlane(volume);
  while (!signal.aborted) {
    const end = performance.now() + slice;
    while (performance.now() < end) {
      const step = work.next();
      if (step.done) return step.value;
    }
    await new Promise((resolve) => setTimeout(resolve));
  }
  return null;
}
