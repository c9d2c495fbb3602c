/** The messages of <volume-compare>. */
export interface CompareMessages {
  /** Name of the divider between two pictures. */
  readonly compareDivider: string;
}
