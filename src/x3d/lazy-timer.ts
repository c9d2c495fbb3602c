import type { Gl } from '../renderer/device.ts';
import type { GpuTimer } from '../renderer/gpu-timer.ts';

/** Takes the GPU's time of a drawing. What does so comes beside the first picture: the first frames do without it. */
export class LazyTimer {
  timer: GpuTimer | null = null;

  constructor(gl: Gl) {
    import('../renderer/gpu-timer.ts').then(({ GpuTimer: Timer }) => {
      if (!gl.isContextLost()) this.timer = Timer.create(gl);
    }, () => {});
  }
}
