/** The messages of <volume-measure>. Numbers are passed as text, already formatted for the language. */
export interface MeasureMessages {
  /** Names of the types of measures. */
  readonly measure: Readonly<Record<'distance' | 'angle' | 'box' | 'sphere', string>>;
  /** The button that starts to place points. */
  readonly measureButton: string;
  /** The button that places the points around the middle, without a pointer. */
  readonly measureMiddle: string;
  readonly measureCancel: string;
  /** The hint next to the button, while a measure has no points. */
  readonly measureHint: string;
  /** The prompt while points are being placed. */
  readonly measurePlace: (number: string, count: string) => string;
  readonly measurePoint: (number: string, count: string) => string;
  /** A number and its uncertainty. */
  readonly plusMinus: (value: string, uncertainty: string) => string;
  readonly measureSize: string;
  readonly measureRadius: string;
  readonly measureVolume: string;
  readonly measureMean: string;
  readonly measureDeviation: string;
  /** Smallest and largest value. */
  readonly measureRange: string;
  readonly measureVoxels: string;
  readonly measureGates: string;
  /** A mean, and its standard error. */
  readonly measureWithError: (mean: string, error: string) => string;
  /** Number of voxels, and number of voxels on the surface of the measure. */
  readonly measureCut: (count: string, cut: string) => string;
  /** Number of places with data, and number of those without. */
  readonly measureWithoutData: (count: string, without: string) => string;
  /** The measure contains no values. */
  readonly measureNothing: string;
  readonly measureSummingUp: string;
  /** The volume has less resolution than its file. */
  readonly measureReduced: string;
}
