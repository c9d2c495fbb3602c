import box from '../../../shaders/chunks/walk/box.glsl?raw';
import depthJumps from '../../../shaders/chunks/depth/depth-jumps.glsl?raw';
import interval from '../../../shaders/chunks/walk/interval.glsl?raw';
import ray from '../../../shaders/chunks/walk/ray.glsl?raw';
import region from '../../../shaders/chunks/walk/region.glsl?raw';
import sceneDepth from '../../../shaders/chunks/depth/scene-depth.glsl?raw';
import depthJumpsStage from '../../../shaders/programs/depth-jumps.frag.glsl?raw';
import wholePicture from '../../../shaders/programs/whole-picture.vert.glsl?raw';
import { endSlack, jumps, nearestEnd } from '../../optics/rays/depth-jumps.ts';
import { composeStage } from '../device/compose-stage.ts';
import type { Defines, ShaderTexts } from '../device/compose-stage.ts';

/** The same constants as in the twin (the float64 code). */
export const jumpDefines: Defines = {
  END_SLACK: String(endSlack),
  NEAREST_END: nearestEnd.toExponential(1),
  JUMP_NONE: jumps.none.toFixed(1),
  JUMP_NEARER: jumps.nearer.toFixed(1),
  JUMP_FARTHER: jumps.farther.toFixed(1),
};

/** The chunks that compute where rays end. */
export const jumpChunks: readonly string[] = [interval, ray, box, region, sceneDepth, depthJumps];

export function composeDepthJumps(webgl2: boolean): ShaderTexts {
  return {
    vertex: composeStage({ webgl2, stage: 'VERTEX_STAGE' }, [wholePicture]),
    fragment: composeStage({ webgl2, stage: 'FRAGMENT_STAGE', defines: jumpDefines }, [...jumpChunks, depthJumpsStage]),
  };
}
