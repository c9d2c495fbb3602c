import { isWebGl2 } from './device.ts';
import type { Gl } from './device.ts';

/**
 * Resolves when the GPU has done all that it was told to. In WebGL 2 the page goes on meanwhile; WebGL 1 has no fences,
 * and waits.
 */
export async function gpuFinished(gl: Gl): Promise<void> {
  if (!isWebGl2(gl)) {
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    return;
  }
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  if (!fence) return;
  gl.flush();
  while (!gl.isContextLost()) {
    await new Promise((resolve) => setTimeout(resolve, 1));
    const status = gl.clientWaitSync(fence, 0, 0);
    if (status !== gl.TIMEOUT_EXPIRED) break;
  }
  gl.deleteSync(fence);
}
