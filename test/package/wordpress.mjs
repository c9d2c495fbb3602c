// The plugin for WordPress: its files and words, and, where there is PHP, its programs. What it writes into a page is checked with the functions
// of a real WordPress, in the folder of VOLUME_VIEW_WORDPRESS, else where Debian has it. What is left out is said.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { runInNewContext } from 'node:vm';
import { gatherPlugin } from '../../scripts/build-wordpress.mjs';
import { findOnPath } from '../../scripts/find-browser.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { listCalls, listSentences, listSources, readTranslations } from '../../scripts/wordpress-words.mjs';
import { companions, leftAttributes, pluginFolder } from '../../scripts/write-wordpress-block.mjs';
import { readElements } from '../../scripts/write-tag-data.mjs';
import { check, finish } from './checks.mjs';
import { checkUploads } from './wordpress-uploads.mjs';

const root = join(projectRoot, pluginFolder);
const tests = join(projectRoot, 'packages/wordpress/tests');
const fromLessons = createRequire(join(projectRoot, 'packages/lesson-writers/package.json'));
const { parseFragment } = await import(pathToFileURL(fromLessons.resolve('parse5')).href);

const view = readElements().find(({ tagName }) => tagName === 'volume-view');
/** @type {string[]} */
const ofElement = view?.attributes.map((/** @type {{ name: string }} */ { name }) => name);
const known = ofElement.filter((name) => !Object.hasOwn(leftAttributes, name));
const files = gatherPlugin();
const ownFiles = [...files.keys()].filter((name) => !name.startsWith('element/'));
/** @param {string} name */
const read = (name) => readFileSync(join(root, name), 'utf8');

await check('the block has the attributes of the element, and no others', () => {
  const { attributes } = JSON.parse(read('block/block.json'));
  assert.deepEqual(Object.keys(attributes), [...known, ...Object.keys(companions), 'caption']);
  for (const name of Object.keys(leftAttributes)) assert.ok(ofElement.includes(name), name);
  return `${known.length} of ${ofElement.length}`;
});

await check('what a post may not have, the page for frames does not take either', () => {
  const text = readFileSync(join(projectRoot, 'packages/embed/src/view-attributes.ts'), 'utf8');
  for (const name of Object.keys(leftAttributes)) assert.match(text, new RegExp(`^  '?${name}'?: '`, 'm'));
});

