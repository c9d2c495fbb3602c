// What the page says. Readers see the button, so it is in their language; the rest is for the author of the frame, in English.

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

/** @param languages - of the page, then those of the reader */
export function wordOfShow(languages: readonly string[]): string {
  const known = languages.map((one) => one.toLowerCase().split('-')[0]).find((one) => Object.hasOwn(showWords, one));
  return showWords[known ?? 'en'];
}

export const english = {
  nothing: 'No volume',
  nothingHint:
    'This page shows a volume or a lesson; its address has to name one: embed.html?src=scan.nii.gz or embed.html?lesson=lesson.html',
  problems: 'Not all of the address of this frame is used:',
  lessonRefused: 'This lesson is not shown, as a part of it is not allowed:',
  lessonFailed: 'The lesson could not be loaded.',
  lessonStatus: (status: number) => `The lesson could not be loaded: its server answered with HTTP status ${status}.`,
  lessonBlocked:
    'The lesson could not be read. Either it is not there, or its server does not allow this page to read it: it has to send Access-Control-Allow-Origin: *',
  lessonLarge: 'The lesson has more text than this page reads.',
  playerFailed: 'The script volume-view.iife.js could not be loaded; expected it in the folder of this page.',
  place: (folder: string, src: string) =>
    `Addresses count from the folder of this page, ${folder}. If the file is in the folder above it, write src=${src}`,
};
