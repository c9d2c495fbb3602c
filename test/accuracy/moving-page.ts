// In the browser: small things while a camera turns, where a frame has time for a part of what a picture at rest takes. It needs no clock.
import { StudyGl } from '../../demos/accuracy/study-gl.ts';
import { workOfFrame, unknownErrors } from '../../src/quality/frame-quality.ts';
import type { FrameQuality } from '../../src/quality/frame-quality.ts';
import { chooseFrameQuality } from '../../src/quality/choose-frame-quality.ts';
import { learnFrom } from '../../src/viewer/frames/view-quality.ts';
import { blowUp } from '../bench/blow-up.ts';
import { measureThing } from './compare-shown.ts';
import type { KeptThing } from './compare-shown.ts';
import { cameraOf, placeElement, setSight, takeAtRest } from './element-picture.ts';
import { castFullRays, findPixel } from './full-rays.ts';
import { show, sightOf } from './small-page.ts';
import { smallScenes } from './small-scenes.ts';
import { countThings } from './sum-up-small.mjs';
import type { ThingCounts } from './sum-up-small.mjs';

/** What became of a scene's things with one budget. */
export interface BudgetResult {
  /** Of the work of a picture at rest. */
  readonly share: number;
  /** Of the frame at the first angle. */
  readonly scale: number;
  readonly steps: number;
  readonly counts: ThingCounts;
}

export interface MovingResult {
  readonly name: string;
  readonly pixels: number;
  readonly minContrast: number;
  readonly budgets: readonly BudgetResult[];
}

/** What a frame has time for, of the work of a picture at rest. With all of it, it is drawn as that is. */
const shares = [1, 1 / 2, 1 / 4, 1 / 16, 1 / 64] as const;

const stepsPerVoxel = 4;

/** @param name - of a scene with things @param angles - their number, a degree apart */
export async function measureMotion(
  name: string,
  angles: number,
  notify: (what: string) => void,
): Promise<MovingResult> {
  const { view, transferFunction, minContrast } = smallScenes.find((one) => one.name === name)!;
  const { volume, bare, src, places, reach } = await show(name);
  const gl = new StudyGl();
  const size = view.pixels;
  const element = placeElement({
    src,
    sight: sightOf(volume, view, 0),
    attributes: transferFunction === null ? { shading: 'unlit' } : { 'transfer-function': transferFunction },
    ...view,
  });
  const kept = shares.map((): (KeptThing | null)[][] => []);
  const plans: FrameQuality[][] = shares.map(() => []);
  for (let angle = 0; angle < angles; angle++) {
    notify(`${name}, angle ${angle + 1} of ${angles}`);
    const sight = sightOf(volume, view, angle);
    setSight(element, sight);
    const { data } = await takeAtRest(element, size);
    const camera = cameraOf(sight);
    const asked = { volume, camera, optics: element.optics!, size, stepsPerVoxel };
    const full = await castFullRays(gl, asked);
    const without = await castFullRays(gl, { ...asked, volume: bare! });
    const viewer = element._session.viewer!;
    const {
      controller,
      shown: { grid },
    } = viewer;
    const scene = controller.scene!;
    const atRest = viewer.frames.planAtRest;
    const errors = {
      ...unknownErrors,
      ...(await learnFrom({ scene, grid, size: { width: size, height: size }, goesOn: () => true }, false)),
    };
    for (const [n, share] of shares.entries()) {
      const plan =
        share === 1
          ? atRest
          : chooseFrameQuality(
              { a: 0, b: 1 },
              errors,
              { pixels: size ** 2, steps: atRest.steps },
              { budgetMs: share * workOfFrame(atRest, size ** 2), last: plans[n].at(-1) },
            );
      if (share < 1) await viewer.pictures.draw(scene, performance.now(), plan, { width: size, height: size });
      const { width, height } = scene.canvas;
      const picture = share === 1 ? Float32Array.from(data) : blowUp(scene.readPicture().data, { width, height }, size);
      plans[n].push(plan);
      kept[n].push(
        places.map((place) =>
          measureThing(
            { shown: picture, full, bare: without, size },
            findPixel(camera, place, size),
            Math.max(1, reach * view.pixelsPerVoxel),
          ),
        ),
      );
    }
  }
  element.remove();
  gl.forget(volume);
  gl.dispose();
  return {
    name,
    pixels: size,
    minContrast,
    budgets: shares.map((share, n) => ({
      share,
      scale: plans[n][0].scale,
      steps: plans[n][0].steps,
      counts: countThings(kept[n], minContrast),
    })),
  };
}
