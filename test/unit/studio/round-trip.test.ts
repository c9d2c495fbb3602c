// The studio opens what it wrote, in each form, and writes the same bytes again.
import { expect } from '@esm-bundle/chai';
import { endingOf, openLesson, writeLesson } from '../../../packages/studio/src/data/export-lesson.ts';
import type { ExportKind, ExportOptions } from '../../../packages/studio/src/data/export-lesson.ts';
import type { LessonData } from '../../../packages/studio/src/data/prepare.ts';
import type { LessonFile } from '../../../packages/lesson-writers/src/index.ts';
import { pngBytes, pngHeader } from '../../helpers/png-bytes.ts';
import { wholeLesson } from '../../helpers/studio-lesson.ts';

const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);
const player: LessonFile[] = [
  ...['volume-view.iife.js', 'volume-view.css', 'x3dom.js', 'embed.js', 'embed.css', 'h5p.js', 'classic/1-x.js'],
].map((path) => ({ path, bytes: bytesOf(`/* ${path} "<!-- */`) }));
const image = pngBytes([pngHeader(4, 2)]);
const data: LessonData = {
  id: 'data-1',
  files: [
    { path: 'volume.json', bytes: bytesOf(JSON.stringify({ image: 'volume.png', unit: 'HU' })) },
    { path: 'volume.png', bytes: image },
  ],
};
const kinds: readonly ExportKind[] = ['page', 'single-file', 'embed', 'scorm', 'scorm-2004', 'cmi5', 'h5p'];
const optionsOf = (kind: ExportKind): ExportOptions => ({
  kind,
  pass: kind.startsWith('scorm') || kind === 'cmi5' ? 60 : null,
  address: 'https://example.org/head/',
  poster: kind === 'embed' ? { path: 'poster.png', bytes: image } : null,
});

describe('what the studio wrote', () => {
  for (const kind of kinds)
    it(`it opens again, as ${kind}: the same lesson, the same data, and the same bytes`, async () => {
      const lesson = wholeLesson();
      const bytes = writeLesson(lesson, data, player, optionsOf(kind));
      expect(endingOf(kind)).to.match(bytes[0] === 0x50 ? /\.(?:zip|h5p)$/ : /\.html$/);
      const opened = (await openLesson(new Blob([bytes as Uint8Array<ArrayBuffer>])))!;
      expect(opened.left).to.deep.equal([]);
      // The view is that of the first step, and data get an id of their own.
      expect({ ...opened.lesson, data: lesson.data, view: lesson.view }).to.deep.equal(lesson);
      expect(opened.lesson.data).to.equal(opened.data!.id);
      if (kind === 'single-file') {
        // The image is in its manifest now.
        const [manifest, ...others] = opened.data!.files;
        expect(others).to.deep.equal([]);
        const { image: address, unit } = JSON.parse(new TextDecoder().decode(manifest.bytes)) as Record<string, string>;
        expect(unit).to.equal('HU');
        expect(new Uint8Array(await (await fetch(address)).arrayBuffer())).to.deep.equal(image);
      } else expect(opened.data!.files).to.deep.equal(data.files);
      const again = writeLesson({ ...opened.lesson, view: lesson.view }, opened.data!, player, optionsOf(kind));
      expect(again).to.deep.equal(bytes);
    });
});
