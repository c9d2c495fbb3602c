/** The words of <volume-measure>. Numbers come as text, already written as the language writes them. */
export interface MeasureTerms {
  /** What is measured: names of the types. */
  readonly measure: Readonly<Record<'distance' | 'angle' | 'box' | 'sphere', string>>;
  /** The button that begins to place points. */
  readonly measureButton: string;
  /** The button that places them without pointing. */
  readonly measureMiddle: string;
  readonly measureCancel: string;
  /** What is said beside the button, of a measure without points. */
  readonly measureHint: string;
  /** While points are placed. */
  readonly measurePlace: (number: string, count: string) => string;
  readonly measurePoint: (number: string, count: string) => string;
  /** A number, and how much it may be off. */
  readonly plusMinus: (value: string, uncertainty: string) => string;
  readonly measureSize: string;
  readonly measureRadius: string;
  readonly measureVolume: string;
  readonly measureMean: string;
  readonly measureDeviation: string;
  /** Least and largest value. */
  readonly measureRange: string;
  readonly measureVoxels: string;
  readonly measureGates: string;
  /** A mean, and its standard error. */
  readonly measureWithError: (mean: string, error: string) => string;
  /** How many voxels, and how many of them the surface cuts. */
  readonly measureCut: (count: string, cut: string) => string;
  /** How many have data, and how many do not. */
  readonly measureWithoutData: (count: string, without: string) => string;
  /** There is nothing inside. */
  readonly measureNothing: string;
  readonly measureSummingUp: string;
  /** The volume is smaller than its file. */
  readonly measureReduced: string;
}
