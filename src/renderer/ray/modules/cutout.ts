import box from '../../../../shaders/chunks/walk/box.glsl?raw';
import cutout from '../../../../shaders/chunks/walk/cutout.glsl?raw';
import slack from '../../../../shaders/chunks/walk/slack.glsl?raw';
import type { Cutout } from '../../../optics/rays/clip-intervals.ts';
import type { RayText, RayTwin, SliceModule } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';

/** GAP: rays may have two pieces. */
export const cutoutText: RayText = {
  name: 'cutout',
  stage: 'interval',
  defines: { GAP: 1 },
  chunks: [box, slack, cutout],
  samplers: [],
};

/** One box is cut out of rays. The module comes after those that limit a ray's interval, and before the slices in the volume. */
export const createCutout = (): SliceModule<Cutout> => create(true);

/** The same, if slices are cut too: the picture jumps at their new edges. */
export const createCutoutOfSlices = (): SliceModule<Cutout> => create(false);

const twin = ([cutout]: readonly Cutout[]): RayTwin =>
  twinOf(usualTwins, ({ cutoutInterval }) => ({ intervals: [cutoutInterval(cutout)] }));

function create(sparesRays: boolean): SliceModule<Cutout> {
  return {
    ...cutoutText,
    stage: 'interval',
    slices: [],
    // At the edges of the box the gap grows from 0, so the picture does not jump.
    sparesRays,
    order: Infinity,
    get twin() {
      return twin(this.slices);
    },
    inputs() {
      const [{ unitToBox: m }] = this.slices;
      return {
        uniforms: {
          uCutoutTurn: [m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10]],
          uCutoutShift: [m[3], m[7], m[11]],
        },
        units: [],
      };
    },
  };
}
