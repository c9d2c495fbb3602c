import type { Vector3 } from '../../src/volume/matrix.ts';
import { LookAttributes } from './look-attributes.ts';
import { flag, number, numberOrFlag, numberOrText, numbers, pair, size, vector } from './property-kinds.ts';
import { property } from './reflecting-element.ts';

/** The attributes that say which data to show, and how to read the files. */
export class SourceAttributes extends LookAttributes {
  /**
   * URL of the data: a NIfTI, NRRD or MetaImage file or one of more formats, a mosaic image, a radar scan (ODIM_H5, CfRadial, NEXRAD Level II), a JSON
   * manifest, a ZIP archive that holds one volume, or the folder of an OME-Zarr (`brain.ome.zarr`).
   * Several URLs, separated by blanks, are scans in the order of time, and so are the volumes of one file that holds several; a blank
   * within a URL is written `%20`.
   */
  @property() src!: string | null;

  /** The files of `src` are one volume: images, one for each slice, or a header and its data files. Without it they are scans in time. */
  @property({ kind: flag }) stack!: boolean;

  /** Tiles per row and column of a mosaic image, `COLUMNSxROWS`, row by row from the top left. */
  @property({ kind: size }) mosaic!: readonly [columns: number, rows: number] | null;

  /** Number of tiles of the mosaic that contain slices; by default all of them. */
  @property({ kind: number }) slices!: number | null;

  /**
   * World units per voxel; for a mosaic, per pixel and slice: `x y z`. By default as in the file, or 1 1 1. A negative number reverses its
   * axis, for instance for slices that run from head to feet.
   */
  @property({ kind: vector }) spacing!: Vector3 | null;

  /**
   * The grid of the data in a mosaic: `cartesian`, or `spherical` for the sweeps of a radar, one in each tile.
   * @default cartesian
   */
  @property() coordinates!: string | null;

  /** Elevations of the mosaic of a radar, degrees, one for each tile: `0.5 1.2 2.4`. */
  @property({ kind: numbers }) elevations!: readonly number[] | null;

  /** For the mosaic of a radar: distance to the middle of the first gate, and from gate to gate, in metres. */
  @property({ kind: pair }) range!: readonly [first: number, step: number] | null;

  /** For the mosaic of a radar: middle of the first radial and step to the next, degrees clockwise from north; by default a full circle. */
  @property({ kind: pair }) azimuth!: readonly [first: number, step: number] | null;

  /**
   * Which volume is shown where the files hold several, as a folder of DICOM may: a number from 1, in the order of `volume.series`. By
   * default the largest file, and of series of DICOM the one with the most voxels.
   */
  @property({ kind: number }) series!: number | null;

  /**
   * The bytes that the shown level of an OME-Zarr may have at most, `50e6` for 50 MB; by default what the device holds. A coarser level is read where
   * one does not fit, and `volume.reduced` says so. It turns off bricks, see `max-gpu-bytes`.
   */
  @property({ attribute: 'max-bytes', kind: number }) maxBytes!: number | null;

  /**
   * Shows an OME-Zarr that is larger than so many bytes in bricks of finer levels, which take at most these bytes of the GPU's memory: `256e6` for 256 MB. All
   * elements of a page share what the largest of these numbers says. By default bricks come where the device does not hold the finest level, in 256 MiB, or 128 on small
   * devices.
   */
  @property({ attribute: 'max-gpu-bytes', kind: number }) maxGpuBytes!: number | null;

  /**
   * Whether cookies and logins are sent to other servers than the page's own, as for `<img crossorigin>`: `anonymous` or `use-credentials`. It counts for all that the
   * element fetches, also for elements inside.
   * @default anonymous
   */
  @property({ attribute: 'crossorigin' }) crossOrigin!: string | null;

  /**
   * Hides isolated parts, such as a head rest or specks. It looks at all voxels above a value. A part is hidden if no voxel faces connect
   * it to the largest part or to a part of at least a tenth of its size. By default the value is where the volume begins to be visible. You
   * can set the value, `clean="150"`, for instance if your `transfer-function` shows lower values. Picks, slices and statistics ignore
   * hidden parts too, and `volume.left` says how much is hidden. It works for CT, MRI and similar data; not for labels and radar scans.
   */
  @property({ kind: numberOrFlag }) clean!: boolean | number | 'none';

  /** The quantity of a radar scan, as its file names it: `DBZH`, `VRAD` ... By default the reflectivity. */
  @property() moment!: string | null;

  /** For a radar scan: another quantity of its file that colours the first one: `VRADH` for reflectivity coloured by velocity. */
  @property({ attribute: 'color-moment' }) colorMoment!: string | null;

  /**
   * Path of the beams of a radar: `standard`, bent by the atmosphere over a round Earth (4/3 of its radius), or `straight` over a flat one.
   * @default standard
   */
  @property({ attribute: 'beam-model' }) beamModel!: string | null;

  /** Factor by which heights of a radar scan are enlarged; 5 by default, 1 where the range is less than 50 km. */
  @property({ attribute: 'vertical-exaggeration', kind: number }) verticalExaggeration!: number | null;

  /**
   * Which of several scans is shown: a zero-based index, or a time in UTC, `2018-12-20T06:06:28Z`, for the latest scan at or before it (the
   * first one if all are later); `12.5 s` where a file counts from its start. By default the first. Setting it shows that scan, even if `next`, `previous`, `play` or a person chose
   * another one since; `scan` says which one is shown.
   * @default 0
   */
  @property({ kind: numberOrText }) time!: number | string | null;

  /**
   * Shows several scans one after the other as soon as a source is open, without `play()`, and starts again after the last. If a person has
   * asked their system for less motion, it waits for `play()`.
   */
  @property({ kind: flag }) autoplay!: boolean;

  /**
   * Scans per second while they play, or as many as can be loaded and drawn; 2 by default.
   * @default 2
   */
  @property({ attribute: 'play-speed', kind: number }) playSpeed!: number | null;
}
