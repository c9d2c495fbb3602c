import type { PictureDifference } from './compare-pictures.ts';
import type { StudyMethod } from '../../src/renderer/study.ts';
import type { PaperFactors } from './study-gl.ts';

/** How the tables and charts call the methods. */
export const methodNames: Readonly<Record<StudyMethod, string>> = {
  printed: '2011 paper, as printed',
  plain: 'Plain samples',
  shipped: 'volume-view',
};

/** Errors of a method with a number of steps, against the converged limit. */
export interface ErrorRow extends PictureDifference {
  readonly method: StudyMethod;
  readonly steps: number;
}

/** Errors on a coarser grid: against the limit of that grid, and against the limit of the full one. */
export interface ResolutionRow {
  readonly method: StudyMethod;
  readonly steps: number;
  readonly own: PictureDifference;
  readonly full: PictureDifference;
}

export interface ResolutionResults {
  /** Voxels left along each axis. */
  readonly percent: 50 | 25;
  readonly dimensions: readonly number[];
  /** Steps of the limit on this grid. */
  readonly limitSteps: number;
  /** What the coarser grid costs, however many steps are taken: its limit against the full grid's. */
  readonly data: PictureDifference;
  readonly rows: readonly ResolutionRow[];
}

export interface FunctionResults {
  readonly id: string;
  readonly name: string;
  readonly limit: {
    readonly steps: number;
    /** The limit against the same with half the steps, on a coarser picture: how settled it is. */
    readonly half: PictureDifference;
    /** Against the reference in float64 with the same steps, on some rays; any channel, 1/255. */
    readonly reference: { readonly rays: number; readonly rms: number; readonly worst: number };
  };
  /** Samples that one step a voxel takes outside of empty cells, on the mean of some rays, for each step. */
  readonly samplesPerStep: number;
  /** The paper's factors that come closest to the limit. */
  readonly paper: PaperFactors;
  readonly errors: readonly ErrorRow[];
  readonly resolution: readonly ResolutionResults[];
  /** For 16-bit data: the same data in 8 bits, converged and with one step a voxel, against the limit of 16 bits. */
  readonly eightBits: { readonly limit: PictureDifference; readonly atVoxel: PictureDifference } | null;
}

export interface TimeRow {
  readonly percent: 100 | 50 | 25;
  readonly method: StudyMethod;
  readonly steps: number;
  /** Median, GPU finished. */
  readonly ms: number;
}

export interface SceneResults {
  readonly id: string;
  readonly name: string;
  readonly dimensions: readonly number[];
  readonly bits: number;
  /** Steps on the longest ray that give one sample a voxel: what `steps="auto"` takes. */
  readonly voxelSteps: number;
  /** Share of the picture's pixels whose rays meet the volume. */
  readonly covered: number;
  readonly functions: readonly FunctionResults[];
  /** None where the scene was not timed. */
  readonly times: readonly TimeRow[];
}

export interface StudyResults {
  readonly where: {
    readonly browser: string;
    readonly renderer: string;
    readonly software: boolean;
    readonly threads: number;
    /** What the program knows of the machine. */
    readonly note?: string;
  };
  /** Pixels along each side, where errors and where times were measured. */
  readonly size: number;
  readonly timeSize: number;
  readonly channelBits: number;
  readonly repeats: number;
  readonly scenes: readonly SceneResults[];
  /** Names of scenes whose data are not here. */
  readonly leftOut: readonly string[];
}

/** Round to four digits, so that stored results stay readable and last digits do not matter. */
export function roundResults<T>(value: T): T {
  if (typeof value === 'number') return (Number.isInteger(value) ? value : Number(value.toPrecision(4))) as T;
  if (Array.isArray(value)) return value.map((item: unknown) => roundResults(item)) as T;
  if (value === null || typeof value !== 'object') return value;
  return Object.fromEntries(
    Object.entries(value).map(([key, item]: [string, unknown]) => [key, roundResults(item)]),
  ) as T;
}
