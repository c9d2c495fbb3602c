// The data of a lesson as parts of its page, as addresses that hold their bytes.
import { dataUrlOf } from './data-urls.ts';
import { cleanPath, readAddress } from './lesson-paths.ts';
import type { Lesson, LessonProblem } from './lesson.ts';
import { LessonError } from './lesson.ts';
import { fillManifest } from './manifest-files.ts';
import type { LessonElement, LessonNode } from './check-lesson-html.ts';
import { listAddresses } from './check-lesson-html.ts';
import { checkLesson } from './write-page.ts';

/** Bytes of all data in one page: some browsers open no larger ones. */
const maxData = 64 * 2 ** 20;

/**
 * The checked HTML of a lesson, and the address of each of its files, with the file inside.
 * @throws {LessonError} where something is refused, or can not be inside
 */
export function putInside(lesson: Lesson): {
  readonly nodes: readonly LessonNode[];
  readonly addressOf: (path: string) => string;
} {
  const nodes = checkLesson(lesson);
  const urls = writeDataUrls(lesson);
  const problems = nodes.flatMap(listUnfit);
  if (problems.length > 0) throw new LessonError(problems.map((message): LessonProblem => ({ message, line: null })));
  return { nodes: nodes.map(placeTiles), addressOf: (path) => urls.get(path) ?? '' };
}

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
