/** The messages over a picture in which nothing is visible. */
export interface BlankMessages {
  /** Goes before the cause; not used where a radar has no echoes, as that picture is correct. */
  readonly blankPicture: string;
  /** The cause, and what an author can do. */
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
    /** A radar scan whose echoes are all too weak to have a colour: the colours begin at this value. */
    readonly weakEchoes: (value: string) => string;
  };
}
