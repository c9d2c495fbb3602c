// Lessons as files: what is refused, what is written, and that nothing hostile is in it.
import { expect } from '@esm-bundle/chai';
import brain from '../../../demos/brain-lesson.html?raw';
import storm from '../../../demos/storm-lesson.html?raw';
import guide from '../../../docs/guide/lesson.md?raw';
import {
  LessonError,
  readLesson,
  writePageFiles,
  writeScormFiles,
  writeSingleFile,
} from '../../../packages/lesson-writers/src/index.ts';
import type { Lesson, LessonFile } from '../../../packages/lesson-writers/src/index.ts';
import { volumeElements } from '../../../packages/lesson-writers/src/volume-elements.ts';
import { writeNodes } from '../../../packages/lesson-writers/src/write-html.ts';
import { randomNumbers } from '../../helpers/synthetic.ts';

const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);
const player: LessonFile[] = [
  { path: 'volume-view.iife.js', bytes: bytesOf('player') },
  { path: 'classic/1-x.js', bytes: bytesOf('part') },
];
const view = '<volume-view id="v" src="head.nii.gz" alt="A head"></volume-view>';
const lessonOf = (html: string, more: Partial<Lesson> = {}): Lesson => ({
  html,
  files: [{ path: 'head.nii.gz', bytes: bytesOf('data') }],
  title: 'A head',
  language: 'en',
  licence: 'CC0 1.0',
  credits: 'Made by a program',
  ...more,
});
const textOf = (files: readonly LessonFile[], path: string): string =>
  new TextDecoder().decode(files.find((one) => one.path === path)!.bytes);
const refusal = (write: () => unknown): string => {
  try {
    write();
  } catch (error) {
    if (error instanceof LessonError) return error.message;
    throw error;
  }
  return '';
};

/** Each is refused wherever it stands. */
const hostile = [
  '<script>alert(1)</script>',
  '<script src="https://evil.example/volume-view.js">alert(1)</script>',
  '<script src="x.js"></script>',
  '<ScRiPt src=//evil.example></sCrIpT>',
  '<p onclick="alert(1)">x</p>',
  '<img src="head.nii.gz" onerror=alert(1)>',
  '<volume-view src="head.nii.gz" onload="alert(1)"></volume-view>',
  '<a href="javascript:alert(1)">x</a>',
  '<a href=" java&#x09;script:alert(1)">x</a>',
  '<a href="JaVaScRiPt&colon;alert(1)">x</a>',
  '<a href="data:text/html,<script>alert(1)</script>">x</a>',
  '<a href="vbscript:x">x</a>',
  '<a href="//evil.example">x</a>',
  '<svg><script>alert(1)</script></svg>',
  '<svg onload=alert(1)>',
  '<svg><a xlink:href="javascript:alert(1)"><text>x</text></a></svg>',
  '<math><mtext><table><mglyph><style><img src onerror=alert(1)></style></mglyph></table></mtext></math>',
  '<p style="background: url(https://evil.example)">x</p>',
  '<div><style>@import "https://evil.example"</style></div>',
  '<img src="https://evil.example/pixel.png">',
  '<img src="//evil.example/pixel.png">',
  '<img src="head.nii.gz" srcset="https://evil.example/a.png 2x">',
  '<img src="data:image/svg+xml,<svg onload=alert(1)>">',
  '<volume-view src="https://evil.example/head.nii.gz"></volume-view>',
  '<volume-view src="head.nii.gz https://evil.example/b.nii.gz"></volume-view>',
  '<volume-view src="head.nii.gz" poster="http://evil.example/a.png"></volume-view>',
  '<volume-view src="../secret.nii.gz"></volume-view>',
  '<volume-view src="a/..%2f..%2fsecret.nii.gz"></volume-view>',
  '<volume-view src="/etc/passwd"></volume-view>',
  '<volume-view src="file:///etc/passwd"></volume-view>',
  '<volume-view src="blob:x"></volume-view>',
  '<volume-view src="head.nii.gz?x=1"></volume-view>',
  '<volume-labels src="\\\\evil\\share\\a.nii"></volume-labels>',
  '<volume-labels src="head.nii.gz" table="https://evil.example/t.tsv"></volume-labels>',
  '<iframe src="https://evil.example"></iframe>',
  '<iframe srcdoc="<script>alert(1)</script>"></iframe>',
  '<object data="x"></object>',
  '<embed src="x">',
  '<form action="https://evil.example"><input name="x"></form>',
  '<button formaction="javascript:alert(1)">x</button>',
  '<textarea><img src=x onerror=alert(1)></textarea>',
  '<video src="https://evil.example/a.mp4"></video>',
  '<template><script>alert(1)</script></template>',
  '<noscript><p title="</noscript><img src=x onerror=alert(1)>"></noscript>',
  '<img name="getElementById" src="head.nii.gz">',
  '<p is="evil-element">x</p>',
  '<p contenteditable>x</p>',
  '<p id="a" autofocus>x</p>',
  '<evil-element></evil-element>',
  '<plaintext>',
  '<xmp><img src=x onerror=alert(1)></xmp>',
  '<div><base href="https://evil.example"></div>',
  '<div><meta http-equiv="refresh" content="0;url=https://evil.example"></div>',
  '<div><link rel="stylesheet" href="https://evil.example/a.css"></div>',
  '<marquee onstart=alert(1)>x</marquee>',
];

