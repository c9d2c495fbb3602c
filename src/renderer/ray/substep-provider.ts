import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import type { Defines } from '../device/compose-stage.ts';
import type { Gl } from '../device/device.ts';
import type { TextureUnit } from '../device/texture-unit.ts';

/** The code for steps that the samples at their ends cut into substeps: only few pages need it. */
export interface SubstepPart {
  /** GLSL that counts the substeps of a step. `walk` is the GLSL that walks such a ray. */
  readonly count: string;
  readonly walk: string;
  readonly defines: Defines;
  /**
   * Make the table that says into how many substeps a step is cut. When the table changes, the same texture is filled again.
   * @param transferFunction - after `brighten`
   * @param voxelRatio - length of a voxel / reference length, times the opacity factor
   */
  makeTable(gl: Gl, transferFunction: TransferFunction, voxelRatio: number, previous: WebGLTexture | null): TextureUnit;
}

let provided: SubstepPart | null = null;

/** Set the code; call it before the first use of such steps. */
export function provideSubsteps(part: SubstepPart): void {
  provided = part;
}

/** @throws {TypeError} if the code was not provided */
export function substepPart(): SubstepPart {
  if (!provided) throw new TypeError('no substeps');
  return provided;
}