await check('the files of the plugin are these', () => {
  const expected = ['LICENSE', 'readme.txt', 'uninstall.php', 'volume-view.php', 'block/block.json', 'block/editor.js'];
  for (const name of expected) assert.ok(files.has(name), name);
  for (const name of ownFiles)
    assert.match(name, /^(?:LICENSE|(?:[\w-]+\/)?[\w-]+\.(?:php|js|css|json|txt|pot|po|mo))$/, name);
  if (!existsSync(join(projectRoot, 'dist/volume-view.js'))) return 'the element is not built';
  const folder = /'(\w{12})'/.exec(String(files.get('element/folder.php')))?.[1];
  for (const name of [
    'volume-view.js',
    'volume-view.iife.js',
    'volume-view.css',
    'x3dom.js',
    'THIRD-PARTY-LICENSES.txt',
  ])
    assert.ok(files.has(`element/${folder}/${name}`), name);
  assert.ok(![...files.keys()].some((name) => /\.(?:d\.ts|map|html)$|\/(?:esm|types)\//.test(name)));
  return `${files.size} files`;
});

await check('each program of the plugin runs only in WordPress, and none names another server', () => {
  for (const name of listSources().filter((one) => one.endsWith('.php')))
    assert.match(read(name), /\ndefined\( '(?:ABSPATH|WP_UNINSTALL_PLUGIN)' \) \|\| exit;\n/, name);
  for (const name of listSources()) {
    const code = read(name).replace(/^ \*.*$|\/\/ .*$/gm, '');
    assert.doesNotMatch(code, /['"]https?:\/\/\w/, name);
    assert.doesNotMatch(code, /\b(?:wp_remote_\w+|curl_\w+|fsockopen|eval|base64_decode|unserialize)\s*\(/, name);
  }
});

await check('the block stands while an author types an address letter by letter', () => {
  let previews = 0;
  for (const name of ['src', 'poster']) {
    for (const whole of ['https://example.org:8080/a.png', '/uploads/a.png', 'http://[::1]/a.png']) {
      for (let length = 1; length <= whole.length; length++) {
        const tag = drawBlock({ src: '/a.nii', poster: '', [name]: whole.slice(0, length) });
        if (!tag) continue; // The fields are there, with a sentence on addresses.
        previews += 1;
        for (const text of tag.values()) assert.match(text, /^https?:\/\/[^/]+\//);
      }
      const { poster, src } = Object.fromEntries(drawBlock({ src: '/a.nii', poster: '', [name]: whole }) ?? []);
      assert.equal({ src, poster }[name], new URL(whole, 'https://site.example').href);
    }
  }
  return `${previews} previews`;
});

await check('each sentence names the text domain, and the template has it', () => {
  const template = read('languages/volume-view.pot');
  let count = 0;
  for (const name of listSources()) {
    for (const { text, domain, place } of listCalls(name)) {
      assert.equal(domain, 'volume-view', place);
      assert.ok(template.includes(`msgid ${JSON.stringify(text)}`), place);
      count += 1;
    }
    // A call that the list does not read would have no translation.
    const all =
      read(name).match(/(?<![\w$>])(?:__|_e|_x|_n|esc_html__|esc_attr__|esc_html_e|esc_attr_e|esc_html_x)\(/g) ?? [];
    assert.equal(listCalls(name).length, all.length, name);
  }
  return `${count} sentences`;
});

await check('each translation is one of a sentence, and has its placeholders', () => {
  const sentences = listSentences();
  const key = (/** @type {{ context: string, text: string }} */ { context, text }) =>
    context ? `${context}\u0004${text}` : text;
  const places = (/** @type {string} */ text) => (text.match(/%(?:\d\$)?[sd]/g) ?? []).join();
  // What the attributes mean comes from the element, and is long: it may stay in English.
  const asked = sentences.filter((one) => !one.places.every((place) => /descriptions|volume-view\.php/.test(place)));
  const notes = [...readTranslations()].map(([language, words]) => {
    const all = new Set(['', ...sentences.map(key)]);
    for (const [text, said] of words) {
      assert.ok(all.has(text), `${language}: ${text}`);
      if (text) assert.equal(places(said), places(text), text);
    }
    for (const one of asked) assert.ok(words.has(key(one)), `${language} lacks: ${one.text}`);
    return `${language}: ${words.size} of ${sentences.length}`;
  });
  return notes.join(', ');
});

/**
 * Draws the block as the editor does, with what it takes of WordPress and React as plain functions.
 * @param {Record<string, string>} attributes
 * @returns the attributes of the element in the preview; null where there is no preview
 */
function drawBlock(attributes) {
  /** @type {Map<string, string>} */
  const texts = new Map();
  const element = {
    removeAttribute: (/** @type {string} */ name) => texts.delete(name),
    getAttribute: (/** @type {string} */ name) => texts.get(name) ?? null,
    setAttribute: (/** @type {string} */ name, /** @type {string} */ text) => texts.set(name, text),
  };
  let hasPreview = false;
  /** @typedef {{ type: unknown, props: object, children: unknown[] }} Part */
  const createElement = (
    /** @type {unknown} */ type,
    /** @type {object} */ props,
    /** @type {unknown[]} */ ...children
  ) => ({ type, props, children });
  const draw = (/** @type {unknown} */ part) => {
    if (Array.isArray(part)) return part.forEach(draw);
    if (typeof part !== 'object' || part === null) return;
    const { type, props, children } = /** @type {Part} */ (part);
    hasPreview ||= type === 'volume-view';
    if (typeof type === 'function') draw(type(props ?? {}));
    draw(children);
  };
  /** @type {{ edit: (props: object) => Part }[]} */
  const blocks = [];
  const window = {
    location: { origin: 'https://site.example' },
    volumeViewTable: { kinds: { src: 'addresses', poster: 'address' }, choices: {}, descriptions: {}, companions: [] },
    wp: {
      element: {
        createElement,
        Fragment: 'fragment',
        useEffect: (/** @type {() => void} */ run) => run(),
        useRef: () => ({ current: element }),
        useState: (/** @type {unknown} */ first) => [first, () => {}],
      },
      blockEditor: { useBlockProps: () => ({}) },
      components: {},
      htmlEntities: { decodeEntities: String },
      i18n: { __: String },
      blocks: {
        registerBlockType: (/** @type {string} */ _, /** @type {typeof blocks[0]} */ block) => blocks.push(block),
      },
    },
  };
  runInNewContext(read('block/editor.js'), { window, URL, setTimeout: () => 0 });
  draw(blocks[0].edit({ attributes: { caption: '', ...attributes }, setAttributes: () => {}, isSelected: false }));
  return hasPreview ? texts : null;
}

/** The elements of a page that the plugin may write, with their attributes. @type {Record<string, string[]>} */
const allowedIn = {
  'volume-view': [...known, 'id'],
  ...Object.fromEntries(Object.values(companions).map((tag) => [tag, ['for']])),
  figure: ['class'],
  figcaption: ['class'],
  p: ['class'],
  a: ['href', 'rel', 'target'],
  img: ['src', 'alt', 'style'],
  ...Object.fromEntries(['em', 'strong', 'sub', 'sup', 'code', 's', 'br'].map((tag) => [tag, []])),
};

const php = findOnPath('php');
const wordPress = [process.env.VOLUME_VIEW_WORDPRESS ?? '/usr/share/wordpress'].find((folder) =>
  existsSync(join(folder, 'wp-includes/kses.php')),
);
if (!php) console.log('left out: the programs of the plugin for WordPress; there is no PHP');
else await checkPrograms(php);
if (php && !wordPress)
  console.log('left out: what the plugin for WordPress writes into a page; VOLUME_VIEW_WORDPRESS names no WordPress');
if (php && wordPress) await checkPages(php, wordPress);
finish();

/** @param {string} php */
async function checkPrograms(php) {
  await check('PHP reads each program of the plugin', () => {
    for (const name of ownFiles.filter((one) => one.endsWith('.php'))) {
      const { status, stdout } = spawnSync(php, ['-l', join(root, name)], { encoding: 'utf8' });
      assert.equal(status, 0, stdout);
    }
  });
  await checkUploads(php);
}

/** @param {string} php @param {string} wordPress */
async function checkPages(php, wordPress) {
  const version = /wp_version = '([^']+)'/.exec(readFileSync(join(wordPress, 'wp-includes/version.php'), 'utf8'))?.[1];

  /** What the plugin makes of cases. @param {unknown[]} cases @returns {{ html: string, first: any, loaded: string[] }[]} */
  const render = (cases) => {
    const { status, stdout, stderr } = spawnSync(php, [join(tests, 'render.php')], {
      input: JSON.stringify(cases),
      encoding: 'utf8',
      maxBuffer: 1 << 26,
      env: { ...process.env, VOLUME_VIEW_WORDPRESS: wordPress },
    });
    assert.equal(status, 0, stderr + stdout);
    return JSON.parse(stdout);
  };
  const source = 'https://a.example/head.nii.gz';

  await check(`a block and a shortcode write the same tag (WordPress ${version})`, () => {
    const given = { src: source, alt: 'Brain "1"', 'camera-orbit': '30deg 70deg 110%', controls: true, rings: 'true' };
    const [block, shortcode, off] = render([
      { given, caption: 'Of <em>one</em> person' },
      {
        content: `[volume-view src="${source}" alt='Brain "1"' camera-orbit="30deg 70deg 110%" controls rings]Of <em>one</em> person[/volume-view]`,
      },
      { content: `[volume-view src="${source}" controls="false" rings="false" autoplay="no" shading="" /]` },
    ]);
    assert.equal(
      block.html,
      `<figure class="wp-block-volume-view-volume"><volume-view src="${source}" rings camera-orbit="30deg 70deg 110%" controls alt="Brain &quot;1&quot;"></volume-view><figcaption class="wp-element-caption">Of <em>one</em> person</figcaption></figure>`,
    );
    assert.equal(shortcode.html, block.html);
    assert.deepEqual(block.loaded, ['volume-view']);
    assert.equal(shortcode.first.src, source);
    assert.match(off.html, /<volume-view src="[^"]+"><\/volume-view>/);
  });

  await check('companions stand below the picture and know it', () => {
    const [{ html }] = render([{ given: { src: source, legend: true, readout: false, timeline: 'true' } }]);
    assert.match(
      html,
      / id="(volume-view-\d+)"><\/volume-view><volume-legend for="\1"><\/volume-legend><volume-timeline for="\1">/,
    );
    assert.doesNotMatch(html, /readout/);
  });

  await check('an address that is taken stays as it is, and any other shows nothing to a reader', () => {
    const taken = [
      source,
      '/uploads/a%20b.nii.gz',
      'https://a.example/x.ome.zarr/#channels=1,3',
      'https://a.example/1.h5 https://a.example/2.h5',
      'https://a.example/?a=1&b=2',
    ];
    const refused = [
      ...['javascript:alert(1)', 'data:text/html,x', 'blob:https://a.example/1', 'file:///etc/passwd', 'head.nii.gz'],
      ...['https://user:word@a.example/x', '', ' ', `${source} javascript:alert(1)`, '\u0001javascript:alert(1)'],
      `https://a.example/${'x'.repeat(16_000)}`,
    ];
    const answers = render([...taken, ...refused].map((src) => ({ given: { src } })));
    taken.forEach((src, i) => {
      const [figure] = parseFragment(answers[i].html).childNodes;
      assert.equal(figure.childNodes[0].attrs[0].value, src);
    });
    refused.forEach((src, i) => assert.equal(answers[taken.length + i].html, '', src.slice(0, 60)));
    const [said, kses] = render([
      { given: { src: 'javascript:alert(1)' }, mayEdit: true },
      // WordPress writes it so for an author who may write no HTML.
      { given: { src: 'https://a.example/?a=1&amp;b=2', alt: 'a &lt; b &amp; c' } },
    ]);
    assert.match(said.html, /^<p class="volume-view-problem">/);
    assert.match(kses.html, /src="https:\/\/a\.example\/\?a=1&amp;b=2" alt="a &lt; b &amp; c"/);
  });

  await check('a mosaic is the uploaded image, not the smaller copy that WordPress makes', () => {
    const folder = 'https://site.example/wp-content/uploads/';
    const [{ html }, other] = render([
      { given: { src: `${folder}mosaic-scaled.png`, mosaic: '8x8' } },
      { given: { src: `${folder}other-scaled.png`, poster: `${folder}mosaic-scaled.png` } },
    ]);
    assert.match(html, /src="[^"]*\/mosaic\.png"/);
    assert.match(other.html, /src="[^"]*\/other-scaled\.png" poster="[^"]*\/mosaic-scaled\.png"/);
  });

  await check('a feed has the poster with a link, and no script', () => {
    const [{ html, loaded }] = render([{ given: { src: source, poster: '/p.png', alt: 'Brain' }, feed: true }]);
    assert.match(html, /<a href="https:\/\/site\.example\/post\/" target="_top"><img src="\/p\.png" alt="Brain"/);
    assert.deepEqual(loaded, []);
  });

  await check('hostile texts stay texts: no element, no attribute and no address comes of them', () => {
    const cases = hostileCases();
    const answers = render(cases);
    answers.forEach(({ html }, i) => {
      const problem = listStrange(parseFragment(html), 'content' in cases[i]);
      assert.equal(problem, '', `${JSON.stringify(cases[i])}\n${html}`);
    });
    assert.ok(answers.filter(({ html }) => html.includes('<volume-view ')).length > 150);
    return `${cases.length} cases`;
  });

  /** Texts in each attribute, in unknown ones, in captions, and in shortcodes. */
  function hostileCases() {
    const texts = [
      ...[
        '"><script>alert(1)</script>',
        "'><img src=x onerror=alert(1)>",
        '" onload="alert(1)',
        '</volume-view><script>1</script>',
      ],
      ...[
        '<svg/onload=alert(1)>',
        'javascript:alert(1)',
        'JaVaScRiPt&colon;alert(1)',
        'java\tscript:alert(1)',
        '&quot; x=&quot;',
      ],
      ...[
        '&#34;&#62;<b>',
        '\u0000"><b>',
        '`onclick=alert(1)`',
        '--><script>1</script>',
        ']]><script>1</script>',
        '[volume-view src="/x"]',
      ],
      ...[
        'https://a.example/"onload="alert(1)',
        "https://a.example/'><script>",
        'https://a.example/<b>',
        '//evil.example/x"y',
        '\u2028"',
      ],
    ];
    const byName = [...known, ...Object.keys(companions)].flatMap((name, i) =>
      [0, 1, 2].map((k) => ({ given: { src: source, [name]: texts[(3 * i + k) % texts.length] } })),
    );
    const strange = texts.flatMap((text) => [
      { given: { src: text } },
      { given: { src: source, [text]: text, onload: text, style: text, id: text, is: text, 'src ': text } },
      { given: { src: source }, caption: `${text}<a href="${text}">x</a><iframe src="/x"></iframe>` },
      { given: { src: source, poster: text }, feed: true },
      { given: { src: text }, mayEdit: true },
      { content: `[volume-view src="${source}" alt="${text}" onload="x" ${text}]` },
      { content: `[volume-view src=${text} alt='${text}']${text}[/volume-view]` },
      { given: { src: [source], alt: { a: text }, steps: null, controls: [1] } },
    ]);
    return [...byName, ...strange];
  }

  /**
   * What a page must not have, in words; empty where it has nothing of it.
   * @param {any} node
   * @param {boolean} hasText - whether the author's own text is around the volume, with the HTML that WordPress leaves it
   * @returns {string}
   */
  function listStrange(node, hasText) {
    const here = (node.childNodes ?? []).map((/** @type {any} */ child) => {
      if (child.nodeName === '#text' || child.nodeName === '#comment') return '';
      const ofText = hasText && /^(?:img|b|svg)$/.test(child.nodeName) ? ['src'] : undefined;
      const allowed = ofText ?? allowedIn[child.nodeName];
      if (!allowed) return `<${child.nodeName}>`;
      const wrong = child.attrs.filter((/** @type {any} */ { name, value }) => {
        if (!allowed.includes(name)) return true;
        if (name === 'src' && !ofText)
          return !value.split(' ').every((/** @type {string} */ one) => /^(?:https?:\/\/|\/)/.test(one));
        return name === 'href' || name === 'poster' ? !/^(?:https?:\/\/|mailto:|\/|(?![a-z]+:))/i.test(value) : false;
      });
      return (
        wrong.map((/** @type {any} */ { name }) => `${child.nodeName} ${name}`).join() || listStrange(child, hasText)
      );
    });
    return here.filter(Boolean).join();
  }
}
