import { maxHalfSpaces } from '../../../optics/rays/clip-intervals.ts';
import type { Cutout, HalfSpace } from '../../../optics/rays/clip-intervals.ts';
import { changePerVoxel, measureBox } from '../../../optics/rays/cut-fade.ts';
import type { CutFaces } from '../../../optics/rays/cut-fade.ts';
import type { PlaneSlice } from '../../../optics/attachments/plane-slices.ts';
import type { Matrix4, Vector3 } from '../../../volume/matrix.ts';
import type { VolumeData } from '../../../volume/volume.ts';
import type { Uniforms } from '../../device/inputs.ts';
import type { RayCut } from '../ray-module.ts';

/** The cuts of rays, in addition to the bounds of the volume and of a region. */
export type CutsOfRays = Pick<CutFaces, 'halfSpaces' | 'unitToCutout'>;

/** The faces of the cuts: half-spaces that are kept, and a box that is cut out. Slices do not cut the volume. */
export function cutsOf(cuts: readonly RayCut[]): CutsOfRays {
  const items = cuts.flatMap((cut) => cut.items as readonly (HalfSpace | Cutout | PlaneSlice)[]);
  return {
    halfSpaces: items.filter((item) => item.kind === 'half-space'),
    unitToCutout: items.find((item) => item.kind === 'cutout')?.unitToBox ?? null,
  };
}

/** A distance that is larger than any volume: far inside or far outside of a face. */
const far = 1e9;

/** The uniforms of shaders/chunks/shade/lit-cuts.glsl. */
export function cutUniforms({ halfSpaces, unitToCutout, unitToRegion }: CutFaces, volume: VolumeData): Uniforms {
  const { dimensions } = volume.finer?.finest ?? volume.grid;
  const planes = Array.from({ length: maxHalfSpaces }, (_, i) => {
    const plane = halfSpaces[i];
    if (!plane) return [0, 0, 0, far];
    const perVoxel = changePerVoxel(plane.normal, dimensions);
    return [...plane.normal, -plane.offset].map((x) => x / perVoxel);
  });
  const [uClipVoxelsA, uClipVoxelsB, uClipVoxelsC] = [0, 4, 8].map((first) => planes.slice(first, first + 4).flat());
  const uCutoutInVoxels = unitToCutout
    ? boxColumns(unitToCutout, dimensions)
    : [0, 0, 0, -far, 0, 0, 0, -far, 0, 0, 0, -far, 0, 0, 0, 0];
  return {
    uClipVoxelsA,
    uClipVoxelsB,
    uClipVoxelsC,
    uCutoutInVoxels,
    uRegionInVoxels: boxColumns(unitToRegion, dimensions),
  };
}

export function hasCuts({ halfSpaces, unitToCutout }: CutsOfRays): boolean {
  return halfSpaces.length > 0 || unitToCutout !== null;
}

function boxColumns(unitToBox: Matrix4, dimensions: Vector3): number[] {
  const { rows, size } = measureBox(unitToBox, dimensions);
  return [...rows.flat(), ...size, 0];
}
