// A lesson as a folder for frames: oEmbed's fields, the data inside, licence and credits, and the sizes of posters.
import { expect } from '@esm-bundle/chai';
import { LessonError, writeEmbedFiles, writePageFiles } from '../../../packages/lesson-writers/src/index.ts';
import type { Lesson, LessonFile } from '../../../packages/lesson-writers/src/index.ts';
import { readImageSize } from '../../../packages/lesson-writers/src/image-size.ts';
import { wordOfShow } from '../../../packages/lesson-writers/src/word-of-show.ts';

const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);
const fromBase64 = (text: string): Uint8Array => Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0));

/** The first bytes of an image of 37 x 21 pixels, as Pillow 13.0.0 writes it. */
const heads: Readonly<Record<string, string>> = {
  PNG: 'iVBORw0KGgoAAAANSUhEUgAAACUAAAAVCAIAAABOhrD5AAAJL0lE',
  GIF: 'R0lGODdhJQAVAIcAAP////39/fz8/Pr6+vn5+fj4+PX19fT09PHx',
  WebP: 'UklGRnYCAABXRUJQVlA4IGoCAAAQDgCdASolABUAPm0uk0ckIqGh',
  'WebP, lossless': 'UklGRiwDAABXRUJQVlA4TB8DAAAvJAAFAIVsAQDINsr57nE+27bt',
  'WebP, extended': 'UklGRrACAABXRUJQVlA4WAoAAAAYAAAAJAAAFAAAQUxQSBIAAAAB',
  'JPEG, progressive':
    '/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAAoHBwgHBgoICAgLCgoLDhgQDg0NDh0VFhEYIx8lJCIfIiEmKzcvJik0KSEiMEExNDk7Pj4+JS5ESUM8SDc9Pjv/2wBDAQoLCw4NDhwQEBw7KCIoOzs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozv/wgARCAAVACUDASIA',
};

const player: LessonFile[] = ['volume-view.iife.js', 'volume-view.css', 'embed.js', 'embed.css', 'classic/1-x.js'].map(
  (path) => ({ path, bytes: bytesOf(path) }),
);
const lessonOf = (html: string, more: Partial<Lesson> = {}): Lesson => ({
  html,
  files: [
    { path: 'head.nii.gz', bytes: bytesOf('data') },
    { path: 'a/poster.png', bytes: fromBase64(heads.PNG) },
  ],
  title: 'A "head" & <more>',
  language: 'de',
  licence: 'CC <BY> 4.0',
  credits: "O'Neil",
  ...more,
});
const withPoster =
  '<volume-view src="head.nii.gz" poster="a/poster.png" alt="A head" link-state></volume-view><volume-question remember><ul><li>A</li><li correct>B</li></ul></volume-question>';
const without = '<volume-view src="head.nii.gz" alt="A head"></volume-view>';
const address = 'https://example.org/brain';
const textOf = (files: readonly LessonFile[], path: string): string =>
  new TextDecoder().decode(files.find((one) => one.path === path)!.bytes);

