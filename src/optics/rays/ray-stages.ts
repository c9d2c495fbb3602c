import type { Vector3 } from '../../volume/matrix.ts';
import type { Ray } from './rays.ts';
import type { Premultiplied } from '../transfer/transfer-function.ts';

/** What is known of the data at a place of a ray. Twin: shaders, struct Sample, whose value is a share of the domain. */
export interface Sample {
  /** Data units; NaN where there is no data. */
  readonly value: number;
  readonly valid: boolean;
  /** What further field modules found there, by their own names. */
  readonly [more: string]: unknown;
}

/** Where a ray runs, in its t; entry >= exit where it does not. Twin: shaders/chunks/walk/interval.glsl */
export interface Interval {
  readonly entry: number;
  readonly exit: number;
  /** What stands at the exit; null where it is clear. */
  readonly behind: Premultiplied | null;
  /** A part of it that is cut out, t: between entry and exit when it is found. Absent where there is none. */
  readonly gap?: readonly [number, number];
}

/** A piece of a ray between two samples. Twin: shaders/chunks/walk/segment.glsl */
export interface Segment {
  readonly front: Sample;
  readonly back: Sample;
  /** Where it begins, and its length: in bounding diameters, from where the ray enters. */
  readonly begin: number;
  readonly span: number;
}

/** A piece of a line between two planes of voxels' centres, on which values are a cubic of its length; what is known at both ends. */
export interface CubicPiece {
  readonly from: number;
  readonly to: number;
  readonly front: Sample;
  readonly back: Sample;
}

/** The way of a ray through what is shown, by its length from there in bounding diameters. */
export interface Path {
  readonly total: number;
  /** Its pieces, of which there are two where a part of it is cut out. */
  readonly pieces: readonly (readonly [begin: number, end: number])[];
  sampleAt(along: number): Sample;
  /** Substeps that a step has at the least which begins there; 1 where absent. */
  leastSubstepsAt?(along: number): number;
  /** Where values kink on the way from one place to another, see `FieldStage.kinksAlong`; absent where it is not known. */
  kinksAlong?(from: number, to: number): readonly number[];
}

/** Shortens the interval that the stages before it left. */
export type IntervalStage = (ray: Ray, interval: Interval) => Interval;

/** What is there, on a grid of its own. */
export interface FieldStage {
  /** @param place - in the unit cube */
  sampleAt(place: Vector3): Sample;
  /** Whether values fold over between two: there is nothing in between then. */
  isFolded(from: number, to: number): boolean;
  /**
   * Where values kink on the way from one place of the unit cube to another, as shares of it: three at the most, between which values are
   * smooth. None on ways of more than a voxel. Absent where it is not known.
   */
  kinksBetween?(from: Vector3, to: Vector3): readonly number[];
  /** The same on a way of any length, ascending: between two of them values are a cubic of its length, or one and the same. */
  kinksAlong?(from: Vector3, to: Vector3): readonly number[];
}

/** Finds out more of a place whose value is known. */
export type SecondFieldStage = (place: Vector3, known: Sample) => Sample;

/** What values look like. */
export interface ClassifyStage {
  /** Colour and opacity of a piece of a ray. */
  classifySegment(segment: Segment): Premultiplied;
  /** Colour of a value, premultiplied, where the largest opacity of all counts as 1. */
  classifyValue(value: number): Premultiplied;
  /**
   * Into how many substeps a step is cut.
   * @param visible - share of what is here that reaches the eye
   * @param samples - what is known of the ends, of which one or both have data
   */
  countSubsteps(ends: readonly [number, number], visible: number, samples: readonly [Sample, Sample]): number;
}

/** Changes the colour of a piece of a ray, by what is there, and where the ray runs. */
export type ShadeStage = (segment: Segment, seen: Premultiplied, ray: Ray) => Premultiplied;

/** What the stages before it give to a gather stage. */
export interface Seen {
  readonly field: FieldStage;
  readonly classify: ClassifyStage;
  readonly ray: Ray;
  /** In bounding diameters. */
  readonly step: number;
  /** All that is known of a place of the unit cube. */
  sampleAt(place: Vector3): Sample;
  /** Classified and shaded. */
  seeSegment(segment: Segment): Premultiplied;
  /** Who wants to know what a segment comes to piece by piece, where it is not one alone: called for each, with its opacity. */
  readonly tell?: (piece: Segment, opacity: number) => void;
}

/** One ray's way through a gather stage. */
export interface Gathering {
  /** Called for all pieces of a ray, front to back. */
  add(segment: Segment): void;
  /** Substeps of a step of which one end has data, or both. */
  chooseSubsteps(front: Sample, back: Sample): number;
  /** Stands in for `add` where the path knows its kinks and steps may be cut: called for all pieces between two kinks, front to back. */
  addPiece?(piece: CubicPiece, path: Path): void;
  /** What the ray shows; `path` is null where it meets nothing. */
  finish(path: Path | null): Premultiplied;
}

/** What a ray comes to. */
export type GatherStage = (seen: Seen) => Gathering;

/** A ray in five stages, and how it is walked. */
export interface RayStages {
  readonly intervals: readonly IntervalStage[];
  readonly field: FieldStage;
  readonly moreFields: readonly SecondFieldStage[];
  readonly classify: ClassifyStage;
  readonly shades: readonly ShadeStage[];
  readonly gather: GatherStage;
  /** t at which rays begin. */
  readonly eyeT: number;
  /** In bounding diameters. */
  readonly step: number;
  /** No step is cut into more. */
  readonly maxSubsteps: number;
  /** Substeps that a step has at the least, by the macrocell in which it begins. @param place - in the unit cube */
  readonly leastSubsteps?: (place: Vector3) => number;
}
