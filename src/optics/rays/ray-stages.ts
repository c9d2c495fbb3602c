import type { Vector3 } from '../../volume/matrix.ts';
import type { Ray } from './rays.ts';
import type { Premultiplied } from '../transfer/transfer-function.ts';

/** The data at a place of a ray. Twin: shaders, struct Sample, whose value is a share of the domain. */
export interface Sample {
  /** Data units; NaN if there is no data. */
  readonly value: number;
  readonly valid: boolean;
  /** What further field modules found at this place, by their own names. */
  [more: string]: unknown;
}

/** The part of a ray that is drawn, in its t; empty if entry >= exit. Twin: shaders/chunks/walk/interval.glsl */
export interface Interval {
  readonly entry: number;
  readonly exit: number;
  /** The colour of what stands at the exit; null if nothing does. */
  readonly behind: Premultiplied | null;
  /** A part that is cut out, in t. When it is found, it lies between entry and exit. Absent if there is none. */
  readonly gap?: readonly [number, number];
}

/** A piece of a ray between two samples. Twin: shaders/chunks/walk/segment.glsl */
export interface Segment {
  readonly front: Sample;
  readonly back: Sample;
  /** Its start and its length: in bounding diameters, from the ray's entry. */
  readonly begin: number;
  readonly span: number;
}

/** A piece of a line between two planes of voxels' centres, with the samples at both ends. Along it, values are a cubic. */
export interface CubicPiece {
  readonly from: number;
  readonly to: number;
  readonly front: Sample;
  readonly back: Sample;
}

/** The path of a ray through the visible volume. Places on it are lengths from the ray's entry, in bounding diameters. */
export interface Path {
  readonly total: number;
  /** One piece, or two if a part of the path is cut out. */
  readonly pieces: readonly (readonly [begin: number, end: number])[];
  sampleAt(along: number): Sample;
  /** The smallest number of substeps of a step that begins at this place, see `RayStages`; 1 if absent. */
  minSubstepsAt?(along: number): number;
  /** Where values kink between two places, see `FieldStage.kinksAlong`; absent if this is not known. */
  kinksAlong?(from: number, to: number): readonly number[];
  /** Where other things may show between two places that lie between the same planes of voxels' centres, see `SecondFieldStage`. */
  turnsBetween?(from: number, to: number): readonly number[];
  /** How long a jump of the value between two places may be taken to be, see `FieldStage.jumpBetween`. */
  jumpBetween?(from: number, to: number): number;
}

/** Shortens the interval that the stages before it have left. */
export type IntervalStage = (ray: Ray, interval: Interval) => Interval;

/** The values of a volume, by places of its own grid. */
export interface FieldStage {
  /** @param place - in the unit cube */
  sampleAt(place: Vector3): Sample;
  /**
   * The sample a voxel away from a place along an axis, of the voxels that are shown at the place: light looks at both sides. As `sampleAt` if absent.
   * @param by - 1 or -1
   */
  sampleNextTo?(place: Vector3, axis: number, by: number): Sample;
  /** Whether values fold over between two: then values in between do not occur. */
  isFolded(from: number, to: number): boolean;
  /**
   * Where values kink on the way from one place of the unit cube to another, as shares of the way. There are at most three; between them
   * values are smooth. None on ways longer than a voxel. Absent if kinks are not known.
   */
  kinksBetween?(from: Vector3, to: Vector3): readonly number[];
  /** The same on a way of any length, ascending. Between two kinks, values are a cubic of the length, or constant. */
  kinksAlong?(from: Vector3, to: Vector3): readonly number[];
  /**
   * The edge of the larger voxel where two places are in voxels of two sizes, as in bricks of two levels, in edges of the finest one: values jump between
   * these places. 0 where they don't; they never do if absent.
   */
  jumpBetween?(from: Vector3, to: Vector3): number;
}

/**
 * Adds more to the sample of a place: to the sample itself, since a copy of each would take as long as all the rest. A field gives each place a sample of
 * its own.
 */
export interface SecondFieldStage {
  (place: Vector3, known: Sample): Sample;
  /**
   * Where a thing may show on a way although it shows at neither end, as on a way through a corner of the thing: a share of the way; null
   * if there is no such place. Both places lie in the unit cube, between the same planes of voxels' centres. Absent if it shows no things.
   */
  turnBetween?(from: Vector3, to: Vector3): number | null;
}

/** How values appear. */
export interface ClassifyStage {
  /** Colour and opacity of a piece of a ray. */
  classifySegment(segment: Segment): Premultiplied;
  /** Premultiplied colour of a value, if the largest of all opacities counts as 1. */
  classifyValue(value: number): Premultiplied;
  /**
   * Into how many substeps a step is cut.
   * @param visible - share of the light from here that reaches the eye
   * @param samples - at both ends; at least one has data
   */
  countSubsteps(ends: readonly [number, number], visible: number, samples: readonly [Sample, Sample]): number;
}

/** Changes the colour of a piece of a ray, depending on its samples and on the ray. */
export type ShadeStage = (segment: Segment, seen: Premultiplied, ray: Ray) => Premultiplied;

/** What a gather stage gets from the stages before it. */
export interface Seen {
  readonly field: FieldStage;
  readonly classify: ClassifyStage;
  readonly ray: Ray;
  /** In bounding diameters. */
  readonly step: number;
  /** The sample at a place of the unit cube, with all fields. */
  sampleAt(place: Vector3): Sample;
  /** Classifies and shades a segment. */
  seeSegment(segment: Segment): Premultiplied;
  /** Reports the pieces of a segment, if it has more than one: called for each piece, with its opacity. */
  readonly report?: (piece: Segment, opacity: number) => void;
}

/** The state of a gather stage for one ray. */
export interface Gathering {
  /** Called for each segment of a ray, front to back. */
  add(segment: Segment): void;
  /** Number of substeps of a step. At least one of its ends has data. */
  chooseSubsteps(front: Sample, back: Sample): number;
  /** Replaces `add` if the path knows its kinks and steps may be cut: called for each piece between two kinks, front to back. */
  addPiece?(piece: CubicPiece, path: Path): void;
  /** Returns the colour of the ray; `path` is null if the ray meets nothing. */
  finish(path: Path | null): Premultiplied;
}

/** Adds up all segments of a ray. */
export type GatherStage = (seen: Seen) => Gathering;

/** A ray's five stages, and how the ray is divided into steps. */
export interface RayStages {
  readonly intervals: readonly IntervalStage[];
  readonly field: FieldStage;
  readonly moreFields: readonly SecondFieldStage[];
  readonly classify: ClassifyStage;
  readonly shades: readonly ShadeStage[];
  readonly gather: GatherStage;
  /** t where rays begin. */
  readonly eyeT: number;
  /** In bounding diameters. */
  readonly step: number;
  /** A step is cut into at most this many substeps. */
  readonly maxSubsteps: number;
  /**
   * The smallest number of substeps of a step, by the macrocell in which it begins; below 1, as many steps are taken as one as it goes into 1.
   * @param place - in the unit cube
   * @param forward - how far a step moves it
   */
  readonly minSubsteps?: (place: Vector3, forward: Vector3) => number;
}
