import box from '../../../../shaders/chunks/walk/box.glsl?raw';
import cutout from '../../../../shaders/chunks/walk/cutout.glsl?raw';
import slack from '../../../../shaders/chunks/walk/slack.glsl?raw';
import type { Cutout } from '../../../optics/rays/clip-intervals.ts';
import type { RayText, RayTwin, SliceModule } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';

/** GAP: rays may have two pieces. */
export const cutoutText: RayText = { name: 'cutout', stage: 'interval', defines: { GAP: 1 }, chunks: [box, slack, cutout], samplers: [] };

/** One box is cut out of rays. It stands after what ends them at their begin, and before what they meet in the volume. */
export const createCutout = (): SliceModule<Cutout> => create(true);

/** The same where slices are cut too: at their new edges the picture jumps. */
export const createCutoutOfSlices = (): SliceModule<Cutout> => create(false);

const twin = ([cutout]: readonly Cutout[]): RayTwin => twinOf(usualTwins, ({ cutoutInterval }) => ({ intervals: [cutoutInterval(cutout)] }));

function create(sparesRays: boolean): SliceModule<Cutout> {
  return {
    ...cutoutText,
    stage: 'interval',
    slices: [],
    // At its edges a gap grows from 0, as opacity does at those of a box.
    sparesRays,
    order: Infinity,
    get twin() {
      return twin(this.slices);
    },
    inputs() {
      const [{ unitToBox: m }] = this.slices;
      return { uniforms: { uCutoutTurn: [m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10]], uCutoutShift: [m[3], m[7], m[11]] }, units: [] };
    },
  };
}
