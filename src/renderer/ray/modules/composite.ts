import compositeChunk from '../../../../shaders/chunks/gather/composite.glsl?raw';
import finishColor from '../../../../shaders/chunks/gather/finish-color.glsl?raw';
import emptySpace from '../../../../shaders/chunks/walk/empty-space.glsl?raw';
import { lastCode, encodeCells, measureEmptySpace } from '../../../optics/cells/empty-space-distance.ts';
import { powerOfSteps } from '../../../optics/transfer/power-of-steps.ts';
import { uploadCells } from '../../textures/cell-texture.ts';
import type { CellTexture } from '../../textures/cell-texture.ts';
import type { Device, Gl } from '../../device/device.ts';
import { Kept } from '../../device/kept.ts';
import type { RayModule, RayText } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';

export const compositeText: RayText = {
  name: 'composite',
  stage: 'gather',
  defines: { LAST_CODE: lastCode.toFixed(1) },
  chunks: [compositeChunk, emptySpace, finishColor],
  samplers: ['uEmptySpaceDistance'],
};

const twin = twinOf(usualTwins, ({ compositeGather }) => ({ gather: compositeGather }));

/** Emission and absorption; rays skip empty space. */
export function createComposite(gl: Gl, device: Device): RayModule<'gather'> {
  const cells = new Kept<CellTexture>();
  return {
    ...compositeText,
    stage: 'gather',
    sparesRays: true,
    twin,
    // If segments are exact, the picture is exact too.
    order: Infinity,
    inputs({ volume, skipping, contributions, detail, voxelsPerStep }) {
      const { macrocells } = volume;
      const { unit, uniforms } = cells.get([volume, skipping, detail, ...contributions], (previous) => {
        const distances = skipping
          ? measureEmptySpace(macrocells, contributions, volume)
          : new Uint8Array(macrocells.low.length);
        return uploadCells(gl, encodeCells(distances, detail ?? undefined), macrocells, {
          previous,
          device,
          samplerName: 'uEmptySpaceDistance',
        });
      });
      return { uniforms: { ...uniforms, uDetailPower: powerOfSteps(voxelsPerStep) }, units: [unit] };
    },
    dispose: () => gl.deleteTexture(cells.last?.unit.texture ?? null),
  };
}
