/** The words of the sign for what of a file is not in the picture. What it is follows in English. */
export interface NoticeTerms {
  /** Name of the sign. @param count - of what it tells */
  readonly notices: (count: string) => string;
  /** Above what it tells. */
  readonly noticesAre: string;
  /** A volume was made smaller. Both are voxels along its three axes, like `512 × 512 × 300`. */
  readonly madeSmaller: (from: string, to: string) => string;
}