describe('a lesson as a folder for frames', () => {
  it('has the fields that oEmbed asks of a rich answer, with whole addresses, and is found from the page', () => {
    const files = writeEmbedFiles(lessonOf(withPoster), player, { address });
    const answer = JSON.parse(textOf(files, 'oembed.json')) as Record<string, unknown>;
    // https://oembed.com, 2.3.4: all answers; 2.3.4.4: rich ones. The three fields of a thumbnail come together.
    expect(answer).to.deep.include({
      version: '1.0',
      type: 'rich',
      title: 'A "head" & <more>',
      author_name: "O'Neil",
      license: 'CC <BY> 4.0',
      thumbnail_url: 'https://example.org/brain/data/a/poster.png',
      thumbnail_width: 37,
      thumbnail_height: 21,
    });
    expect([answer.width, answer.height].every((one) => Number.isInteger(one) && (one as number) > 0)).to.equal(true);
    // What WordPress keeps of an answer: a quote without attributes, and one frame whose address stands between quotes.
    const [, link, src, title] =
      /^<blockquote><a href="([^"]*)">[^<>]*<\/a><\/blockquote><iframe src="([^"]*)" title="([^"]*)"[^<>]*><\/iframe>$/.exec(
        answer.html as string,
      )!;
    expect(link).to.equal('https://example.org/brain/');
    expect(src).to.equal('https://example.org/brain/embed.html');
    expect(title).to.equal('A &quot;head&quot; &amp; &lt;more&gt;');
    expect(answer.html).to.match(/ sandbox="allow-scripts [^"]*"/);
    expect(answer.html).not.to.contain('allow-same-origin');
    expect(textOf(files, 'index.html')).to.contain(
      '<link rel="alternate" type="application/json+oembed" href="https://example.org/brain/oembed.json" title="A &quot;head&quot; &amp; &lt;more&gt;">',
    );
  });

  it('shows the poster first, which leads to the lesson with its data inside; credits and licence are on each page', () => {
    const files = writeEmbedFiles(lessonOf(withPoster), player, { address });
    const poster = textOf(files, 'embed.html');
    expect(poster).to.contain('<img src="data/a/poster.png" alt="A head"><a href="embed-lesson.html">In 3D zeigen</a>');
    expect(poster).not.to.contain('volume-view.iife.js');
    const page = textOf(files, 'embed-lesson.html');
    expect(page).to.contain(`src="data:application/octet-stream;base64,${btoa('data')}"`);
    expect(page).to.contain('<script src="volume-view/embed.js" data-page="lesson"></script>');
    expect(page).not.to.match(/link-state|remember/);
    for (const path of ['index.html', 'embed.html', 'embed-lesson.html']) {
      expect(textOf(files, path), path).to.contain('CC &lt;BY&gt; 4.0');
      expect(textOf(files, path), path).to.contain('O&#39;Neil');
      // No script stands in a page.
      expect(textOf(files, path).match(/<script(?! src="volume-view\/[\w.-]+"[^>]*><\/script>)/g), path).to.equal(null);
    }
  });

  it('is the lesson at once where it has no poster, and then names no thumbnail', () => {
    const files = writeEmbedFiles(lessonOf(without), player, { address: `${address}/` });
    expect(files.map(({ path }) => path)).to.deep.equal([
      'data/a/poster.png',
      'data/head.nii.gz',
      'embed.html',
      'index.html',
      'lesson.css',
      'oembed.json',
      ...['classic/1-x.js', 'embed.css', 'embed.js', 'volume-view.css', 'volume-view.iife.js'].map(
        (path) => `volume-view/${path}`,
      ),
    ]);
    expect(textOf(files, 'embed.html')).to.contain('data-page="lesson"');
    expect(Object.keys(JSON.parse(textOf(files, 'oembed.json')) as object).join()).not.to.contain('thumbnail');
  });

  it('has the same bytes each time, in any order of its files; other forms do not have the files of frames', () => {
    const lesson = lessonOf(withPoster);
    const [one, two] = lesson.files;
    expect(
      writeEmbedFiles(
        { ...lesson, files: [two, one] },
        player.map((_, i) => player[player.length - 1 - i]),
        { address },
      ),
    ).to.deep.equal(writeEmbedFiles(lesson, player, { address }));
    expect(writePageFiles(lesson, player).filter(({ path }) => path.includes('embed'))).to.deep.equal([]);
  });

  it('refuses in words what is no address, and a poster that sites do not show', () => {
    const refusal = (lesson: Lesson, at: string): string => {
      try {
        writeEmbedFiles(lesson, player, { address: at });
      } catch (error) {
        if (error instanceof LessonError) return error.message;
        throw error;
      }
      return '';
    };
    for (const one of [
      '',
      'brain/',
      'ftp://x/',
      'file:///x/',
      'javascript:alert(1)',
      'https://x.org/?a=1',
      'https://a:b@x.org/',
    ])
      expect(refusal(lessonOf(without), one), one).to.match(/^got no address of the folder; expected/);
    expect(refusal(lessonOf(without), 'https://x.org/index.html')).to.equal('');
    const files = [
      lessonOf('').files[0],
      { path: 'a/poster.png', bytes: bytesOf('<svg xmlns="http://www.w3.org/2000/svg"/>') },
    ];
    expect(refusal(lessonOf(withPoster, { files }), address)).to.equal(
      'the poster a/poster.png is no PNG, JPEG, WebP or GIF; expected one, as other sites show it in a list',
    );
  });

  it('reads the sizes of images as Pillow wrote them, and of damaged ones none or some', () => {
    for (const [name, head] of Object.entries(heads)) {
      const bytes = fromBase64(head);
      expect(readImageSize(bytes), name).to.deep.equal({ width: 37, height: 21 });
      // At any place of a larger buffer.
      const moved = new Uint8Array(bytes.length + 7);
      moved.set(bytes, 5);
      expect(readImageSize(moved.subarray(5, 5 + bytes.length)), name).to.deep.equal({ width: 37, height: 21 });
      for (let length = 0; length < bytes.length; length += 1)
        for (let at = 0; at < 40; at += 1) {
          const damaged = bytes.slice(0, length);
          damaged[at] = (at * 37 + length) & 255;
          const size = readImageSize(damaged);
          if (size) expect(size.width > 0 && size.height > 0).to.equal(true);
        }
    }
  });

  it('has the word of the button in the language of the lesson, else in English', () => {
    expect(['pt-BR', 'xx', 'constructor', ''].map((one) => wordOfShow([one]))).to.deep.equal([
      'Ver em 3D',
      'Show in 3D',
      'Show in 3D',
      'Show in 3D',
    ]);
  });
});
