import { html as htmlNames, parse } from 'parse5';
import type { DefaultTreeAdapterTypes } from 'parse5';
import { fileAttributes, isAllowedAttribute, isAllowedElement } from './allowed-html.ts';
import { isLink, readAddress } from './lesson-paths.ts';
import type { LessonProblem } from './lesson.ts';

type ChildNode = DefaultTreeAdapterTypes.ChildNode;
type Element = DefaultTreeAdapterTypes.Element;

/** A text, or an element whose name and attributes a lesson may have. */
export type LessonNode = string | LessonElement;

export interface LessonElement {
  readonly name: string;
  readonly attributes: readonly (readonly [name: string, value: string])[];
  readonly children: readonly LessonNode[];
}

/** The HTML of a lesson, read and checked. */
export interface LessonContent {
  readonly nodes: readonly LessonNode[];
  /** Paths of the files that it names. */
  readonly named: readonly string[];
  readonly problems: readonly LessonProblem[];
  /** What of a page's head is left out, in words. */
  readonly left: readonly string[];
  /** What the head of a page says; null where it does not. */
  readonly head: Readonly<Record<'title' | 'language' | 'license' | 'author', string | null>>;
}

/** The longest HTML, in characters. */
const maxHtml = 2e6;

/** Elements inside each other. */
const maxDepth = 100;

/** Problems that are listed: an author reads no more. */
const maxProblems = 50;

/** Reads the HTML of a lesson. Only what the table allows is in `nodes`; all else is a problem. */
export function readLesson(html: string): LessonContent {
  const reader = new LessonReader();
  if (html.length > maxHtml) reader.refuse(`got HTML of ${html.length} characters; expected at most ${maxHtml}`, null);
  else reader.read(html);
  return reader;
}

class LessonReader implements LessonContent {
  nodes: LessonNode[] = [];
  readonly problems: LessonProblem[] = [];
  readonly left: string[] = [];
  readonly head: Record<'title' | 'language' | 'license' | 'author', string | null> = {
    title: null,
    language: null,
    license: null,
    author: null,
  };
  readonly #named = new Set<string>();

  get named(): readonly string[] {
    return [...this.#named];
  }

  refuse(message: string, node: ChildNode | null): void {
    const line = node?.sourceCodeLocation?.startLine ?? null;
    if (this.problems.length < maxProblems) this.problems.push({ message, line });
  }

  read(html: string): void {
    const document = parse(html, { sourceCodeLocationInfo: true, scriptingEnabled: false });
    for (const root of document.childNodes) {
      if (!('tagName' in root)) continue;
      this.head.language = valueOf(root, 'lang')?.trim() || null;
      this.#refuseHandlers(root);
      for (const part of root.childNodes) {
        if (!('tagName' in part)) continue;
        this.#refuseHandlers(part);
        if (part.tagName === 'head') part.childNodes.forEach((node) => this.#readHead(node));
        else if (part.tagName === 'body') this.nodes = this.#readAll(part.childNodes, 0);
        else this.#refuseElement(part);
      }
    }
    if (!this.nodes.some(hasView) && this.problems.length === 0)
      this.refuse('got no <volume-view>; expected at least one', null);
  }

  #readHead(node: ChildNode): void {
    if (!('tagName' in node)) return;
    const { tagName } = node;
    if (tagName === 'title') this.head.title = textOf(node).trim().replace(/\s+/g, ' ') || null;
    else if (tagName === 'meta') {
      const name = valueOf(node, 'name')?.toLowerCase();
      if (name === 'license' || name === 'author') this.head[name] = valueOf(node, 'content')?.trim() || null;
    } else if (tagName === 'script') this.#readScript(node);
    else if (tagName === 'link') {
      if (!/(^|\/)volume-view\.css$/.test(valueOf(node, 'href') ?? ''))
        this.left.push('<link>: a lesson has a style sheet of its own');
    } else if (tagName === 'style') this.left.push('<style>: a lesson has a style sheet of its own');
    else this.#refuseElement(node);
  }

  /** Other attributes of the page itself, such as its class, are left out. */
  #refuseHandlers(node: Element): void {
    for (const { name } of node.attrs) if (name.startsWith('on')) this.#refuseAttribute(node, name);
  }

