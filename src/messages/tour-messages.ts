/** The messages of <volume-tour>. Numbers are passed as text, already formatted for the language. */
export interface TourMessages {
  /** Name of a tour that has no name of its own. */
  readonly tour: string;
  readonly tourStart: string;
  readonly tourPrevious: string;
  readonly tourNext: string;
  /** Leaves the tour: the picture is again as before. */
  readonly tourLeave: string;
  /** The picture goes back to the open step, after a person has turned it. */
  readonly tourBack: string;
  /** Name of a step that has no heading. */
  readonly tourStep: (number: string) => string;
  /** Said when a step opens. */
  readonly tourStepOf: (number: string, count: string, title: string) => string;
  /** Said when a person has left the tour. */
  readonly tourLeft: string;
}
