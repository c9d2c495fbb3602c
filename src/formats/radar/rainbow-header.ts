import { corruptFile } from '../base/file-problem.ts';
import { readXml } from '../base/read-xml.ts';

export const what = 'the Rainbow file';

/** An element of the header: its attributes, its text, and what is in it. */
export interface RainbowNode {
  readonly name: string;
  readonly attributes: ReadonlyMap<string, string>;
  text: string;
  readonly children: RainbowNode[];
}

/** Its mark is not closed by anything: what follows are bytes. */
const endMark = '<!-- END XML -->';

/** More than the header of a volume of hundreds of sweeps has. */
const maxHeaderBytes = 2 ** 22;

/** Splits a file into its header and what follows. @throws {VolumeViewError} `format/corrupt` */
export function readRainbowHeader(bytes: Uint8Array<ArrayBuffer>): { volume: RainbowNode; end: number } {
  // One character for each byte, so that places in the text are places in the file.
  const text = new TextDecoder('latin1').decode(bytes.subarray(0, maxHeaderBytes));
  const end = text.indexOf(endMark);
  if (end < 0) throw corruptFile(what, `lacks "${endMark}" after its header; the file is damaged or cut short`);
  const root: RainbowNode = { name: '', attributes: new Map(), text: '', children: [] };
  const open = [root];
  try {
    readXml(text.slice(0, end), {
      open(name, attributes) {
        const node: RainbowNode = { name, attributes, text: '', children: [] };
        open.at(-1)!.children.push(node);
        open.push(node);
      },
      close: () => void open.pop(),
      text: (part) => void (open.at(-1)!.text += part.trim()),
    });
  } catch (cause) {
    if (!(cause instanceof SyntaxError)) throw cause;
    throw corruptFile(what, `has a header that is no XML: ${cause.message}`);
  }
  const volume = childOf(root, 'volume');
  if (!volume) throw corruptFile(what, 'has a header without <volume>');
  return { volume, end: end + endMark.length };
}

export const childOf = (node: RainbowNode | undefined, name: string): RainbowNode | undefined =>
  node?.children.find((child) => child.name === name);

export const childrenOf = (node: RainbowNode | undefined, name: string): RainbowNode[] =>
  node?.children.filter((child) => child.name === name) ?? [];

/** The number of an element in the first of these that has it; undefined if none has a finite one. */
export function numberIn(nodes: readonly (RainbowNode | undefined)[], name: string): number | undefined {
  for (const node of nodes) {
    const text = childOf(node, name)?.text ?? node?.attributes.get(name);
    const value = text === undefined || text === '' ? NaN : Number(text);
    if (Number.isFinite(value)) return value;
  }
  return undefined;
}

/** A number of an element's attributes. @throws {VolumeViewError} `format/corrupt` */
export function attributeOf({ name, attributes }: RainbowNode, key: string): number {
  const text = attributes.get(key);
  const value = Number(text);
  if (text && Number.isFinite(value)) return value;
  throw corruptFile(what, `got ${key}="${(text ?? '').slice(0, 40)}" of <${name}>; expected a number`);
}
