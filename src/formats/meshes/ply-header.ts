import { corrupt } from './mesh-limits.ts';

/** Bytes of each of PLY's number types, under both names. */
const sizes: Readonly<Record<string, number>> = {
  char: 1,
  int8: 1,
  uchar: 1,
  uint8: 1,
  short: 2,
  int16: 2,
  ushort: 2,
  uint16: 2,
  int: 4,
  int32: 4,
  uint: 4,
  uint32: 4,
  float: 4,
  float32: 4,
  double: 8,
  float64: 8,
};

type PlyType = string;

/** One number of an element, or a list of them. */
export interface PlyProperty {
  readonly name: string;
  readonly type: PlyType;
  /** For a list: the type of its length. */
  readonly countType: PlyType | null;
}

export interface PlyElement {
  readonly name: string;
  readonly count: number;
  readonly properties: PlyProperty[];
}

export interface PlyHeader {
  readonly form: 'ascii' | 'binary_little_endian' | 'binary_big_endian';
  readonly elements: readonly PlyElement[];
  readonly comments: string;
  /** Where the data begin, bytes. */
  readonly length: number;
}

/** Maximum bytes of a header. */
const longest = 2 ** 16;

export function isPly(text: string): boolean {
  return /^ply\r?\n/.test(text);
}

/** @throws {VolumeViewError} `format/corrupt` Source: Turk, *The PLY Polygon File Format*, 1994 */
export function readPlyHeader(bytes: Uint8Array): PlyHeader {
  const text = new TextDecoder('latin1').decode(bytes.subarray(0, longest));
  const end = /\nend_header[ \t]*(\r\n|\n|\r)/.exec(text);
  if (!end) throw corrupt('PLY', 'has no end of its header');
  const elements: PlyElement[] = [];
  const comments: string[] = [];
  let form = '';
  for (const line of text.slice(0, end.index).split(/\r?\n/).slice(1)) {
    const [word, ...words] = line.trim().split(/\s+/);
    if (word === 'format') form = words[0] ?? '';
    else if (word === 'comment' || word === 'obj_info') comments.push(line);
    else if (word === 'element') elements.push({ name: words[0] ?? '', count: Number(words[1]), properties: [] });
    else if (word === 'property') elements.at(-1)?.properties.push(readProperty(words));
    else if (word !== '')
      throw corrupt('PLY', `got "${word.slice(0, 40)}" in its header; expected format, comment, element or property`);
  }
  if (form !== 'ascii' && form !== 'binary_little_endian' && form !== 'binary_big_endian')
    throw corrupt(
      'PLY',
      `has the format "${form.slice(0, 40)}"; expected ascii, binary_little_endian or binary_big_endian`,
    );
  const wrong = elements.find(({ count }) => !Number.isSafeInteger(count) || count < 0);
  if (wrong) throw corrupt('PLY', `has no count of "${wrong.name.slice(0, 40)}"`);
  return { form, elements, comments: comments.join('\n'), length: end.index + end[0].length };
}

function readProperty(words: readonly string[]): PlyProperty {
  const isList = words[0] === 'list';
  const [type = '', name = ''] = words.slice(isList ? 2 : 0);
  const countType = isList ? (words[1] ?? '') : null;
  for (const one of [countType ?? 'int', type]) {
    if (!Object.hasOwn(sizes, one))
      throw corrupt(
        'PLY',
        `has numbers of the type "${one.slice(0, 40)}"; expected one of ${Object.keys(sizes).join(', ')}`,
      );
  }
  // Older names of red, green and blue.
  return { name: name.replace(/^diffuse_/, ''), type, countType };
}

/** Bytes of one number. */
export function sizeOf(type: PlyType): number {
  return sizes[type];
}
