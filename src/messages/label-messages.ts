/** The messages of <volume-label-list>. Numbers are passed as text, already formatted for the language. */
export interface LabelMessages {
  /** Name of the whole list. */
  readonly labelList: string;
  /** Placeholder of the search field. */
  readonly findLabel: string;
  /** The button that shows all labels. */
  readonly allLabels: string;
  /** The button of a label that hides all other labels, and the same with the label's name. */
  readonly onlyThis: string;
  readonly onlyLabel: (name: string) => string;
  /** Name of the voxels without a label. */
  readonly otherParts: string;
  /** Number of the labels that are shown. */
  readonly labelsShown: (shown: string, count: string) => string;
  /** Number of the labels that are not listed. */
  readonly moreLabels: (count: string) => string;
  /** The volume has no labels. */
  readonly noLabels: string;
  readonly labelsComing: string;
  /** The page hides all labels: `<volume-labels hidden>`. */
  readonly labelsHidden: string;
  /** The search finds nothing. */
  readonly noSuchLabel: string;
}