  /** The script of the element comes with each lesson; no other may. */
  #readScript(node: Element): void {
    if (!/(^|\/)volume-[\w-]+(\.iife)?\.js$/.test(valueOf(node, 'src') ?? '') || textOf(node).trim() !== '')
      this.refuse(
        'got <script>; expected none: a lesson runs no script but that of <volume-view>, which comes with it',
        node,
      );
  }

  #readAll(nodes: readonly ChildNode[], depth: number): LessonNode[] {
    if (depth > maxDepth) {
      this.refuse(`got more than ${maxDepth} elements inside each other`, nodes[0] ?? null);
      return [];
    }
    return nodes.flatMap((node): LessonNode[] => {
      if (node.nodeName === '#text') return [(node as DefaultTreeAdapterTypes.TextNode).value];
      if (!('tagName' in node)) return []; // A comment.
      if (node.tagName === 'script') this.#readScript(node);
      else if (node.namespaceURI !== htmlNames.NS.HTML || !isAllowedElement(node.tagName)) this.#refuseElement(node);
      else return [this.#readElement(node, depth)];
      return [];
    });
  }

  #readElement(node: Element, depth: number): LessonElement {
    const attributes: [string, string][] = [];
    for (const { name, value } of node.attrs) {
      if (!isAllowedAttribute(node.tagName, name)) this.#refuseAttribute(node, name);
      else if (name === 'href' && !isLink(value.trim()))
        this.refuse(`<a> got href="${short(value)}"; expected https://…, mailto:…, or #…`, node);
      else {
        if (fileAttributes.includes(name)) this.#readFiles(node, name, value);
        attributes.push([name, value]);
      }
    }
    return { name: node.tagName, attributes, children: this.#readAll(node.childNodes, depth + 1) };
  }

  /** An attribute that names files: one, or several with blanks between them. */
  #readFiles(node: Element, name: string, value: string): void {
    const paths = listAddresses(value).map((address) => ({ address, file: readAddress(address) }));
    for (const { address, file } of paths) {
      if (file) this.#named.add(file.path);
      else
        this.refuse(
          `<${node.tagName}> got ${name}="${short(address)}"; expected a file in the folder of the lesson, like "head.nii.gz"`,
          node,
        );
    }
    const [first] = paths;
    if (name === 'src' && paths.length === 1 && /\.(?:mhd|nhdr|hdr|img|head|brik)$/i.test(first.file?.path ?? ''))
      this.refuse(
        `<${node.tagName}> got src="${short(value)}", which has its numbers in a second file; expected one file with all, like .mha, .nrrd or .nii.gz`,
        node,
      );
  }

  #refuseElement(node: Element): void {
    this.refuse(`got <${short(node.tagName)}>; expected text, pictures, and elements of volume-view`, node);
  }

  #refuseAttribute(node: Element, name: string): void {
    const reason = name.startsWith('on')
      ? 'a lesson runs no script'
      : name === 'style'
        ? 'a lesson has a style sheet of its own'
        : `the reference has the attributes of <${node.tagName}>`;
    this.refuse(`<${node.tagName}> got ${short(name)}; expected none: ${reason}`, node);
  }
}

/** The addresses in the value of an attribute. */
export const listAddresses = (value: string): string[] => value.split(/[\t\n\f\r ]+/).filter(Boolean);

const valueOf = (node: Element, name: string): string | null =>
  node.attrs.find((one) => one.name === name)?.value ?? null;

const textOf = (node: Element): string =>
  node.childNodes.map((child) => ('value' in child ? child.value : '')).join('');

const hasView = (node: LessonNode): boolean =>
  typeof node !== 'string' && (/^volume-(view|slice-view)$/.test(node.name) || node.children.some(hasView));

/** A text of the lesson in a message: on one line, and not long. */
const short = (text: string): string => {
  const plain = text.replace(/[\p{Cc}\p{Cs}]+/gu, ' ');
  return plain.length > 60 ? `${plain.slice(0, 57)}…` : plain;
};
