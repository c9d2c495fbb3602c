import type { Gl } from '../device/device.ts';
import { pieceBytes } from './fill-texture.ts';
import type { Upload } from './fill-texture.ts';
import { gpuFinished } from '../device/gpu-finished.ts';

/** The maximum bytes between two frames, however fast the GPU is. */
export const maxBytesAFrame = 2 ** 24;

const minBytesAFrame = 2 ** 21;

/** The time of a frame that an upload may use, in ms. A frame has 16 ms; the rest is for the page. */
const budgetMs = 8;

/**
 * Do an upload in parts between frames; each part starts after the GPU has finished the one before.
 * @param givenUp - called before each part; returns true to stop
 * @returns null if the upload was given up, or the context was lost
 */
export async function uploadGradually<T>(gl: Gl, upload: Upload<T>, givenUp: () => boolean): Promise<T | null> {
  let bytesAFrame = 2 * minBytesAFrame;
  try {
    await gpuFinished(gl); // The allocation checks for errors; without this, the page would block until the GPU has drawn the current picture.
    for (;;) {
      await nextFrame();
      if (givenUp() || gl.isContextLost()) return null;
      const began = performance.now();
      for (let bytes = 0; bytes + pieceBytes <= bytesAFrame && performance.now() - began < budgetMs;) {
        const step = upload.next();
        if (step.done) return step.value;
        bytes += step.value;
      }
      await gpuFinished(gl);
      bytesAFrame = adapt(bytesAFrame, performance.now() - began);
    }
  } finally {
    upload.return(undefined as T); // This does nothing if the upload is finished.
  }
}

function adapt(bytes: number, tookMs: number): number {
  if (tookMs > budgetMs) return Math.max(minBytesAFrame, bytes / 2);
  return tookMs < budgetMs / 2 ? Math.min(maxBytesAFrame, bytes * 2) : bytes;
}

/** A hidden page gets no frames, so that no frame can be late. */
function nextFrame(): Promise<unknown> {
  return new Promise((resolve) => (document.hidden ? setTimeout(resolve) : requestAnimationFrame(resolve)));
}
