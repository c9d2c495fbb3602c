import { estimateError } from '../src/quality/error-estimate.ts';
import type { ErrorEstimate } from '../src/quality/error-estimate.ts';
import { stepLengthOf } from '../src/quality/steps.ts';
import type { Volume } from '../src/volume/volume.ts';
import type { VolumeScene } from '../src/x3d/scene.ts';

/**
 * One ray in so many pixels is looked at. With its step, half of it and a quarter that is 7 / 84 of the picture's own
 * samples: a twelfth of a frame.
 */
const pixelsPerRay = 84;

/** Rays across and down of a picture that is looked at. */
export function probeSize({ width, height }: { width: number; height: number }): { width: number; height: number } {
  const every = Math.sqrt(pixelsPerRay);
  return { width: Math.max(8, Math.round(width / every)), height: Math.max(8, Math.round(height / every)) };
}

/** The error that the last view has with a number of steps; null where the device can't measure it. */
export function measureError(scene: VolumeScene, volume: Volume, steps: number): ErrorEstimate | null {
  const lengths = [1, 2, 4].map((finer) => stepLengthOf(volume, steps * finer));
  const pictures = scene.probe(lengths, probeSize(scene.canvas));
  return pictures && estimateError([pictures[0], pictures[1], pictures[2]]);
}
