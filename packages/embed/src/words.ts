// What the page says to the author of the frame.

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
