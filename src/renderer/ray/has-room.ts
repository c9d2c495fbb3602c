import { listSamplers, maxSamplers } from './compose-ray.ts';
import type { RayText } from './ray-module.ts';

const reported = new Set<string>();

/**
 * Whether a sampler is left for one more texture: in WebGL 1 other modules may use all of them.
 * @param leftOut - what the console says, once, if there is none
 */
export function hasRoomFor(
  leftOut: string,
  others: readonly RayText[],
  { webgl2 }: { readonly webgl2: boolean },
): boolean {
  const fits = listSamplers({ adaptive: false, modules: others }).length < maxSamplers(webgl2);
  if (!fits && !reported.has(leftOut)) console.warn(`<volume-view>: ${leftOut}`);
  if (!fits) reported.add(leftOut);
  return fits;
}
