import { html as htmlNames, parse } from 'parse5';
import type { DefaultTreeAdapterTypes } from 'parse5';
import { checkLessonHtml } from './check-lesson-html.ts';
import type { LessonContent, ParsedElement, ParsedNode } from './check-lesson-html.ts';

/** Reads the HTML of a lesson. Only what the table allows is in `nodes`; all else is a problem. */
export const readLesson = (html: string): LessonContent =>
  checkLessonHtml(html, (text) =>
    listNodes(parse(text, { sourceCodeLocationInfo: true, scriptingEnabled: false }).childNodes).filter(
      (node) => typeof node !== 'string',
    ),
  );

/** An element of parse5. Its children are made when they are asked for: a hostile tree may be very deep. */
class Parsed5 implements ParsedElement {
  constructor(readonly element: DefaultTreeAdapterTypes.Element) {}

  get name(): string {
    return this.element.tagName;
  }

  get isHtml(): boolean {
    return this.element.namespaceURI === htmlNames.NS.HTML;
  }

  get line(): number | null {
    return this.element.sourceCodeLocation?.startLine ?? null;
  }

  get attributes(): ParsedElement['attributes'] {
    return this.element.attrs;
  }

  get children(): readonly ParsedNode[] {
    return listNodes(this.element.childNodes);
  }
}

const listNodes = (nodes: readonly DefaultTreeAdapterTypes.ChildNode[]): ParsedNode[] =>
  nodes.flatMap((node): ParsedNode[] => {
    if ('tagName' in node) return [new Parsed5(node)];
    return node.nodeName === '#text' ? [node.value] : [];
  });
