// A DICOMweb server of a fuzz case.
import { joinPieces } from '../../src/formats/base/join-pieces.ts';
import type { FuzzFile, WebCase } from './fuzz-case.ts';

export const webSeries = 'https://example.test/studies/1.2/series/1.3';

/** Answers as `fetch` does. */
export function answerWeb(files: readonly FuzzFile[], web: WebCase): typeof fetch {
  let asked = 0;
  const byName = new Map(files.map(({ name, bytes }) => [name, bytes] as const));
  const isOne = (place: number, some: { readonly every: number } | null): boolean =>
    some !== null && place % some.every === some.every - 1;
  const respond = (bytes: Uint8Array<ArrayBuffer>, type: string, place: number): Response => {
    const there = isOne(place, web.cuts) ? bytes.subarray(0, Math.floor(web.cuts!.at * bytes.length)) : bytes;
    const end = isOne(place, web.breaks) ? Math.floor(web.breaks!.at * there.length) : Infinity;
    let at = 0;
    const body = new ReadableStream<Uint8Array>({
      pull: (controller) => {
        if (at >= end) return controller.error(new TypeError('network error'));
        if (at >= there.length) return controller.close();
        controller.enqueue(there.slice(at, (at += Math.min(web.pieceBytes, end - at))));
      },
    });
    return new Response(body, {
      headers: {
        ...(type === '' ? {} : { 'content-type': type }),
        ...(web.liesBy === null ? {} : { 'content-length': String(Math.max(0, there.length + web.liesBy)) }),
      },
    });
  };
  return async (address, options) => {
    const { pathname } = new URL(address as string);
    const place = asked++;
    if (pathname.endsWith('/metadata')) return respond(byName.get('metadata')!, web.listType, place);
    if (isOne(place, web.status)) return new Response(null, { status: web.status!.code });
    if (web.isPlain && new Headers(options?.headers).get('accept')?.includes('transfer-syntax'))
      return new Response(null, { status: 406 });
    const found = findParts(pathname, byName);
    if (found.includes(undefined)) return new Response(null, { status: 404 });
    const parts = [...(found as Uint8Array<ArrayBuffer>[])];
    for (let n = web.moreParts; n > 0; n--) parts.push(parts[0]);
    if (web.moreParts < 0) parts.splice(0, -web.moreParts);
    return respond(
      web.type.startsWith('multipart/') ? joinParts(parts, web) : (parts[0] ?? new Uint8Array()),
      web.type,
      place,
    );
  };
}

function findParts(
  pathname: string,
  byName: ReadonlyMap<string, Uint8Array<ArrayBuffer>>,
): (Uint8Array<ArrayBuffer> | undefined)[] {
  const [, uid, list] = /\/instances\/([^/]*)\/frames\/([\d,]+)$/.exec(pathname) ?? [];
  if (list) return list.split(',').map((frame) => byName.get(`${uid}/${frame}`));
  return [byName.get(pathname.split('/').slice(-2).join('/'))];
}

function joinParts(
  parts: readonly Uint8Array<ArrayBuffer>[],
  { boundary, header, lineEnd, partType, preamble }: WebCase,
): Uint8Array<ArrayBuffer> {
  const write = (text: string): Uint8Array<ArrayBuffer> => Uint8Array.from(text, (c) => c.charCodeAt(0) & 0xff);
  const lines = header ?? `Content-Type: ${partType}`;
  const pieces = [
    write(preamble),
    ...parts.flatMap((bytes) => [write(`--${boundary}${lineEnd}${lines}${lineEnd}${lineEnd}`), bytes, write(lineEnd)]),
    write(`--${boundary}--`),
  ];
  return joinPieces(pieces);
}
