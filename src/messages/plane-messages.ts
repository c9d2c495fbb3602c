/** The messages of the editor of values and gradients. */
export interface PlaneMessages {
  /** Name of the chart. */
  readonly valuesAndGradients: string;
  /** For a volume of labels, which has no gradients. */
  readonly noGradients: string;
  readonly boxOf: (number: string, count: string) => string;
  readonly gaussianOf: (number: string, count: string) => string;
  /** Name of the grip that changes the size of a box or a Gaussian. @param name - `boxOf` or `gaussianOf` */
  readonly sizeOf: (name: string) => string;
  readonly patchState: (values: string, gradients: string, opacity: string, color: string) => string;
  /** Help for the keys. */
  readonly patchKeys: string;
  /** The hint while there are no boxes and no Gaussians. */
  readonly drawBox: string;
  readonly valueFrom: string;
  readonly valueTo: string;
  readonly gradientFrom: string;
  readonly gradientTo: string;
  readonly middleValue: string;
  readonly middleGradient: string;
  readonly valueWidth: string;
  readonly gradientWidth: string;
  readonly colorOfPatch: string;
  readonly addBox: string;
  readonly addGaussian: string;
  readonly removePatchTip: string;
}
