import type { Vector3 } from '../../volume/matrix.ts';
import type { FlatPicture } from './flat-pictures.ts';
import type { Picture } from './picture.ts';
import type { ValueTable } from './value-table.ts';
import type { FileWindows } from './windows.ts';

/** A picture of a plane, or one of the tiles of a picture. */
export interface Frame {
  readonly picture: Picture;
  /** From 0, in its picture. */
  readonly index: number;
  readonly columns: number;
  readonly rows: number;
  /** Where it begins in its picture: columns and rows. */
  readonly corner: readonly [number, number];
  /** Of its series; it never leaves the reader. */
  readonly series: string;
  /** That the scanner gave the series. */
  readonly seriesNumber: number | undefined;
  readonly isLocalizer: boolean;
  /** Centre of its first pixel in mm, in DICOM's world (LPS); null where the file does not say it. */
  readonly position: Vector3 | null;
  readonly plane: Plane | null;
  /** Whether place and plane are the patient's, and not those of an ultrasound volume. */
  readonly ofPatient: boolean;
  /** World lengths from column to column, and from row to row; null where the file does not say it. */
  readonly spacing: readonly [number, number] | null;
  /** Height of a pixel for a width of 1, where the file says no more; 1 where it does not. */
  readonly aspect: number;
  /** To the next slice, as the file says; null where it does not. */
  readonly step: number | null;
  /** How thick the slice is in mm, as the file says; null where it does not. */
  readonly thickness: number | null;
  /** Which of several stacks of a file it belongs to; '' where the file does not say it. */
  readonly stack: string;
  /** In what order slices come that have no place. */
  readonly order: readonly number[];
  /** Turns stored numbers into others first; null where they are what they are. */
  readonly table: ValueTable | null;
  /** Value = slope * stored number, or that of the table, + intercept. */
  readonly slope: number;
  readonly intercept: number;
  readonly unit: string;
  /** Of its values. They are read when they are asked for: files may have thousands of frames. */
  readonly windows: () => FileWindows;
  /** What it is where it is no slice of a volume; null for a slice. */
  readonly flat: FlatPicture | null;
  /** What may differ between pictures of one plane. */
  readonly traits: ReadonlyMap<string, string | number>;
}

/** Unit vectors along a row, along a column, and across the plane. */
export interface Plane {
  readonly row: Vector3;
  readonly column: Vector3;
  readonly normal: Vector3;
}
