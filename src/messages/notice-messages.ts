/** The messages of the sign for parts of a file that are not in the picture. The notices themselves are in English. */
export interface NoticeMessages {
  /** Name of the sign. @param count - number of notices */
  readonly notices: (count: string) => string;
  /** The headline above the notices. */
  readonly noticesAre: string;
  /** The resolution of a volume was reduced. Both texts are numbers of voxels along its three axes, like `512 × 512 × 300`. */
  readonly madeSmaller: (from: string, to: string) => string;
}
