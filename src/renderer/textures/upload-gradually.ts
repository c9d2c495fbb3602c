import type { Gl } from '../device/device.ts';
import { pieceBytes } from './fill-texture.ts';
import type { Upload } from './fill-texture.ts';
import { gpuFinished } from '../device/gpu-finished.ts';

/** Most bytes between two frames, however fast the GPU takes them. */
export const maxBytesAFrame = 2 ** 24;

const minBytesAFrame = 2 ** 21;

/** ms of a frame that may go into an upload; of 16 that there are, what is left is the page's. */
const budgetMs = 8;

/**
 * Do an upload bit by bit between frames, each bit after the GPU has finished the one before.
 * @param givenUp - asked before each bit
 * @returns null where it was given up, or the context was lost
 */
export async function uploadGradually<T>(gl: Gl, upload: Upload<T>, givenUp: () => boolean): Promise<T | null> {
  let bytesAFrame = 2 * minBytesAFrame;
  try {
    await gpuFinished(gl); // Making room asks for errors, and the page would wait for a picture that is being drawn.
    for (;;) {
      await nextFrame();
      if (givenUp() || gl.isContextLost()) return null;
      const began = performance.now();
      for (let bytes = 0; bytes + pieceBytes <= bytesAFrame && performance.now() - began < budgetMs; ) {
        const step = upload.next();
        if (step.done) return step.value;
        bytes += step.value;
      }
      await gpuFinished(gl);
      bytesAFrame = adapt(bytesAFrame, performance.now() - began);
    }
  } finally {
    upload.return(undefined as T); // Nothing happens where it is finished.
  }
}

function adapt(bytes: number, tookMs: number): number {
  if (tookMs > budgetMs) return Math.max(minBytesAFrame, bytes / 2);
  return tookMs < budgetMs / 2 ? Math.min(maxBytesAFrame, bytes * 2) : bytes;
}

/** In a page that nobody sees there are no frames, and none that could be late. */
function nextFrame(): Promise<unknown> {
  return new Promise((resolve) => (document.hidden ? setTimeout(resolve) : requestAnimationFrame(resolve)));
}
