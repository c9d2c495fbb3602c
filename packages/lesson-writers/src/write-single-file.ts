import styles from './lesson.css?raw';
import { encodeBase64 } from './data-urls.ts';
import type { Lesson, LessonFile, Player } from './lesson.ts';
import { putInside } from './put-inside.ts';
import script from './single-file.js?raw';
import { encode, folderForm, playerScript, writePage } from './write-page.ts';

/** Bytes of a file that many mail systems and courses refuse. */
export const largeFile = 25e6;

/**
 * A lesson as one page, `index.html`, with its data, styles and scripts inside: it opens from disk and from a server, and loads nothing.
 * @throws {LessonError} where something in the lesson is refused
 */
export function writeSingleFile(lesson: Lesson, player: Player): LessonFile[] {
  const { nodes, addressOf } = putInside(lesson);
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
  const page = writePage(lesson, nodes, {
    ...folderForm,
    addressOf,
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
