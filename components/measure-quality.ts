import { estimateError } from '../src/quality/error-estimate.ts';
import type { ErrorEstimate } from '../src/quality/error-estimate.ts';
import { stepLengthOf } from '../src/quality/steps.ts';
import type { CartesianGrid } from '../src/volume/grid.ts';
import type { VolumeScene } from '../src/x3d/scene.ts';

/**
 * One ray in so many pixels is looked at. With its step, half of it and a quarter that is 7 / 84 of the picture's own
 * samples: a twelfth of a frame.
 */
const pixelsPerRay = 84;

/** Rows of the picture that tell what fewer pixels would cost. */
const bandRows = 96;

/** Rays across and down of a picture that is looked at. */
export function probeSize({ width, height }: { width: number; height: number }): { width: number; height: number } {
  const every = Math.sqrt(pixelsPerRay);
  return { width: Math.max(8, Math.round(width / every)), height: Math.max(8, Math.round(height / every)) };
}

/**
 * The error that the last view has with a number of steps; null where the device can't measure it.
 * @param size - pixels across and down of the picture in full
 */
export function measureError(
  scene: VolumeScene,
  grid: CartesianGrid,
  steps: number,
  size: { width: number; height: number } = scene.canvas,
): ErrorEstimate | null {
  const lengths = [1, 2, 4].map((finer) => stepLengthOf(grid, steps * finer));
  const pictures = scene.probe(lengths, probeSize(size));
  return pictures && estimateError([pictures[0], pictures[1], pictures[2]]);
}

/**
 * The error that the picture on the canvas would have with half the pixels across and down, blown up again as browsers
 * do it, bilinear; RMS, 1/255. Looked at in a band across its middle.
 */
export function errorAtHalf(scene: VolumeScene): number {
  const { width, height } = scene.canvas;
  const rows = Math.min(height, bandRows) & ~1;
  const columns = width & ~1;
  if (rows < 4 || columns < 4) return 0;
  const pixels = scene.readBand(Math.floor((height - rows) / 2), rows);
  let sum = 0;
  let count = 0;
  // Where four coarse pixels meet, bilinear filtering gives 9, 3, 3 and 1 sixteenths of their means to each fine one.
  for (let y = 2; y + 3 < rows; y += 2) {
    for (let x = 2; x + 3 < columns; x += 2) {
      for (let c = 0; c < 4; c++) {
        const mean = (i: number, j: number): number => {
          const at = ((y + j) * width + x + i) * 4 + c;
          return (pixels[at] + pixels[at + 4] + pixels[at + width * 4] + pixels[at + width * 4 + 4]) / 4;
        };
        const filtered = (9 * mean(0, 0) + 3 * mean(2, 0) + 3 * mean(0, 2) + mean(2, 2)) / 16;
        sum += (pixels[((y + 1) * width + x + 1) * 4 + c] - filtered) ** 2;
        count++;
      }
    }
  }
  return Math.sqrt(sum / count);
}
