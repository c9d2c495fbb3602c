import clip from '../../../../shaders/chunks/walk/clip.glsl?raw';
import slack from '../../../../shaders/chunks/walk/slack.glsl?raw';
import type { HalfSpace } from '../../../optics/rays/clip-intervals.ts';
import type { RayText, RayTwin, SliceModule } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';

export const clipText: RayText = { name: 'clip', stage: 'interval', defines: {}, chunks: [slack, clip], samplers: [] };

/** A half-space that keeps everything. */
const everything = [0, 0, 0, 1];

/** Rays run in the intersection of all half-spaces; twelve at most. */
export const createClip = (): SliceModule<HalfSpace> => create(true);

/** The same, if slices are cut too: the picture jumps at their new edges. */
export const createClipOfSlices = (): SliceModule<HalfSpace> => create(false);

const twin = (kept: readonly HalfSpace[]): RayTwin =>
  twinOf(usualTwins, ({ clipInterval }) => ({ intervals: [clipInterval(kept)] }));

function create(sparesRays: boolean): SliceModule<HalfSpace> {
  return {
    ...clipText,
    stage: 'interval',
    slices: [],
    // At the edges of the half-spaces opacity grows from 0, so the picture does not jump.
    sparesRays,
    order: Infinity,
    get twin() {
      return twin(this.slices);
    },
    inputs() {
      const four = (first: number): number[] =>
        [0, 1, 2, 3].flatMap((i) => {
          const kept = this.slices[first + i];
          return kept ? [...kept.normal, -kept.offset] : everything;
        });
      return { uniforms: { uClipA: four(0), uClipB: four(4), uClipC: four(8) }, units: [] };
    },
  };
}
