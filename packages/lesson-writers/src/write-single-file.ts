import styles from './lesson.css?raw';
import { dataUrlOf, encodeBase64 } from './data-urls.ts';
import { cleanPath, readAddress } from './lesson-paths.ts';
import type { Lesson, LessonFile, LessonProblem, Player } from './lesson.ts';
import { LessonError } from './lesson.ts';
import { fillManifest } from './manifest-files.ts';
import type { LessonElement, LessonNode } from './check-lesson-html.ts';
import { listAddresses } from './check-lesson-html.ts';
import script from './single-file.js?raw';
import { checkLesson, encode, folderForm, playerScript, writePage } from './write-page.ts';

/** Bytes of a file that many mail systems and courses refuse. */
export const largeFile = 25e6;

/** Bytes of all data in one file: some browsers open no larger pages. */
const maxData = 64 * 2 ** 20;

/**
 * A lesson as one page, `index.html`, with its data, styles and scripts inside: it opens from disk and from a server, and loads nothing.
 * @throws {LessonError} where something in the lesson is refused
 */
export function writeSingleFile(lesson: Lesson, player: Player): LessonFile[] {
  const nodes = checkLesson(lesson);
  const urls = writeDataUrls(lesson);
  const problems = nodes.flatMap(listUnfit);
  if (problems.length > 0) throw new LessonError(problems.map((message): LessonProblem => ({ message, line: null })));
  const textOf = (path: string): string => {
    const file = player.find((one) => one.path === path);
    if (!file) throw new RangeError(`the player lacks ${path}`);
    return new TextDecoder().decode(file.bytes);
  };
  const parts = player.flatMap(({ path }) => {
    const [, name] = /^classic\/(.+)\.js$/.exec(path) ?? [];
    return name === undefined
      ? []
      : [`<script type="text/plain" data-part="${name}">${inScript(textOf(path))}</script>\n`];
  });
  const own = textOf(playerScript);
  const nonce = nameScript(own);
  const run = (text: string): string => `<script nonce="${nonce}">${inScript(text)}</script>\n`;
  const page = writePage(lesson, nodes.map(placeTiles), {
    ...folderForm,
    addressOf: (path) => urls.get(path) ?? '',
    head: `<meta http-equiv="Content-Security-Policy" content="${policyOf(nonce)}">\n<link rel="icon" href="data:,">\n<style>\n${textOf('volume-view.css')}${styles}</style>\n`,
    end: `<script type="text/plain" data-x3dom>${inScript(textOf('x3dom.js'))}</script>\n${parts.join('')}${run(script)}${run(own)}`,
  });
  return [{ path: 'index.html', bytes: encode(page) }];
}

/** The page loads nothing but what is in it, and runs no script but those with its mark. */
const policyOf = (nonce: string): string =>
  `default-src 'none'; script-src 'nonce-${nonce}' 'wasm-unsafe-eval'; worker-src blob:; connect-src data: blob:; img-src data: blob:; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'`;

/** A mark that the same script always has: its FNV-1a hash of 32 bits, and its length. */
function nameScript(text: string): string {
  let hash = 0x811c9dc5;
  for (let at = 0; at < text.length; at++) hash = Math.imul(hash ^ text.charCodeAt(at), 0x01000193);
  return encodeBase64(encode(`${hash >>> 0}-${text.length}`)).replace(/=+$/, '');
}

/** A script as the content of an element of HTML. The signs that would end it are in texts only, where this means the same. */
const inScript = (text: string): string => text.replace(/<(?=\/script|!--)/gi, '\\x3c');

/** The URL of each file, by its path. Files that a manifest names are in that of the manifest. */
function writeDataUrls({ files }: Lesson): ReadonlyMap<string, string> {
  const total = files.reduce((sum, { bytes }) => sum + bytes.length, 0);
  if (total > maxData)
    throw new LessonError([
      {
        message: `the files have ${Math.ceil(total / 2 ** 20)} MiB; expected at most ${maxData / 2 ** 20} in a single file: make a page for a web server`,
        line: null,
      },
    ]);
  const plain = new Map(files.map((file) => [cleanPath(file.path) ?? '', dataUrlOf(file)]));
  return new Map(
    files.map((file) => {
      const filled = fillManifest(file, (path) => plain.get(path) ?? '');
      const path = cleanPath(file.path) ?? '';
      return [path, filled ? dataUrlOf({ path, bytes: filled }) : (plain.get(path) ?? '')];
    }),
  );
}

const pathsOf = ({ attributes }: LessonElement): string[] =>
  attributes.flatMap(([name, value]) =>
    name === 'src' ? listAddresses(value).map((address) => readAddress(address)?.path ?? '') : [],
  );

const tile = /(?:^|\/)([NS])(\d\d)([EW])(\d{3})[^/]*$/i;

/** Why an element can't show its file from inside the page, where a file has no name. */
function listUnfit(node: LessonNode): string[] {
  if (typeof node === 'string') return [];
  const paths = pathsOf(node);
  const problems = node.children.flatMap(listUnfit);
  if (paths.some((path) => /\.ozx$/i.test(path)))
    problems.push(
      `<${node.name}> got an OME-Zarr, which a single file can not hold; expected another format, like .nii.gz`,
    );
  if (node.name === 'volume-terrain' && paths.length > 1)
    problems.push('<volume-terrain> got several tiles; expected one in a single file, as tiles there have no names');
  return problems;
}

/** A tile of terrain says its place by its name, which it does not have inside the page. */
function placeTiles(node: LessonNode): LessonNode {
  if (typeof node === 'string') return node;
  const children = node.children.map(placeTiles);
  const [, ns, south, ew, west] = (node.name === 'volume-terrain' && tile.exec(pathsOf(node)[0] ?? '')) || [];
  if (ns === undefined || node.attributes.some(([name]) => name === 'corner')) return { ...node, children };
  const corner = `${/n/i.test(ns) ? '' : '-'}${Number(south)} ${/e/i.test(ew) ? '' : '-'}${Number(west)}`;
  return { ...node, children, attributes: [...node.attributes, ['corner', corner]] };
}
