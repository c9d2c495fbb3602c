/** The words over a picture in which nothing is to be seen. */
export interface BlankTerms {
  /** Before the cause; but not where a radar met nothing, which is a right picture. */
  readonly blankPicture: string;
  /** Why, and what an author can do. */
  readonly blankCauses: {
    readonly noData: string;
    readonly transparent: string;
    /** Smallest and largest value of the volume. */
    readonly values: (low: string, high: string) => string;
    readonly labels: string;
    readonly cut: string;
    readonly sight: string;
    readonly faint: string;
    /** A radar scan without any echo. */
    readonly noEchoes: string;
    /** A radar scan whose echoes all are weaker than those that its colours show, which begin at this value. */
    readonly weakEchoes: (value: string) => string;
  };
}
