import type { MeshSpace } from '../formats/meshes/mesh.ts';
import type { TerrainRadar } from '../formats/terrain/make-terrain.ts';

/** The surface to load. */
export type SurfaceRequest = MeshRequest | TerrainRequest;

interface AnySurface {
  /** URL of the first file, absolute. */
  readonly url: string;
}

/** A mesh from a file. */
export interface MeshRequest extends AnySurface {
  readonly surface: 'mesh';
  /** null for what the file says, or else `ras`. */
  readonly space: MeshSpace | null;
}

/** The ground under a radar. */
export interface TerrainRequest extends AnySurface {
  readonly surface: 'terrain';
  /** URLs of all files, absolute. */
  readonly files: readonly string[];
  /** Degrees north and east of the south-west corner of a single file; null to take it from the files' names. */
  readonly corner: readonly [south: number, west: number] | null;
  readonly radar: TerrainRadar;
}
