/** The words of <volume-label-list>. Numbers come as text, already written as the language writes them. */
export interface LabelTerms {
  /** Name of all of it. */
  readonly labelList: string;
  /** In the field that searches. */
  readonly findLabel: string;
  /** On the button that shows all of them. */
  readonly allLabels: string;
  /** On the button of a label that hides all others, and the same with the label's name. */
  readonly onlyThis: string;
  readonly onlyLabel: (name: string) => string;
  /** What has no label. */
  readonly otherParts: string;
  /** How many are shown. */
  readonly labelsShown: (shown: string, count: string) => string;
  /** So many more are not listed. */
  readonly moreLabels: (count: string) => string;
  /** The volume has none. */
  readonly noLabels: string;
  readonly labelsComing: string;
  /** The search finds nothing. */
  readonly noSuchLabel: string;
}
