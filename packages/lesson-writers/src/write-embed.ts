// A lesson as a folder for a web server, which other sites show in a frame: by hand, or by the address of the folder alone
// (oEmbed, https://oembed.com).
import type { LessonElement, LessonNode } from './check-lesson-html.ts';
import { readImageSize } from './image-size.ts';
import type { ImageSize } from './image-size.ts';
import { cleanPath, readAddress, writeAddress } from './lesson-paths.ts';
import type { Lesson, LessonFile, Player } from './lesson.ts';
import { LessonError } from './lesson.ts';
import { putInside } from './put-inside.ts';
import { wordOfShow } from './word-of-show.ts';
import { escapeMarkup } from './write-html.ts';
import {
  encode,
  folderForm,
  isForFrames,
  playerFolder,
  sortFiles,
  writeCredits,
  writeDocument,
  writeHead,
  writePage,
  writePageFiles,
} from './write-page.ts';

export interface EmbedOptions {
  /** Where the folder will be: `https://example.org/brain/`. Other sites need whole addresses. */
  readonly address: string;
  /** The element's own files are next to the folder, for several lessons, and not in it. */
  readonly sharedPlayer?: boolean;
}

/** CSS pixels of a frame, where the page around it does not follow the height of the lesson. */
const frame = { width: 640, height: 720 } as const;

/** Scripts in the frame run, and links open in a window as they are; the frame has no origin, and so nothing of its site or of the reader. */
const sandbox = 'allow-scripts allow-popups allow-popups-to-escape-sandbox';

/** The poster's page loads its own image and style, and the script of the button. */
const posterPolicy = "default-src 'self'; object-src 'none'; base-uri 'none'; form-action 'none'";

/**
 * The files of a lesson as a folder: `index.html` for readers, `embed.html` for frames, `oembed.json`, which `index.html` names. In a frame without an
 * origin a page may read no file of its server that does not allow it: so the page for frames has the data inside.
 * @throws {LessonError} where something in the lesson is refused
 */
export function writeEmbedFiles(lesson: Lesson, player: Player, { address, sharedPlayer }: EmbedOptions): LessonFile[] {
  const place = readPlace(address);
  const playerAt = sharedPlayer ? `../${playerFolder}` : playerFolder;
  const head = writeHead({ playerAt });
  const { nodes, addressOf } = putInside(lesson);
  const poster = findPoster(lesson, nodes);
  const page = writePage(lesson, nodes, {
    ...folderForm,
    addressOf,
    head,
    linksLeave: true,
    // Without an origin a page keeps no answers; and the part after the # is of the page around the frame.
    leftOut: ['remember', 'link-state'],
    end: `<script src="${playerAt}embed.js" data-page="lesson"></script>\n`,
  });
  const frames = player.filter(({ path }) => isForFrames(path));
  if (!frames.some(({ path }) => path === 'embed.js')) throw new RangeError('the player lacks embed.js');
  const files = sortFiles([
    ...writePageFiles(lesson, player, { ...folderForm, head: head + writeDiscovery(lesson, place) }),
    ...frames.map(({ path, bytes }) => ({ path: playerFolder + path, bytes })),
    { path: 'oembed.json', bytes: encode(writeOembed(lesson, place, poster)) },
    ...(poster
      ? [
          { path: 'embed.html', bytes: encode(writePosterPage(lesson, poster, playerAt)) },
          { path: 'embed-lesson.html', bytes: encode(page) },
        ]
      : [{ path: 'embed.html', bytes: encode(page) }]),
  ]);
  return sharedPlayer ? files.filter(({ path }) => !path.startsWith(playerFolder)) : files;
}

const refuse = (message: string): LessonError => new LessonError([{ message, line: null }]);

/** @returns the address of the folder, with a slash at its end @throws {LessonError} */
function readPlace(address: string): string {
  let url: URL | null = null;
  try {
    url = new URL(address);
  } catch {
    // Said below.
  }
  if (!url || !/^https?:$/.test(url.protocol) || url.username !== '' || url.search !== '' || url.hash !== '')
    throw refuse(
      'got no address of the folder; expected the one that it will have on your web server, like https://example.org/brain/',
    );
  return url.href.replace(/(?:index\.html)?$/, '').replace(/\/*$/, '/');
}

interface Poster extends ImageSize {
  /** Its address, from the pages of the folder. */
  readonly address: string;
  readonly alt: string;
}

/** The poster of the first view. @returns null where it has none @throws {LessonError} where it is no image that sites show */
function findPoster({ files }: Lesson, nodes: readonly LessonNode[]): Poster | null {
  const view = findView(nodes);
  const textOf = (name: string): string => view?.attributes.find(([own]) => own === name)?.[1] ?? '';
  const path = readAddress(textOf('poster'))?.path;
  const file = files.find((one) => path !== undefined && cleanPath(one.path) === path);
  if (!file || path === undefined) return null;
  const size = readImageSize(file.bytes);
  if (!size)
    throw refuse(`the poster ${path} is no PNG, JPEG, WebP or GIF; expected one, as other sites show it in a list`);
  return { ...size, address: writeAddress(path), alt: textOf('alt') };
}

function findView(nodes: readonly LessonNode[]): LessonElement | null {
  for (const node of nodes) {
    if (typeof node === 'string') continue;
    const found = node.name === 'volume-view' ? node : findView(node.children);
    if (found) return found;
  }
  return null;
}

/** By this line a site finds `oembed.json` when an author pastes the address of the folder. */
const writeDiscovery = ({ title }: Lesson, place: string): string =>
  `<link rel="alternate" type="application/json+oembed" href="${escapeMarkup(place)}oembed.json" title="${escapeMarkup(title)}">\n`;

/**
 * What oEmbed 1.0 asks of a `rich` answer, with the licence in addition. WordPress follows the height of a frame only where a quote with a link comes
 * before it, and hides the quote as soon as the frame has said its height (6.1, wp-includes/embed.php: wp_maybe_enqueue_oembed_host_js).
 */
function writeOembed({ title, credits, licence }: Lesson, place: string, poster: Poster | null): string {
  const { width, height } = frame;
  const quote = `<blockquote><a href="${escapeMarkup(place)}">${escapeMarkup(title)}</a></blockquote>`;
  const html = `${quote}<iframe src="${escapeMarkup(place)}embed.html" title="${escapeMarkup(title)}" width="${width}" height="${height}" frameborder="0" sandbox="${sandbox}" allow="fullscreen" style="border: 0; max-width: 100%"></iframe>`;
  const thumbnail = poster && {
    thumbnail_url: place + poster.address,
    thumbnail_width: poster.width,
    thumbnail_height: poster.height,
  };
  const answer = { version: '1.0', type: 'rich', title, author_name: credits, license: licence, ...thumbnail };
  return `${JSON.stringify({ ...answer, width, height, html }, null, 2)}\n`;
}

/** The page of the frame at first: the poster, a link to the lesson, and whose data they are. It loads nothing else. */
function writePosterPage(lesson: Lesson, { address, alt }: Poster, playerAt: string): string {
  const { title, language } = lesson;
  return writeDocument(
    lesson,
    `<meta http-equiv="Content-Security-Policy" content="${posterPolicy}">
<link rel="stylesheet" href="${playerAt}embed.css">
`,
    `<main>
<div class="poster"><img src="${address}" alt="${escapeMarkup(alt || title)}"><a href="embed-lesson.html">${wordOfShow([language])}</a></div>
<footer class="credits">
${writeCredits(lesson)}</footer>
</main>
<script src="${playerAt}embed.js" data-page="poster" data-next="embed-lesson.html"></script>
`,
  );
}
