import { directionOf } from '../../lesson-writers/src/direction-of.ts';

/** The language of the page, and the direction in which it is written. @param language - as in the attribute `lang` of HTML */
export function setLanguage(language: string): void {
  document.documentElement.lang = language;
  document.documentElement.dir = directionOf(language);
}
