import { later } from '../../core/later.ts';
import { isWebGl2 } from './device.ts';
import type { Gl } from './device.ts';
import { readPicture } from './read-picture.ts';

/**
 * Resolves when the GPU has finished all commands so far. In WebGL 2 the page continues meanwhile; WebGL 1 has no fences,
 * so the page waits.
 */
export async function gpuFinished(gl: Gl): Promise<void> {
  if (!isWebGl2(gl)) {
    readPicture(gl, { width: 1, height: 1 });
    return;
  }
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  if (!fence) return;
  gl.flush();
  // It fails where the context is lost meanwhile.
  do await later();
  while (gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED);
  gl.deleteSync(fence);
}
