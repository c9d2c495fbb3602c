// A DICOMweb server of a few instances, on this machine, with the faults that servers have. In Node.
import { createServer } from 'node:http';
import type { IncomingMessage, ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { dicomJson } from './dicom-bytes.ts';
import type { DicomFields } from './dicom-bytes.ts';

export interface WebInstance {
  readonly fields: DicomFields;
  /** Packed frames, with how they are packed. */
  readonly packed?: { readonly syntax: string; readonly type: string; readonly frames: readonly Uint8Array[] };
}

export interface Faults {
  /** Without this in the header Authorization, the answer is 401. */
  readonly token?: string;
  /** Of another origin that may read the answers; no other may. */
  readonly allowed?: string;
  /** How often the frames of an instance, by its place in the list, are cut short. */
  readonly cut?: { readonly place: number; times: number };
  /** The frames of this instance are missing. */
  readonly missing?: number;
  /** Milliseconds between two pieces of each answer with frames. */
  readonly slowMs?: number;
  /** In place of the list of instances. */
  readonly metadata?: { readonly type: string; readonly text: string };
}

export interface DicomWebServer {
  readonly origin: string;
  /** Of the series. */
  readonly url: string;
  /** Paths of all requests with GET, below the series. */
  readonly asked: readonly string[];
  /** Answers with frames that were sent at the same time. */
  readonly most: () => number;
  close(): Promise<void>;
}

const series = '/dicom-web/studies/1.2.77.1/series/1.2.77.2';

export async function startDicomWeb(instances: readonly WebInstance[], faults: Faults = {}): Promise<DicomWebServer> {
  const asked: string[] = [];
  let [running, most] = [0, 0];
  const idOf = ({ fields }: WebInstance): string => fields.SOPInstanceUID as string;
  const answer = async (request: IncomingMessage, response: ServerResponse): Promise<void> => {
    const path = request.url!;
    if (faults.allowed) {
      response.setHeader('Access-Control-Allow-Origin', faults.allowed);
      response.setHeader('Access-Control-Allow-Headers', 'authorization, accept');
    }
    if (request.method === 'OPTIONS') return void response.writeHead(204).end();
    asked.push(path.slice(series.length));
    if (faults.token && request.headers.authorization !== faults.token) return void response.writeHead(401).end();
    if (path === `${series}/metadata` || path.endsWith('/metadata')) {
      const list = instances.filter((one) => path === `${series}/metadata` || path.includes(`/${idOf(one)}/`));
      const { type, text } = faults.metadata ?? {
        type: 'application/dicom+json',
        // As behind another server: with a host that nobody reaches.
        text: JSON.stringify(
          list.map((one) =>
            dicomJson(
              one.fields,
              (tag) => `http://inner.invalid:8042/x${series.slice(10)}/instances/${idOf(one)}/bulk/${tag}`,
            ),
          ),
        ),
      };
      return void response.setHeader('Content-Type', type).end(text);
    }
    const [, id, kind, list] = /\/instances\/([\d.]+)\/(frames|bulk)\/([\dA-F,]+)$/.exec(path) ?? [];
    const place = instances.findIndex((one) => idOf(one) === id);
    const instance = instances[place];
    if (!instance || (kind === 'frames' && place === faults.missing)) return void response.writeHead(404).end();
    most = Math.max(most, ++running);
    await send(response, kind === 'bulk' ? [bulkOf(instance, list)] : framesOf(instance, list), {
      isCut: kind === 'frames' && place === faults.cut?.place && faults.cut.times-- > 0,
      slowMs: faults.slowMs ?? 5,
    });
    running--;
  };
  const server = createServer((request, response) => void answer(request, response));
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const origin = `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
  return {
    origin,
    url: `${origin}${series}`,
    asked,
    most: () => most,
    close: () => new Promise((resolve) => void (server.closeAllConnections(), server.close(() => resolve()))),
  };
}

interface SentPart {
  readonly type: string;
  readonly bytes: Uint8Array;
}

function bulkOf({ fields }: WebInstance, tag: string): SentPart {
  const json = Object.keys(fields) as (keyof DicomFields)[];
  const keyword = json.find((one) => tag in dicomJson({ [one]: fields[one] }, () => ''))!;
  return { type: 'application/octet-stream', bytes: fields[keyword] as Uint8Array };
}

function framesOf({ fields, packed }: WebInstance, list: string): SentPart[] {
  const pixels = fields.PixelData as Uint8Array;
  const count = Number((fields.NumberOfFrames as string | undefined) ?? 1);
  const size = pixels.length / count;
  return list.split(',').map((number) => {
    const i = Number(number) - 1;
    return packed
      ? { type: `${packed.type}; transfer-syntax=${packed.syntax}`, bytes: packed.frames[i] }
      : { type: 'application/octet-stream', bytes: pixels.subarray(i * size, (i + 1) * size) };
  });
}

async function send(
  response: ServerResponse,
  parts: readonly SentPart[],
  { isCut, slowMs }: { readonly isCut: boolean; readonly slowMs: number },
): Promise<void> {
  const boundary = 'part-of-it';
  response.setHeader('Content-Type', `multipart/related; type="application/octet-stream"; boundary=${boundary}`);
  for (const { type, bytes } of parts) {
    response.write(`--${boundary}\r\nContent-Type: ${type}\r\nMIME-Version: 1.0\r\n\r\n`);
    response.write(isCut ? bytes.subarray(0, bytes.length >> 1) : bytes);
    await new Promise((resolve) => setTimeout(resolve, slowMs));
    if (isCut) return void response.end();
    response.write('\r\n');
  }
  response.end(`--${boundary}--`);
}

/** Runs with a server, which ends with it. */
export async function withWeb<T>(
  instances: readonly WebInstance[],
  faults: Faults,
  run: (server: DicomWebServer) => Promise<T>,
): Promise<T> {
  const server = await startDicomWeb(instances, faults);
  try {
    return await run(server);
  } finally {
    await server.close();
  }
}
