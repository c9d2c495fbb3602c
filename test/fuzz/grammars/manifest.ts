import schema from '../../../schema/manifest.json';
import { big, concat } from '../bytes.ts';
import { damage } from '../fuzz-case.ts';
import type { FuzzFile, Grammar } from '../fuzz-case.ts';
import type { Random } from '../random.ts';
import { deflateSync } from 'node:zlib';
import { packChunk, pngSignature } from './png.ts';

/** As far as the schema of manifests uses JSON schema. */
interface Schema {
  readonly type?: string;
  readonly $ref?: string;
  readonly properties?: Readonly<Record<string, Schema | false>>;
  readonly items?: Schema;
  readonly prefixItems?: readonly Schema[];
  readonly oneOf?: readonly Schema[];
  readonly enum?: readonly unknown[];
  readonly const?: unknown;
  readonly examples?: readonly unknown[];
  readonly minItems?: number;
  readonly maxItems?: number;
  readonly minimum?: number;
  readonly maximum?: number;
}

const root = schema as unknown as Schema;
const definitions = schema.$defs as unknown as Readonly<Record<string, Schema>>;

/** What manifests name: sound files, as what is tested is the manifest. */
const files: readonly FuzzFile[] = [
  { name: 'image.png', bytes: grayPng(12, 12) },
  { name: 'flat.png', bytes: grayPng(4, 3) },
];

export function grayPng(width: number, height: number): Uint8Array<ArrayBuffer> {
  const rows = Uint8Array.from({ length: (width + 1) * height }, (_, i) =>
    i % (width + 1) === 0 ? 0 : (i * 37) & 0xff,
  );
  return concat([
    big().text(pngSignature).finish(),
    packChunk({ name: 'IHDR', data: big().u32(width, height).u8(8, 0, 0, 0, 0).finish() }),
    packChunk({ name: 'IDAT', data: deflateSync(rows) }),
    packChunk({ name: 'IEND', data: new Uint8Array() }),
  ]);
}

/** Manifests as the schema has them, with values of other kinds, sizes and lengths here and there. */
export const manifest: Grammar = (random) => {
  const kind = random.pick(['image', 'image', 'image', 'radar', 'radar', 'files', 'scans']);
  const text = JSON.stringify(makeObject(random, kind)) ?? '{}';
  const wrapped = random.or(
    text,
    '['.repeat(20_000),
    `{"a":${'{"a":'.repeat(5000)}1${'}'.repeat(5000)}}`,
    `\ufeff${text}`,
    `{"image": "image.png", "title": "${'x'.repeat(100_000)}"}`,
  );
  return {
    files: [{ name: 'scan.json', bytes: damage(random, new TextEncoder().encode(wrapped)) }, ...files],
    settings: random.isWild() ? { scan: { index: random.size(0) } } : {},
  };
};

function makeObject(random: Random, kind: string): unknown {
  const shared = {
    ...chooseFields(random, root, [...sourceFields, 'mosaic', 'elevations', 'sweeps', 'lossy']),
    ...(random.chance(0.2) ? { lossy: makeLossy(random) } : {}),
    mosaic: random.or('3x2', '1x1', '99999x99999', '12x12'),
  };
  const image = random.or(
    'image.png',
    'flat.png',
    'missing.png',
    'scan.json',
    '',
    '//',
    'data:,x',
    'blob:x',
    'javascript:1',
  );
  if (kind === 'files') return { ...shared, mosaic: undefined, files: repeat(random, 'image.png') };
  const time = random.pick(['2018-12-20T06:06:28Z', '12.5 s', '-1e99 ms']);
  if (kind === 'scans') return { ...shared, scans: repeat(random, { image, time }) };
  // A picture's bytes are numbers too.
  if (kind === 'image') return random.chance(0.2) ? { ...shared, image, raw: makeRaw(random) } : { ...shared, image };
  const tiles = random.int(1, 6);
  const elevations = Array.from({ length: tiles }, (_, i) => random.number(0.5 + i));
  const sweeps = random.chance(0.5)
    ? Array.from({ length: random.size(tiles) % 50 }, () => makeSweep(random))
    : undefined;
  // All tiles are sweeps.
  return { ...shared, slices: undefined, image, elevations, range: [random.number(250), random.number(500)], sweeps };
}

