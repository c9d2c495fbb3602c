// The one word that a reader sees before the element is there.

/** Of the button over a poster, by languages. */
const showWords: Readonly<Record<string, string>> = {
  en: 'Show in 3D',
  de: 'In 3D zeigen',
  es: 'Ver en 3D',
  fr: 'Afficher en 3D',
  ja: '3D\u3067\u8868\u793a',
  pt: 'Ver em 3D',
  zh: '\u4ee5 3D \u663e\u793a',
  ar: '\u0639\u0631\u0636 \u062b\u0644\u0627\u062b\u064a \u0627\u0644\u0623\u0628\u0639\u0627\u062f',
};

/** @param languages - those that are wanted, the best first */
export function wordOfShow(languages: readonly string[]): string {
  const known = languages.map((one) => one.toLowerCase().split('-')[0]).find((one) => Object.hasOwn(showWords, one));
  return showWords[known ?? 'en'];
}
