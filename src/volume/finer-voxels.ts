import type { GridFrame } from './grid.ts';
import type { Macrocells } from './macrocells.ts';
import type { Matrix4, Vector3 } from './matrix.ts';

/**
 * A level of a pyramid that is read in bricks. `indexToWorld` is what the file says. So the place of a voxel in another level follows from both
 * matrices, and not from the factors alone: many files have their coarse voxels half a voxel away from where the factors put them.
 */
export interface FinerLevel extends GridFrame {
  /** Bricks along i, j and k: those at the upper ends may reach over the end. */
  readonly bricks: Vector3;
  /**
   * Voxels of the finest level that one voxel has along i, j and k: whole numbers from 1, not always powers of two, nor the same along all axes. Brick
   * `at` of the finest level lies in brick `floor(at / factors)` of this level (no further than its last one): the place of any of its points is at
   * most half a voxel outside that brick, and so between voxels that the brick has.
   */
  readonly factors: Vector3;
}

/** What finer voxels change of a volume: its own voxels are means, and these have smaller and larger values. */
export interface BrickedValues {
  readonly macrocells: Macrocells;
  /** Of data values. */
  readonly range: readonly [number, number];
  readonly slope: number;
  readonly intercept: number;
}

/** Voxels that are smaller than those of a volume, at some of its places: bricks of the finer levels of its pyramid. */
export interface FinerVoxels {
  /** What the renderer's `FieldProvider` has: who makes such voxels has loaded the code that uploads them. */
  readonly upload: (...given: never[]) => unknown;
  /** The grid of the pyramid's finest level over the volume's own unit cube: light counts changes from one of its voxels to the next. */
  readonly finest: GridFrame;
  /** The same for the finest level of which something is there now: it says how finely rays have to be sampled. */
  readonly grid: GridFrame;
  /** Whether more of them are on their way for the present view: pictures are not final. */
  readonly moving: boolean;
  /** What the voxels that are not there leave in the present picture, in 1/255, as far as it is known: see `ErrorPart`. */
  readonly error: { readonly rms: number; readonly p99: number; readonly max: number | null } | null;
  /** What the GPU has: bricks, and all bytes. */
  readonly held: { readonly count: number; readonly bytes: number };
  /**
   * The volume with the macrocells and the range of values of now: another object if they have changed since the last call, so that what is made of them is made again.
   */
  current<V extends BrickedValues>(volume: V): V;
  /** The stored value at a place of the unit cube, of the volume itself where nothing finer is there; NaN for no data. */
  storedAt(place: Vector3): number;
  /** The same a voxel away from a place along an axis: of the voxels that are shown at the place, also where others are shown there. @param by - 1 or -1 */
  storedNextTo(place: Vector3, axis: number, by: number): number;
  /** The value of the nearest voxel that is there; undefined where the volume itself says more. */
  nearestAt(place: Vector3): number | undefined;
  /** Planes of them; null before they can be read. */
  readonly planes: PlaneVoxels | null;
  /** Where values kink along a line between two places of the unit cube, see `FieldStage.kinksAlong`; also right before and behind faces over which they may jump. */
  kinksAlong(from: Vector3, to: Vector3): readonly number[];
  /** Edges of the voxel at a place, in the unit cube. */
  voxelAt(place: Vector3): Vector3;
}

/** A plane or a slab that is looked at. */
export interface ViewedPlane {
  /** Pixels. */
  readonly width: number;
  readonly height: number;
  /** World: the middle of the first pixel, and from one pixel to the next. */
  readonly first: Vector3;
  readonly across: Vector3;
  readonly down: Vector3;
  /** World, from one side of the slab to the other, around the plane; zeros for a plane. */
  readonly way: Vector3;
  readonly isNearest: boolean;
}

/** What a plane shows now. */
export interface PlaneField {
  /** Of the level that is read. */
  readonly worldToIndex: Matrix4;
  /** The stored value at a place of that level, whole numbers at the middles of voxels; NaN where there is none. Where its voxels have not come, those of the volume. */
  readonly sampleAt: (x: number, y: number, z: number) => number;
  /** Planes of voxels in the slab; 1 for a plane. */
  readonly planes: number;
  /** Resolves when nothing more comes for this plane. */
  readonly done: Promise<void>;
}

/** Finer voxels for planes and places: they are read where somebody looks, without the GPU. */
export interface PlaneVoxels {
  /**
   * Begins to read what a plane needs, at the level that suits its pixels.
   * @param owner - who looks: this plane takes the place of its last one
   * @param changed - more has come: the plane has to be painted again
   * @returns null where the volume itself is as fine as the pixels
   */
  open(owner: object, plane: ViewedPlane, changed: () => void): PlaneField | null;
  /** Nobody looks any more. */
  close(owner: object): void;
  /** Reads the finest voxels at a place of the unit cube, for `FinerVoxels.nearestAt`. It does not reject: what cannot be read stays as it is. */
  readAt(place: Vector3): Promise<void>;
}