const sourceFields = ['image', 'files', 'video', 'scans', 'raw'];

function makeLossy(random: Random): unknown {
  const error = { rms: random.number(1), p99: random.number(2), max: random.number(3) };
  return random.or<unknown>(error, { ...error, picture: error }, { rms: 1 }, 'much');
}

function makeRaw(random: Random): unknown {
  return {
    type: random.or('uint8', 'int16', 'float64', 'x'),
    dimensions: [4, 3, 2].map((n) => random.size(n)),
    ...(random.chance(0.5) ? { offset: random.size(8), endian: random.or('little', 'big', 'x') } : {}),
  };
}

/** A tile of the image has 4 x 6 pixels. */
function makeSweep(random: Random): unknown {
  const sweep = (root.properties!.sweeps as Schema).items!;
  return {
    ...chooseFields(random, sweep, ['rays', 'gates', 'azimuths', 'elevations', 'range']),
    ...(random.chance(0.25) ? { range: [random.number(250), random.number(500)] } : {}),
    ...(random.chance(0.5)
      ? { rays: random.size(3), azimuths: [0, 120, 240].map((angle) => random.number(angle)) }
      : {}),
    ...(random.chance(0.5) ? { gates: random.size(2) } : {}),
  };
}

function repeat(random: Random, item: unknown): unknown[] {
  return Array.from({ length: random.isWild() ? random.pick([0, 100, 10_000]) : random.int(1, 3) }, () =>
    random.or(item, null, {}, 'flat.png', { image: 'flat.png' }, { scans: [] }),
  );
}

/** Some fields of an object. */
function chooseFields(
  random: Random,
  { properties = {} }: Schema,
  without: readonly string[],
): Record<string, unknown> {
  const chosen = Object.entries(properties).filter(
    ([name, one]) => one && !without.includes(name) && random.chance(0.25),
  );
  return Object.fromEntries(
    chosen.map(([name, one]) => [random.or(name, '__proto__', 'constructor'), makeValue(random, one as Schema)]),
  );
}

/** A value that fits, or another one. */
function makeValue(random: Random, one: Schema): unknown {
  if (random.isWild())
    return random.pick([
      null,
      true,
      '',
      'x'.repeat(3000),
      -1,
      1e308,
      -1e308,
      1e-308,
      [],
      {},
      [[[[]]]],
      Array.from({ length: 5000 }, () => 1),
      { length: 1e9 },
    ]);
  if (one.$ref)
    return makeValue(random, one.$ref === '#' ? { type: 'object' } : definitions[one.$ref.split('/').at(-1)!]);
  if (one.const !== undefined) return one.const;
  if (one.enum) return random.pick(one.enum);
  if (one.oneOf && !one.type) return makeValue(random, random.pick(one.oneOf));
  if (one.examples) return random.pick(one.examples);
  if (one.type === 'array') return makeList(random, one);
  if (one.type === 'object') return chooseFields(random, one, []);
  if (one.type === 'boolean') return random.chance(0.5);
  if (one.type === 'string') return random.or('linear', 'words', '0 red 0, 1 blue 1', 'constructor');
  const [low, high] = [one.minimum ?? 1, one.maximum ?? 90];
  return one.type === 'integer' ? random.size(Math.max(low, 1)) : random.number(low + random.unit() * (high - low));
}

function makeList(random: Random, { items, prefixItems, minItems = 1, maxItems = 6 }: Schema): unknown[] {
  if (prefixItems) return random.shuffle(prefixItems.map((item) => makeValue(random, item)));
  return random.shuffle(Array.from({ length: random.int(minItems, maxItems) }, () => makeValue(random, items ?? {})));
}
