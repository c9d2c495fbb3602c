import type { Vector3 } from '../../src/volume/matrix.ts';
import { LookAttributes } from './look-attributes.ts';
import { flag, number, numberOrFlag, numberOrText, numbers, pair, size, vector } from './property-kinds.ts';
import { property } from './reflecting-element.ts';

/** Which data an author wants to see, and how their files are read. */
export class SourceAttributes extends LookAttributes {
  /**
   * URL of the data: a NIfTI, NRRD or MetaImage file, a mosaic image, a radar scan (ODIM_H5, CfRadial, NEXRAD Level II) or a JSON manifest.
   * Several URLs, separated by blanks, are scans in the order of time; a blank within a URL is written `%20`.
   */
  @property() src!: string | null;

  /** The files of `src` are one volume: images, a slice each, or a header and the files of its data; else they are scans in time. */
  @property({ kind: flag }) stack!: boolean;

  /** Tiles per row and column of a mosaic image, `COLUMNSxROWS`, row by row from the top left. */
  @property({ kind: size }) mosaic!: readonly [columns: number, rows: number] | null;

  /** Tiles of the mosaic that hold slices; all of them by default. */
  @property({ kind: number }) slices!: number | null;

  /**
   * World units per voxel, of a mosaic per pixel and slice: `x y z`. By default the file's own, or 1 1 1. A negative one
   * turns its axis round, for slices that run from head to feet, say.
   */
  @property({ kind: vector }) spacing!: Vector3 | null;

  /**
   * The grid that the data of a mosaic lie on: `cartesian`, or `spherical` for a radar's sweeps, one a tile.
   * @default cartesian
   */
  @property() coordinates!: string | null;

  /** Elevations of a radar's mosaic, degrees, one a tile: `0.5 1.2 2.4`. */
  @property({ kind: numbers }) elevations!: readonly number[] | null;

  /** Of a radar's mosaic: metres to the middle of the first gate, and from gate to gate. */
  @property({ kind: pair }) range!: readonly [first: number, step: number] | null;

  /** Of a radar's mosaic: middle of the first radial and step to the next, degrees clockwise from north; all around by default. */
  @property({ kind: pair }) azimuth!: readonly [first: number, step: number] | null;

  /**
   * Hides what touches nothing: parts of the volume above a value, as a head rest or specks, that are connected by faces of voxels neither to the largest part nor to one
   * of a tenth of its size. The value is where the volume begins to show by default; or write one, `clean="150"`, as where a `transfer-function` of yours shows lower values.
   * What is hidden is so for picks, slices and statistics too, and `volume.left` says how much it is. Of CT, MRI and the like; not of labels and radar scans.
   */
  @property({ kind: numberOrFlag }) clean!: boolean | number | 'none';

  /** The quantity of a radar scan, as its file names it: `DBZH`, `VRAD` ... By default its reflectivity. */
  @property() moment!: string | null;

  /** Of a radar scan: another quantity of its file, in whose colours the first one is shown: `VRADH` for reflectivity coloured by velocity. */
  @property({ attribute: 'color-moment' }) colorMoment!: string | null;

  /**
   * How a radar's beams run: `standard`, bent by the atmosphere over a round Earth (4/3 of its radius), or `straight`
   * over a flat one.
   * @default standard
   */
  @property({ attribute: 'beam-model' }) beamModel!: string | null;

  /** Heights of a radar scan are shown so many times as large; 5 by default, 1 where it reaches less than 50 km. */
  @property({ attribute: 'vertical-exaggeration', kind: number }) verticalExaggeration!: number | null;

  /**
   * Which of several scans is shown: a zero-based index, or a time in UTC, `2018-12-20T06:06:28Z`, for the latest scan at or
   * before it (the first one if all are later). By default the first. To set it shows that scan,
   * whichever `next`, `previous`, `play` or a person went to since; `scan` tells which one is shown.
   * @default 0
   */
  @property({ kind: numberOrText }) time!: number | string | null;

  /** Shows one of several scans after the other as soon as a source is open, without `play()`; begins again after the last. Where a person has asked their system for less motion, it waits for `play()`. */
  @property({ kind: flag }) autoplay!: boolean;

  /**
   * Scans a second, while they play, or as many as can be loaded and drawn; 2 by default.
   * @default 2
   */
  @property({ attribute: 'play-speed', kind: number }) playSpeed!: number | null;
}