/** Harmless, and around what is hostile. */
const wraps: ((inner: string) => string)[] = [
  (inner) => inner,
  (inner) => `<div>${inner}</div>`,
  (inner) => `<volume-tour for="v"><volume-step><h2>One</h2>${inner}</volume-step></volume-tour>`,
  (inner) => `<volume-question><ul><li>A</li><li correct>${inner}</li></ul></volume-question>`,
  (inner) => `<p>An open paragraph <b>and <i>two${inner}</b></i>`,
  (inner) => `<!-- ${'-'.repeat(3)}> -->${inner}`,
  (inner) => `<table><tr><td>${inner}</td></tr></table>`,
  (inner) => `<details><summary>More</summary>${inner}</details>`,
];

/** A page that has nothing but these tags, each with attributes in quotes: a grammar of its own, narrower than HTML. */
function checkWritten(html: string): void {
  const names = new Set<string>();
  const rest = html
    .replace(/<\/?([a-z][a-z0-9-]*)((?: [a-z][a-z-]*="[^"<>]*")*)>/g, (_, name: string, attributes: string) => {
      names.add(name);
      for (const [, attribute, value] of attributes.matchAll(/ ([a-z-]+)="([^"]*)"/g)) {
        expect(attribute, html).not.to.match(/^(?:on|style$|srcset|srcdoc|is$|action|name$|http-equiv)/);
        if (attribute === 'src' || attribute === 'poster' || attribute === 'table')
          expect(value, html).to.match(/^(?:data\/[\w.-]+ ?)*$/);
        if (attribute === 'href') expect(value, html).to.match(/^(?:https?:\/\/|mailto:|#)/i);
      }
      return '';
    })
    .replace(/&(?:amp|lt|gt|quot|#39);/g, '');
  expect(rest, html).not.to.match(/[<>]/);
  for (const name of names)
    expect(name, html).not.to.match(
      /^(?:script|style|svg|math|iframe|object|embed|form|input|button|textarea|video|template|noscript|base|meta|link|plaintext|xmp|marquee)$/,
    );
}

describe('writers of lessons', () => {
  it('take the whole lesson of the guide', () => {
    const pages = [...guide.matchAll(/```html\n(<!doctype[\s\S]*?)```/g)].map(([, page]) => page);
    expect(pages).to.have.length(2);
    for (const page of pages) {
      const { problems, left, head } = readLesson(page);
      expect(problems).to.deep.equal([]);
      expect(head.language).to.equal('en');
      expect(head.title).to.match(/brain/);
      expect(left.length).to.equal(page.includes('<style>') ? 1 : 0);
    }
    const { named } = readLesson(pages[1]);
    expect(named).to.deep.equal(['head.nii.gz', 'demos/images/tour.webp']);
  });

  it('take the lessons of the demos, without the page around them', () => {
    for (const page of [brain, storm]) {
      const part = /<volume-view[\s\S]*<\/volume-tour>/.exec(page)![0];
      const { problems, nodes } = readLesson(`<!doctype html><body>${part}</body>`);
      expect(problems).to.deep.equal([]);
      expect(nodes.length).to.be.above(1);
    }
  });

  it('refuse each of what is hostile, and keep nothing of it', () => {
    for (const one of hostile) {
      const { problems, nodes } = readLesson(view + one);
      expect(problems.length, one).to.be.greaterThan(0);
      expect(problems[0].message, one).to.match(/got .*expected/s);
      checkWritten(writeNodes(nodes, { addressOf: (path) => `data/${path}`, linksLeave: false, leftOut: [] }));
      expect(
        refusal(() => writePageFiles(lessonOf(view + one), player)),
        one,
      ).not.to.equal('');
    }
  });

  it('keep nothing hostile of 1,000 made lessons', () => {
    const random = randomNumbers(39);
    const pick = <T>(list: readonly T[]): T => list[Math.floor(random() * list.length)];
    let refused = 0;
    for (let i = 0; i < 1000; i += 1) {
      let body = view;
      for (let n = 1 + Math.floor(random() * 4); n > 0; n -= 1) {
        let inner = pick(hostile);
        // Some are cut, joined with another one, or damaged: no list has all of what is hostile.
        if (random() < 0.25) inner = inner.slice(Math.floor(random() * inner.length));
        if (random() < 0.25) inner = inner.slice(0, Math.floor(random() * inner.length)) + pick(hostile);
        if (random() < 0.1) inner = inner.replace(/[ "]/g, () => pick(['\0', '\t', '/', "'", '\u2028', '>', '<']));
        body = random() < 0.5 ? body + pick(wraps)(inner) : pick(wraps)(inner + body);
      }
      const { nodes, problems } = readLesson(body);
      checkWritten(
        writeNodes(nodes, {
          addressOf: (path) => `data/${path.replace(/[^\w.-]/g, '_')}`,
          linksLeave: false,
          leftOut: [],
        }),
      );
      if (problems.length > 0) refused += 1;
    }
    expect(refused).to.be.greaterThan(900);
  });

  it('say in words what is refused, with its line', () => {
    expect(refusal(() => writePageFiles(lessonOf(`${view}\n\n<p onclick="x">y</p>`), player))).to.equal(
      'line 3: <p> got onclick; expected none: a lesson runs no script',
    );
    expect(refusal(() => writePageFiles(lessonOf('<p>x</p>'), player))).to.match(/got no <volume-view>/);
    expect(refusal(() => writePageFiles(lessonOf(view, { files: [] }), player))).to.match(
      /names head\.nii\.gz; expected/,
    );
    expect(refusal(() => writePageFiles(lessonOf(view, { licence: ' ' }), player))).to.match(/got no licence/);
    expect(refusal(() => writePageFiles(lessonOf(view, { credits: '' }), player))).to.match(/got no credits/);
    const htmlOf = (language: string): string =>
      new TextDecoder().decode(
        writePageFiles(lessonOf(view, { language }), player).find(({ path }) => path === 'index.html')!.bytes,
      );
    expect(htmlOf('ar')).to.contain('<html lang="ar" dir="rtl">');
    expect(htmlOf('de')).to.contain('<html lang="de">');
    expect(refusal(() => writePageFiles(lessonOf(view, { language: '"><script>' }), player))).to.match(
      /got no language/,
    );
    expect(refusal(() => writePageFiles(lessonOf('<volume-view src="a.mhd"></volume-view>'), player))).to.match(
      /numbers in a second file/,
    );
    expect(refusal(() => writePageFiles(lessonOf('<div>'.repeat(200000) + view), player))).to.match(
      /inside each other/,
    );
    const deep = refusal(() => writePageFiles(lessonOf('<p onclick>'.repeat(5000)), player));
    expect(deep.split('\n').length).to.be.lessThan(60);
  });

  it('refuse files whose paths lead elsewhere, and manifests that name some', () => {
    for (const path of ['../a', '/a', 'a/../../b', 'C:\\a', 'a:b', '.hidden', 'a\0b', ''])
      expect(
        refusal(() =>
          writePageFiles(lessonOf(view, { files: [...lessonOf(view).files, { path, bytes: bytesOf('') }] }), player),
        ),
        path,
      ).to.match(/leads out of/);
    const html = '<volume-view src="a/scan.json" alt="x"></volume-view>';
    const withManifest = (manifest: unknown, more: readonly LessonFile[] = []): Lesson =>
      lessonOf(html, { files: [{ path: 'a/scan.json', bytes: bytesOf(JSON.stringify(manifest)) }, ...more] });
    expect(refusal(() => writePageFiles(withManifest({ image: 'https://evil.example/a.png' }), player))).to.match(
      /elsewhere/,
    );
    expect(refusal(() => writePageFiles(withManifest({ scans: [{ image: '../../b.png' }] }), player))).to.match(
      /elsewhere/,
    );
    expect(refusal(() => writePageFiles(withManifest({ files: ['s.png'] }), player))).to.match(
      /names a\/s\.png; expected/,
    );
    const image = { path: 'a/s.png', bytes: bytesOf('png') };
    expect(
      refusal(() => writePageFiles(withManifest({ image: 's.png', title: 'https://is.text' }, [image]), player)),
    ).to.equal('');
    expect(refusal(() => writePageFiles(withManifest({ image: 'data:image/png;base64,AA==' }), player))).to.equal('');
  });

  it('write the same bytes for the same lesson, in any order of its files', () => {
    const files = [
      { path: 'head.nii.gz', bytes: bytesOf('data') },
      { path: 'b/c.png', bytes: bytesOf('c') },
    ];
    const options = { version: '1.2', pass: 80 } as const;
    const first = writeScormFiles(lessonOf(view, { files }), player, options);
    const second = writeScormFiles(lessonOf(view, { files: [files[1], files[0]] }), [player[1], player[0]], options);
    expect(second).to.deep.equal(first);
    const other = writeScormFiles(lessonOf(view, { files, title: 'Another' }), player, options);
    const idOf = (list: readonly LessonFile[]): string =>
      /identifier="([^"]*)"/.exec(textOf(list, 'imsmanifest.xml'))![1];
    expect(idOf(other)).not.to.equal(idOf(first));
    expect(first.map(({ path }) => path)).to.deep.equal([
      'course.js',
      'data/b/c.png',
      'data/head.nii.gz',
      'imsmanifest.xml',
      'index.html',
      'lesson.css',
      'volume-view/classic/1-x.js',
      'volume-view/volume-view.iife.js',
    ]);
  });

  it('show licence and credits on each page, and name them in each manifest', () => {
    const lesson = lessonOf(view, { licence: 'CC <BY> & "4.0"', credits: "O'Neil, 2024" });
    for (const files of [
      writePageFiles(lesson, player),
      writeScormFiles(lesson, player, { version: '1.2', pass: null }),
      writeScormFiles(lesson, player, { version: '2004', pass: null }),
    ]) {
      const manifest = files.some(({ path }) => path === 'imsmanifest.xml') ? textOf(files, 'imsmanifest.xml') : null;
      for (const text of [textOf(files, 'index.html'), manifest]) {
        if (text === null) continue;
        expect(text).to.contain('CC &lt;BY&gt; &amp; &quot;4.0&quot;');
        expect(text).to.contain('O&#39;Neil, 2024');
      }
    }
  });

  it('write one file that has all inside, and runs no script but those of the element', () => {
    const files = [
      { path: 'a/volume.json', bytes: bytesOf('{"image":"volume.png","scans":[{"image":"volume.png"}]}') },
      { path: 'a/volume.png', bytes: bytesOf('pixels') },
      { path: 'N46E007.hgt', bytes: bytesOf('heights') },
    ];
    const own = [
      { path: 'volume-view.iife.js', bytes: bytesOf('own("</script><!--")') },
      { path: 'volume-view.css', bytes: bytesOf('volume-view { display: block }') },
      { path: 'x3dom.js', bytes: bytesOf('x3dom') },
      { path: 'classic/1-x.js', bytes: bytesOf('part') },
      { path: 'THIRD-PARTY-LICENSES.txt', bytes: bytesOf('licences') },
    ];
    const html =
      '<volume-view src="a/volume.json" poster="a/volume.png"><volume-terrain src="N46E007.hgt"></volume-terrain></volume-view><p>&lt;/script&gt;&lt;script&gt;x&lt;/script&gt;</p>';
    const lesson = lessonOf(html, { files, credits: '</footer><script>x</script>' });
    const [{ path, bytes }, ...more] = writeSingleFile(lesson, own);
    expect([path, more.length]).to.deep.equal(['index.html', 0]);
    expect(writeSingleFile({ ...lesson, files: [files[2], files[0], files[1]] }, own)[0].bytes).to.deep.equal(bytes);
    const page = new TextDecoder().decode(bytes);
    const image = `data:image/png;base64,${btoa('pixels')}`;
    const manifest = btoa(JSON.stringify({ image, scans: [{ image }] }));
    expect(page).to.contain(`src="data:application/json;base64,${manifest}" poster="${image}"`);
    expect(page).to.contain(
      `<volume-terrain src="data:application/octet-stream;base64,${btoa('heights')}" corner="46 7">`,
    );
    expect(page).to.contain('own("\\x3c/script>\\x3c!--")');
    // Two parts, which are texts, and two scripts that run: all with the same mark.
    const scripts = [...page.matchAll(/<script( [^>]*)?>/g)].map(([, attributes]) => attributes);
    const [, nonce] = /'nonce-([^']+)'/.exec(page)!;
    expect(scripts).to.deep.equal([
      ' type="text/plain" data-x3dom',
      ' type="text/plain" data-part="1-x"',
      ` nonce="${nonce}"`,
      ` nonce="${nonce}"`,
    ]);
    expect(page).to.contain('CC0 1.0');
    expect(page).not.to.match(/(?:src|href)="(?!data:)/);
    expect(
      refusal(() =>
        writeSingleFile(lessonOf(view.replace('head.nii.gz', 'x.ozx'), { files: [{ path: 'x.ozx', bytes }] }), own),
      ),
    ).to.contain('OME-Zarr');
  });

  it('let links of a course open in a window of their own, and leave answers to the course', () => {
    const html = `${view}<a href="https://example.org/">x</a><volume-question id="q" remember><ul><li>A</li><li correct>B</li></ul></volume-question>`;
    const [page, course] = [
      writePageFiles(lessonOf(html), player),
      writeScormFiles(lessonOf(html), player, { version: '1.2', pass: null }),
    ].map((files) => textOf(files, 'index.html'));
    expect(page).to.contain('<a href="https://example.org/" rel="noopener noreferrer">x</a>');
    expect(page).to.contain(' remember=""');
    expect(course).to.contain('<a href="https://example.org/" rel="noopener noreferrer" target="_blank">x</a>');
    expect(course).not.to.contain('remember');
    expect(course).to.contain('<script src="course.js" data-scorm="1.2"></script>');
  });

  it('know each element of the package', () => {
    for (const name of Object.keys(volumeElements))
      expect(readLesson(`${view}<${name}></${name}>`).problems, name).to.deep.equal([]);
  });
});
