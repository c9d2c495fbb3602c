import { isWebGl2 } from './device.ts';
import type { Gl } from './device.ts';

/**
 * Resolves when the GPU has finished all commands so far. In WebGL 2 the page continues meanwhile; WebGL 1 has no fences,
 * so the page waits.
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
