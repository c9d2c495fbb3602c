// The gallery: the pictures of the demos, each of which leads to its page of the guide.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

/** By the name of a demo: its page of the guide. @type {Readonly<Record<string, string>>} */
export const pagesOfDemos = {
  lit: 'lighting',
  cut: 'cutting',
  'iso-surfaces': 'iso-surfaces',
  labels: 'labels',
  notes: 'notes',
  tour: 'tours',
  'brain-lesson': 'lesson',
  'storm-lesson': 'questions',
  compare: 'compare',
  'open-files': 'open-files',
  workspace: 'companions',
  slices: 'slices',
  projection: 'projection',
  styles: 'x3d-styles',
  measure: 'measuring',
  pointing: 'pointing',
  'over-time': 'scans-in-time',
  video: 'scans-in-time',
  pictures: 'scans-in-time',
  layers: 'layers',
  microscopy: 'data',
  large: 'data',
  radar: 'radar',
  surfaces: 'surfaces',
  'one-tag': 'first-steps',
  presets: 'looks',
  'transfer-function': 'transfer-functions',
  companions: 'companions',
  camera: 'camera',
  css: 'styling',
  many: 'quality',
  shapes: 'shapes',
};

/** @param {string} root - of the project @returns {{ html: string, images: string[], left: string[] }} `left`: demos without a page of the guide */
export function writeGallery(root) {
  const index = readFileSync(join(root, 'demos/index.html'), 'utf8');
  const [images, left] = [/** @type {string[]} */ ([]), /** @type {string[]} */ ([])];
  const cards = [...index.matchAll(/<li><a href="([\w-]+)\.html">.*?<h3>(.*?)<\/h3><p>(.*?)<\/p><\/a><\/li>/g)].flatMap(
    ([, name, title, text]) => {
      if (!(name in pagesOfDemos)) {
        left.push(name);
        return [];
      }
      const image = `demos/images/${name}.webp`;
      images.push(image);
      return `<li><a href="docs/guide/${pagesOfDemos[name]}.html"><img src="${image}" width="400" height="300" alt="" loading="lazy"><h2>${title}</h2><p>${text}</p></a></li>`;
    },
  );
  const html = `<h1>Gallery</h1>\n<p>The element itself made these pictures. Each one leads to the page that shows how, with an example that you can change.</p>\n<ul class="cards">\n${cards.join('\n')}\n</ul>\n`;
  return { html, images, left };
}
