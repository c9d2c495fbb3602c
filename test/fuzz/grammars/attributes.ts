import { attributes as names } from '../judge-text.ts';
import type { Grammar } from '../fuzz-case.ts';

/** Pieces of what attributes hold, and of what looks like it. */
const pieces = [
  '0', '1', '9', '1.', '.5', '1.5', '-', '+', 'e', '1e', 'e5', '1e5', ' ', '  ', '\t', '\n', '\u00a0', ',', ', ', '%', '1%', '(', ')', '()', '((', '#', '#f', 'rgb(', 'rgb(1 2 3)', 'color(', 'hsl(0deg',
  'auto', 'auto ', 'deg', '1deg ', 'rad', 'x', '10x', '×', '1 red 0,', '0 red 0, ', 'red ', 'rgb(0 0 0 / 1) ', '1x1', 'T', ':', '2018-', 'Z', 'http://a/', 'a.nii ', '/', '\\', '"', "'", '&', '\0', '\ud83c', 'ﬁ', 'İ', 'none', '1,', '1, ', '00', '1e1 ', '/*', 'var(', 'calc(',
];

/** Pumped texts: something before, a piece again and again, something after, for each attribute. */
export const attributes: Grammar = (random) => {
  const some = (max: number): string => Array.from({ length: random.int(0, max) }, () => random.pick(pieces)).join('');
  return { attribute: random.pick(names), before: some(3), pump: some(2) || random.pick(pieces), after: some(2) };
};
