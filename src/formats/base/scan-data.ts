import type { DecodedCartesianVolume } from './decoded-volume.ts';

/** Where the numbers of one volume lie: kept by the browser outside of a page's own memory, or a part of a file. */
export type ScanBytes = Blob | { readonly url: string; readonly start: number; readonly end: number };

/** The pixels of some frames on a DICOMweb server. */
export interface WebPixels {
  readonly url: string;
  /** The number of the element that they are. */
  readonly id: number;
  /** How many frames the address asks for; null where it gives all pixels together. */
  readonly frames: number | null;
}

/** Bytes of a file from `start` up to `end`, which is not included. */
export interface FileRange {
  readonly start: number;
  readonly end: number;
}

/** Where frames lie in a file. */
export interface FramePlaces {
  readonly ranges: readonly FileRange[];
  /** Whether a frame is one or several pieces of packed pixels, each after its length. */
  readonly isPacked: boolean;
}

/** The same for a file on a server that sends parts of it. */
export interface FrameParts extends FramePlaces {
  readonly url: string;
}

/** Some frames of a file that has more, which are not read. */
export interface FramesOfFile {
  /** The file with the pixels of these frames alone, or up to its pixels. */
  readonly file: Blob;
  /** Where the pixels are, if they are not in the file: on a DICOMweb server, or further on in the file. */
  readonly pixels?: WebPixels;
  readonly parts?: FrameParts;
  /** Which ones, from 0, in the order of their pixels. */
  readonly frames: readonly number[];
}

/**
 * The files whose slices are one volume, which are decoded when it is shown: as they are kept by the browser, those of an
 * archive as gzip files, their URLs, or some of their frames. Only a reader knows how.
 */
export interface ScanFiles {
  readonly files: readonly (Blob | string | FramesOfFile)[];
  /** Of each slice, its file, by its place in `files`, and its picture in that file, from 0. */
  readonly slices: readonly (readonly [file: number, picture: number])[];
}

/** What all volumes of a file have in common: everything but their values. */
export type SeriesInfo = Omit<
  DecodedCartesianVolume,
  'samples' | 'slope' | 'intercept' | 'indexed' | 'rounded' | 'unkept'
>;

/**
 * One volume of a file, or of files, that hold several, as it is kept until it is shown. Readers make it when the file is opened, and a
 * page sends it back to the worker, so it is plain data.
 */
export type ScanData = ScanOfVolume | ScanOfSweeps | ScanOfFrame;

/** A frame of a video. Only the reader of manifests knows how. */
export interface ScanOfFrame {
  /** From 0. */
  readonly frame: number;
  /** The same object for all frames. */
  readonly video: object;
  /** What is said of this frame. */
  readonly manifest: object;
}

/** The files of a radar's scan, each a sweep of one quantity. Only their reader knows how. */
export interface ScanOfSweeps {
  /** As they are kept by the browser, those of an archive as gzip files, or their URLs; and the code of what each holds. */
  readonly sweeps: readonly (readonly [file: Blob | string, code: number])[];
}

/** A volume of voxels on the same grid as the others. */
export interface ScanOfVolume {
  readonly from: ScanBytes | ScanFiles;
  /** Name of the type of its numbers: 'int16'. */
  readonly type: string;
  readonly littleEndian: boolean;
  /** Value = slope * number + intercept. */
  readonly slope: number;
  readonly intercept: number;
  /** With its place in the file: 'NIfTI-1, volume 3 of 20'. */
  readonly format: string;
  /** The same object for all volumes of a file. */
  readonly series: SeriesInfo;
}

/** A volume whose numbers lie one after another. */
export type ScanNumbers = ScanOfVolume & { readonly from: ScanBytes };

export const hasFiles = (from: ScanOfVolume['from']): from is ScanFiles => 'slices' in from;

export const hasSweeps = (scan: ScanData | PlaceData): scan is ScanOfSweeps => 'sweeps' in scan;

export const isFrame = (scan: ScanData | PlaceData): scan is ScanOfFrame => 'video' in scan;

/** Whether the numbers of a volume lie one after another. */
export const hasNumbers = (scan: ScanData): scan is ScanNumbers =>
  !hasSweeps(scan) && !isFrame(scan) && !hasFiles(scan.from);

/** Some bytes of each of several volumes: the numbers of one place over all times. They are read as a volume of as many voxels. */
export type PlaceData = Omit<ScanOfVolume, 'from'> & { readonly from: readonly ScanBytes[] };
