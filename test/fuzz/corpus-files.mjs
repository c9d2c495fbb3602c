// Cases that were found: each a file in the folder `corpus`, its files packed, as many of them are bombs.
import { createHash } from 'node:crypto';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { deflateRawSync, inflateRawSync } from 'node:zlib';

/** @typedef {import('./fuzz-case.ts').FuzzCase} FuzzCase */
/** @typedef {import('./verdict.ts').Verdict} Verdict */
/** @typedef {{ name: string, format: string, found: string, made: FuzzCase }} CorpusCase */

const folder = new URL('corpus/', import.meta.url);

/** @returns {CorpusCase[]} */
export function listCorpus() {
  const names = readdirSync(folder).filter((name) => name.endsWith('.json'));
  return names.map((name) => ({
    name: name.replace(/\.json$/, ''),
    ...unpack(JSON.parse(readFileSync(new URL(name, folder), 'utf8'))),
  }));
}

/**
 * @param {{ format: string, seed: number, index: number, made: FuzzCase, verdict: Verdict }} found
 * @returns {string} the file's name
 */
export function saveCase({ format, seed, index, made, verdict }) {
  const kind = verdict.finding?.kind ?? 'sound';
  const packed =
    'files' in made
      ? {
          ...made,
          files: made.files.map(({ name, bytes }) => ({
            name,
            packed: Buffer.from(deflateRawSync(bytes, { level: 9 })).toString('base64'),
          })),
        }
      : made;
  const text = JSON.stringify(
    { format, seed, index, found: `${kind}: ${verdict.finding?.detail.split('\n')[0] ?? ''}`, ...packed },
    null,
    1,
  );
  const mark = createHash('sha256').update(text).digest('hex').slice(0, 6);
  const name = `${format}-${kind.split(/\W+/).slice(0, 2).join('-').toLowerCase()}-${mark}.json`;
  writeFileSync(new URL(name, folder), `${text}\n`);
  return name;
}

/** @param {any} saved */
function unpack({ format, found, seed: _seed, index: _index, ...made }) {
  if (!made.files) return { format, found, made };
  /** @param {{ name: string, packed: string }} file */
  const unpackFile = ({ name, packed }) => ({
    name,
    bytes: new Uint8Array(inflateRawSync(Buffer.from(packed, 'base64'))),
  });
  return { format, found, made: { ...made, files: made.files.map(unpackFile) } };
}
