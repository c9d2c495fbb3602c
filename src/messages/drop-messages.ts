/** The messages of <volume-drop> and <volume-series>. */
export interface DropMessages {
  readonly openFiles: string;
  readonly openFolder: string;
  /** What else a reader can do, and that the files stay where they are. */
  readonly dropHint: string;
  /** In the frame over the picture, while files are dragged over it. */
  readonly dropHere: string;
  readonly dropReading: string;
  /** What was dropped or pasted has no files in it. */
  readonly dropEmpty: string;
  /** What was read: the format, the voxels along the three axes, and how many files. */
  readonly dropRead: (format: string, size: string, count: string) => string;
  /** Name of the list of series. */
  readonly seriesList: string;
  /** The number that the scanner gave a series. */
  readonly seriesNumber: (number: string) => string;
  readonly seriesSlices: (count: string) => string;
  /** The number of the files of a volume that was not read yet. */
  readonly seriesFiles: (count: string) => string;
  /** How the slices of a series lie in the patient. */
  readonly seriesPlane: Readonly<Record<'axial' | 'coronal' | 'sagittal' | 'oblique', string>>;
}
