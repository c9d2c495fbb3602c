// In the browser: how far the ray-caster is from the minimum of work.
import { StudyGl } from '../../demos/accuracy/study-gl.ts';
import type { StudyPicture } from '../../demos/accuracy/study-gl.ts';
import { autoSteps } from '../../src/quality/steps.ts';
import type { FoundSteps } from './find-steps.ts';
import { eachScene, findAllSteps, pictureOf, timeInTurns } from './quality-page.ts';
import type { QualityOptions } from './quality-page.ts';

/** One scene at one size. */
export interface LimitRow {
  readonly volume: string;
  readonly transferFunction: string;
  readonly size: number;
  /** The share of a picture's rays on which something shows, and samples that show on each of those, one a voxel. */
  readonly rays: number;
  readonly samples: number;
  /** Of the loop that only fetches those. */
  readonly ms: number;
  /** Ours to each error, by target. */
  readonly reached: ReadonlyMap<number, (FoundSteps & { ms: number }) | null>;
}

/** @param notify - what is being done */
export async function measureLimits(options: QualityOptions, notify: (what: string) => void): Promise<LimitRow[]> {
  const gl = new StudyGl();
  const rows: LimitRow[] = [];
  for await (const { volume, transferFunction, picture } of eachScene(gl, options.scenes, notify)) {
    const found = await findAllSteps(gl, picture, ['shipped'], options);
    const voxels = { ...picture, steps: autoSteps(picture.volume.grid) };
    for (const size of options.sizes) {
      const shown = await gl.draw({ ...voxels, method: 'shown' }, size, new AbortController().signal);
      const pictures = new Map<string, StudyPicture>([['fetched', { ...voxels, method: 'fetched', shown }]]);
      for (const [target, techniques] of found) {
        const one = techniques.get('shipped');
        if (one) pictures.set(String(target), pictureOf(picture, 'shipped', one));
      }
      const times = timeInTurns(gl, pictures, { size, repeats: options.repeats });
      const reached = new Map(
        [...found].map(([target, techniques]) => {
          const one = techniques.get('shipped');
          return [target, one ? { ...one, ms: times.get(String(target))! } : null];
        }),
      );
      rows.push({ volume, transferFunction, size, ...countShown(shown), ms: times.get('fetched')!, reached });
    }
  }
  gl.dispose();
  return rows;
}

function countShown(shown: Float32Array): { rays: number; samples: number } {
  let rays = 0;
  let samples = 0;
  for (let i = 1; i < shown.length; i += 4) {
    if (shown[i] > 0) rays++;
    samples += shown[i];
  }
  return { rays: rays / (shown.length / 4), samples: samples / Math.max(1, rays) };
}
