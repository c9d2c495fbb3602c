/** The messages of the curve of values over time in a <volume-readout>. Numbers are passed as text, already formatted for the language. */
export interface CurveMessages {
  /** The hint while no place is kept. */
  readonly curveHint: string;
  /** The hint where the kept place has no value. */
  readonly curveNone: string;
  /** Help for the keys of the curve. */
  readonly curveKeys: string;
  /** While scans are being read. @param percent - of them */
  readonly curveReading: (percent: string) => string;
  /** The smallest and the largest value, each with its time. */
  readonly curveRange: (low: string, lowTime: string, high: string, highTime: string) => string;
  /** The number of times at which the place has no data. */
  readonly curveGaps: (count: string) => string;
  /** The number of scans that could not be read. */
  readonly curveFailed: (count: string, all: string) => string;
  /** No scan could be read; the error follows. */
  readonly curveProblem: string;
  /** Opens the values as a table. */
  readonly curveTable: string;
  /** In place of a value. */
  readonly noData: string;
}
