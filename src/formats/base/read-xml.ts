/** Receives the parts of an XML text, in their order. */
export interface XmlListener {
  open(name: string, attributes: ReadonlyMap<string, string>): void;
  close(name: string): void;
  /** Text of the element that was opened last; in CDATA entities are not decoded. */
  text(text: string): void;
}

/** Maximum depth of nested elements. */
const maxDepth = 100;

const entities: Readonly<Record<string, string>> = { lt: '<', gt: '>', amp: '&', quot: '"', apos: "'" };

/**
 * Reads an XML text, as far as data files need it: elements, attributes, text, CDATA, comments. A worker has no
 * DOMParser. Entities that the text defines itself, which can make a small file endless, are not expanded.
 * Source: *Extensible Markup Language (XML) 1.0*, W3C
 * @throws {SyntaxError} if the text is not valid XML
 */
export function readXml(text: string, listener: XmlListener): void {
  const open: string[] = [];
  for (let at = 0; at < text.length;) {
    const tag = text.indexOf('<', at);
    const end = tag < 0 ? text.length : tag;
    if (end > at && open.length > 0) listener.text(decodeEntities(text.slice(at, end)));
    if (tag < 0) break;
    at = readMarkup(text, tag, open, listener);
  }
  if (open.length > 0) throw new SyntaxError(`<${open.at(-1)}> does not end`);
}

/** @returns where it ends */
function readMarkup(text: string, tag: number, open: string[], listener: XmlListener): number {
  if (text.startsWith('<!--', tag)) return endOf(text, '-->', tag);
  if (text.startsWith('<?', tag)) return endOf(text, '?>', tag);
  if (text.startsWith('<![CDATA[', tag)) {
    const end = endOf(text, ']]>', tag);
    listener.text(text.slice(tag + 9, end - 3));
    return end;
  }
  if (text.startsWith('<!', tag)) return endOfDeclaration(text, tag);
  if (text[tag + 1] === '/') {
    const end = endOf(text, '>', tag);
    const name = text.slice(tag + 2, end - 1).trim();
    if (open.pop() !== name) throw new SyntaxError(`</${name.slice(0, 40)}> ends another element`);
    listener.close(name);
    return end;
  }
  return readTag(text, tag, open, listener);
}

function readTag(text: string, tag: number, open: string[], listener: XmlListener): number {
  const name = match(/[^\s<>/="'&]+/y, text, tag + 1)?.[0];
  if (!name) throw new SyntaxError('there is a "<" without a name');
  const attributes = new Map<string, string>();
  let at = tag + 1 + name.length;
  for (let one = attributeAt(text, at); one; one = attributeAt(text, at)) {
    attributes.set(one[1], decodeEntities(one[2] ?? one[3]));
    at += one[0].length;
  }
  const end = match(/\s*(\/?)>/y, text, at);
  if (!end) throw new SyntaxError(`<${name.slice(0, 40)}> can not be read`);
  listener.open(name, attributes);
  if (end[1]) listener.close(name);
  else if (open.push(name) > maxDepth) throw new SyntaxError(`it is more than ${maxDepth} elements deep`);
  return at + end[0].length;
}

const attributeAt = (text: string, at: number): RegExpExecArray | null =>
  match(/\s+([^\s<>/="'&]+)\s*=\s*(?:"([^"<]*)"|'([^'<]*)')/y, text, at);

function match(pattern: RegExp, text: string, at: number): RegExpExecArray | null {
  pattern.lastIndex = at;
  return pattern.exec(text);
}

function endOf(text: string, mark: string, from: number): number {
  const end = text.indexOf(mark, from);
  if (end < 0) throw new SyntaxError('it ends early');
  return end + mark.length;
}

/** The end of a document type declaration, which may have an internal part in brackets. */
function endOfDeclaration(text: string, from: number): number {
  const end = endOf(text, '>', from);
  return text.slice(from, end).includes('[') ? endOf(text, ']>', from) : end;
}

function decodeEntities(text: string): string {
  if (!text.includes('&')) return text;
  return text.replace(
    /&(?:#(\d{1,7})|#x([\da-f]{1,6})|(\w+));/gi,
    (all, decimal?: string, hex?: string, name?: string) => {
      if (name) return Object.hasOwn(entities, name) ? entities[name] : all;
      const code = decimal ? Number(decimal) : Number.parseInt(hex!, 16);
      return code <= 0x10ffff ? String.fromCodePoint(code) : all;
    },
  );
}
