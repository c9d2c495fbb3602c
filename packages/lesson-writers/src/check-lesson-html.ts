// The rules of a lesson, for HTML that a parser has read: parse5 in the writers, the browser itself in the page for frames.
import { fileAttributes, isAllowedAttribute, isAllowedElement } from './allowed-html.ts';
import { isLink, readAddress } from './lesson-paths.ts';
import type { LessonProblem } from './lesson.ts';

/** An element of the HTML, as a parser gives it. */
export interface ParsedElement {
  /** In lower case. */
  readonly name: string;
  /** Whether it is of HTML: SVG and MathML are not. */
  readonly isHtml: boolean;
  /** From 1; null where the parser does not know it. */
  readonly line: number | null;
  readonly attributes: readonly { readonly name: string; readonly value: string }[];
  /** Without comments. */
  readonly children: readonly ParsedNode[];
}

export type ParsedNode = string | ParsedElement;

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

/**
 * Reads the HTML of a lesson. Only what the table allows is in `nodes`; all else is a problem.
 * @param parse - gives the elements at the top of the document
 */
export function checkLessonHtml(html: string, parse: (html: string) => readonly ParsedElement[]): LessonContent {
  const reader = new LessonReader();
  if (html.length > maxHtml) reader.refuse(`got HTML of ${html.length} characters; expected at most ${maxHtml}`, null);
  else reader.read(parse(html));
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

  refuse(message: string, node: ParsedElement | null): void {
    const line = node?.line ?? null;
    if (this.problems.length < maxProblems) this.problems.push({ message, line });
  }

  read(roots: readonly ParsedElement[]): void {
    for (const root of roots) {
      this.head.language = valueOf(root, 'lang')?.trim() || null;
      this.#refuseHandlers(root);
      for (const part of root.children) {
        if (typeof part === 'string') continue;
        this.#refuseHandlers(part);
        if (part.name === 'head') part.children.forEach((node) => this.#readHead(node));
        else if (part.name === 'body') this.nodes = this.#readAll(part.children, 0);
        else this.#refuseElement(part);
      }
    }
    if (!this.nodes.some(hasView) && this.problems.length === 0)
      this.refuse('got no <volume-view>; expected at least one', null);
  }

  #readHead(node: ParsedNode): void {
    if (typeof node === 'string') return;
    const { name: tagName } = node;
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
  #refuseHandlers(node: ParsedElement): void {
    for (const { name } of node.attributes) if (name.startsWith('on')) this.#refuseAttribute(node, name);
  }

  /** The script of the element comes with each lesson; no other may. */
  #readScript(node: ParsedElement): void {
    if (!/(^|\/)volume-[\w-]+(\.iife)?\.js$/.test(valueOf(node, 'src') ?? '') || textOf(node).trim() !== '')
      this.refuse(
        'got <script>; expected none: a lesson runs no script but that of <volume-view>, which comes with it',
        node,
      );
  }

  #readAll(nodes: readonly ParsedNode[], depth: number): LessonNode[] {
    if (depth > maxDepth) {
      const [first = null] = nodes;
      this.refuse(`got more than ${maxDepth} elements inside each other`, typeof first === 'string' ? null : first);
      return [];
    }
    return nodes.flatMap((node): LessonNode[] => {
      if (typeof node === 'string') return [node];
      if (node.name === 'script') this.#readScript(node);
      else if (!node.isHtml || !isAllowedElement(node.name)) this.#refuseElement(node);
      else return [this.#readElement(node, depth)];
      return [];
    });
  }

  #readElement(node: ParsedElement, depth: number): LessonElement {
    const attributes: [string, string][] = [];
    for (const { name, value } of node.attributes) {
      if (node.name === 'a' && (name === 'rel' || name === 'target')) continue; // Each form of a lesson sets its own.
      if (!isAllowedAttribute(node.name, name)) this.#refuseAttribute(node, name);
      else if (name === 'href' && !isLink(value.trim()))
        this.refuse(`<a> got href="${short(value)}"; expected https://…, mailto:…, or #…`, node);
      else {
        if (fileAttributes.includes(name)) this.#readFiles(node, name, value);
        attributes.push([name, value]);
      }
    }
    return { name: node.name, attributes, children: this.#readAll(node.children, depth + 1) };
  }

  /** An attribute that names files: one, or several with blanks between them. */
  #readFiles(node: ParsedElement, name: string, value: string): void {
    const paths = listAddresses(value).map((address) => ({ address, file: readAddress(address) }));
    for (const { address, file } of paths) {
      if (file) this.#named.add(file.path);
      else
        this.refuse(
          `<${node.name}> got ${name}="${short(address)}"; expected a file in the folder of the lesson, like "head.nii.gz"`,
          node,
        );
    }
    const [first] = paths;
    if (name === 'src' && paths.length === 1 && /\.(?:mhd|nhdr|hdr|img|head|brik)$/i.test(first.file?.path ?? ''))
      this.refuse(
        `<${node.name}> got src="${short(value)}", which has its numbers in a second file; expected one file with all, like .mha, .nrrd or .nii.gz`,
        node,
      );
  }

  #refuseElement(node: ParsedElement): void {
    this.refuse(`got <${short(node.name)}>; expected text, pictures, and elements of volume-view`, node);
  }

  #refuseAttribute(node: ParsedElement, name: string): void {
    const reason = name.startsWith('on')
      ? 'a lesson runs no script'
      : name === 'style'
        ? 'a lesson has a style sheet of its own'
        : `the reference has the attributes of <${node.name}>`;
    this.refuse(`<${node.name}> got ${short(name)}; expected none: ${reason}`, node);
  }
}

/** The addresses in the value of an attribute. */
export const listAddresses = (value: string): string[] => value.split(/[\t\n\f\r ]+/).filter(Boolean);

const valueOf = (node: ParsedElement, name: string): string | null =>
  node.attributes.find((one) => one.name === name)?.value ?? null;

const textOf = (node: ParsedElement): string =>
  node.children.map((child) => (typeof child === 'string' ? child : '')).join('');

const hasView = (node: LessonNode): boolean =>
  typeof node !== 'string' && (/^volume-(view|slice-view)$/.test(node.name) || node.children.some(hasView));

/** A text of the lesson in a message: on one line, and not long. */
const short = (text: string): string => {
  const plain = text.replace(/[\p{Cc}\p{Cs}]+/gu, ' ');
  return plain.length > 60 ? `${plain.slice(0, 57)}…` : plain;
};
