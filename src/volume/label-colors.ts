/**
 * Colours for labels that have none. Neighbours in this list, and so labels that follow one another, differ in hue and
 * lightness.
 */
export const labelColors = [
  '#e5604c',
  '#58a3ea',
  '#f4b942',
  '#62bd6f',
  '#b57bdc',
  '#43c4c4',
  '#f291b4',
  '#a3c843',
  '#8490ec',
  '#eb9147',
  '#70d6a4',
  '#d868a8',
];
