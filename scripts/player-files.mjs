/** What a page of a lesson loads, of the folder dist of the element. */
export const playerFiles = [
  'volume-view.iife.js',
  'volume-view.css',
  'x3dom.js',
  'classic',
  'embed.js',
  'embed.css',
  'h5p.js',
  'THIRD-PARTY-LICENSES.txt',
];
