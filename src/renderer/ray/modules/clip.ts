import clip from '../../../../shaders/chunks/walk/clip.glsl?raw';
import slack from '../../../../shaders/chunks/walk/slack.glsl?raw';
import type { HalfSpace } from '../../../optics/rays/clip-intervals.ts';
import type { RayText, RayTwin, SliceModule } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';

export const clipText: RayText = { name: 'clip', stage: 'interval', defines: {}, chunks: [slack, clip], samplers: [] };

/** Keeps all that is there. */
const everything = [0, 0, 0, 1];

/** Rays run where all half-spaces are, twelve at most. */
export const createClip = (): SliceModule<HalfSpace> => create(true);

/** The same where slices are cut too: at their new edges the picture jumps. */
export const createClipOfSlices = (): SliceModule<HalfSpace> => create(false);

const twin = (kept: readonly HalfSpace[]): RayTwin => twinOf(usualTwins, ({ clipInterval }) => ({ intervals: [clipInterval(kept)] }));

function create(sparesRays: boolean): SliceModule<HalfSpace> {
  return {
    ...clipText,
    stage: 'interval',
    slices: [],
    // Opacity grows from 0 at its edges.
    sparesRays,
    order: Infinity,
    get twin() {
      return twin(this.slices);
    },
    inputs() {
      const four = (first: number): number[] => [0, 1, 2, 3].flatMap((i) => {
        const kept = this.slices[first + i];
        return kept ? [...kept.normal, -kept.offset] : everything;
      });
      return { uniforms: { uClipA: four(0), uClipB: four(4), uClipC: four(8) }, units: [] };
    },
  };
}
