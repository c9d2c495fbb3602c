import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import type { Defines } from '../device/compose-stage.ts';
import type { Gl } from '../device/device.ts';
import type { TextureUnit } from '../device/texture-unit.ts';

/** What steps take that are cut by what is at their ends: few pages have some. */
export interface SubstepPart {
  /** GLSL: into how many substeps steps are cut, and how such a ray is walked. */
  readonly count: string;
  readonly walk: string;
  readonly defines: Defines;
  /**
   * What tells into how many substeps steps are cut; the same texture is filled again when it changes.
   * @param transferFunction - brightened
   * @param voxelRatio - length of a voxel / reference length, times the opacity factor
   */
  makeTable(gl: Gl, transferFunction: TransferFunction, voxelRatio: number, previous: WebGLTexture | null): TextureUnit;
}

let provided: SubstepPart | null = null;

/** It is loaded before such steps are asked for. */
export function provideSubsteps(part: SubstepPart): void {
  provided = part;
}

/** @throws {TypeError} where it was not provided */
export function substepPart(): SubstepPart {
  if (!provided) throw new TypeError('no substeps');
  return provided;
}
