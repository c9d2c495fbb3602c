// In the browser: what elements say of the errors of random scenes, and what these are.
import { StudyGl } from '../../demos/accuracy/study-gl.ts';
import type { RenderStats } from '../../src/viewer/model/render-stats.ts';
import type { Volume } from '../../src/volume/volume.ts';
import type { CoveredError } from '../helpers/covered-error.ts';
import { measureTrueError } from './compare-shown.ts';
import { cameraOf, placeElement, takeAtRest } from './element-picture.ts';
import { castFullRays } from './full-rays.ts';
import { serveVolume } from './small-page.ts';
import { eachStatedScene } from './stated-scenes.ts';

/** A scene's error as the element says it, and as it is. */
export interface StatedResult {
  readonly name: string;
  readonly maxError: number;
  readonly stats: RenderStats;
  readonly error: CoveredError;
  /** Pixels that the volume covers, as a share of all. */
  readonly coverage: number;
  /** Largest difference of full rays with four and with eight steps a voxel, 1/255. */
  readonly uncertain: number;
}

/** @param count - of scenes @param detail - the attribute @param notify - what is being done */
export async function measureStated(
  { count, detail }: { readonly count: number; readonly detail: string },
  notify: (what: string) => void,
): Promise<StatedResult[]> {
  const gl = new StudyGl();
  const results: StatedResult[] = [];
  const sources = new Map<Volume, string>();
  for await (const { name, volume, transferFunction, maxError, sight, pixels } of eachStatedScene(count)) {
    notify(`scene ${results.length + 1} of ${count}: ${name}, max-error ${maxError}`);
    const src = sources.get(volume) ?? serveVolume(volume);
    sources.set(volume, src);
    const attributes = {
      'transfer-function': transferFunction,
      'value-window': volume.range.join(' '),
      'max-error': String(maxError),
      detail,
    };
    const element = placeElement({ src, sight, pixels, ratio: 1, attributes });
    const { data, stats } = await takeAtRest(element, pixels);
    const asked = { volume, camera: cameraOf(sight), optics: element.optics!, size: pixels };
    const full = await castFullRays(gl, { ...asked, stepsPerVoxel: 8 });
    const coarser = await castFullRays(gl, { ...asked, stepsPerVoxel: 4 });
    element.remove();
    const uncertain = full.reduce((max, x, i) => Math.max(max, 255 * Math.abs(x - coarser[i])), 0);
    const error = measureTrueError(data, full, coarser);
    results.push({ name, maxError, stats, error, coverage: error.covered / pixels ** 2, uncertain });
  }
  gl.dispose();
  return results;
}
