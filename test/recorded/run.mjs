// `npm run record`: hashes of the pictures of many scenes, and whether they are still the same. See README.md.
// Exit status: 0 where all is well, 1 where pictures differ or have faults, 2 where it could not be found out.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { drawElements, elementScenes } from './draw-elements.mjs';
import { drawInner } from './draw-inner.mjs';
import { readOptions } from './options.mjs';
import { difference, findFaults, fromFile, hashOf, toFile } from './picture.mjs';

/** @typedef {import('./picture.mjs').Picture} Picture */
/** @typedef {{ name: string, width: number, height: number, sha256: string }} Entry */
/** @typedef {{ browser: string, renderer: string, pictures: Entry[] }} Recorded */

const recordedFile = fileURLToPath(new URL('pictures.json', import.meta.url));

/**
 * Draw all scenes that are wanted.
 * @param {(name: string) => boolean} wanted
 */
async function drawAll(wanted) {
  /** @type {Picture[]} */
  const pictures = [];
  /** @type {string[]} */
  const faults = [];
  const began = performance.now();
  const drawn = (/** @type {Picture | { name: string, failure: string }} */ result) => {
    if ('failure' in result) faults.push(`${result.name}: ${result.failure}`);
    else pictures.push(result);
    process.stderr.write(
      `\r\u001b[K${Math.round((performance.now() - began) / 1000)} s, ${pictures.length} pictures, ${result.name}`,
    );
  };
  const inner = await drawInner(wanted, drawn);
  const machine = elementScenes.some(({ name }) => wanted(name)) ? await drawElements(wanted, drawn) : inner;
  process.stderr.write('\r\u001b[K');
  return {
    pictures,
    faults: [...faults, ...findFaults(pictures)],
    where: { browser: machine.browser, renderer: machine.renderer },
  };
}

/** @param {string} folder @param {Picture} picture */
function writePicture(folder, picture) {
  const { file, bytes } = toFile(picture);
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, file), bytes);
}

/** One line for each picture, so that changes can be read. @param {Recorded} recorded */
function toJson({ browser, renderer, pictures }) {
  const lines = pictures.map((entry) => `    ${JSON.stringify(entry)}`);
  return `{\n  "browser": ${JSON.stringify(browser)},\n  "renderer": ${JSON.stringify(renderer)},\n  "pictures": [\n${lines.join(',\n')}\n  ]\n}\n`;
}

/** @param {Picture} picture @returns {Entry} */
const entryOf = (picture) => ({
  name: picture.name,
  width: picture.width,
  height: picture.height,
  sha256: hashOf(picture),
});

/**
 * How far a picture is from the recorded one.
 * @param {Picture} picture
 * @param {string | undefined} folder - of the recorded pictures
 */
function describeDifference(picture, folder) {
  const path = folder && join(folder, toFile(picture).file);
  if (!path || !existsSync(path)) return 'differs (by how much, --pictures FOLDER would tell)';
  const { max, rms, share } = difference(picture.data, fromFile(readFileSync(path), picture.kind), picture.kind);
  return `differs: max ${max.toPrecision(4)}, RMS ${rms.toPrecision(4)} (1/255), ${(share * 100).toPrecision(3)} % of the numbers`;
}

/**
 * @param {readonly Picture[]} pictures
 * @param {Recorded} recorded
 * @param {import('./options.mjs').Options} options
 * @returns {string[]} what is not as it was
 */
function compare(pictures, recorded, { pictures: folder, now, only }) {
  const before = new Map(recorded.pictures.map((entry) => [entry.name, entry]));
  const changes = pictures.flatMap((picture) => {
    const entry = before.get(picture.name);
    if (entry?.sha256 === hashOf(picture)) return [];
    if (now) writePicture(now, picture);
    return [`${picture.name}: ${entry ? describeDifference(picture, folder) : 'not recorded'}`];
  });
  const names = new Set(pictures.map(({ name }) => name));
  const gone = recorded.pictures.filter(({ name }) => name.includes(only) && !names.has(name));
  return [...changes, ...gone.map(({ name }) => `${name}: recorded, and not drawn`)];
}

/** @param {Omit<Recorded, 'pictures'>} here @param {Recorded} recorded */
const isElsewhere = (here, recorded) => here.browser !== recorded.browser || here.renderer !== recorded.renderer;

/** @param {readonly string[]} args */
async function main(args) {
  const options = readOptions(args);
  const file = options.file ?? recordedFile;
  const { pictures, faults, where } = await drawAll((name) => name.includes(options.only));
  console.log(`${pictures.length} pictures, ${where.browser}, ${where.renderer}`);
  for (const fault of faults) console.log(`FAULT ${fault}`);
  if (faults.length > 0 || pictures.length === 0) return 1;
  /** @type {Recorded | null} */
  const recorded = existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')) : null;
  if (options.check) {
    if (!recorded) throw new Error(`--check got ${file}, which is not there; expected what \`npm run record\` writes`);
    if (isElsewhere(where, recorded))
      console.log(
        `recorded elsewhere, where other hashes are to be expected: ${recorded.browser}, ${recorded.renderer}`,
      );
    const changes = compare(pictures, recorded, options);
    for (const change of changes) console.log(change);
    console.log(changes.length > 0 ? `${changes.length} are not as recorded` : 'all are as recorded');
    return changes.length > 0 ? 1 : 0;
  }
  const { pictures: folder } = options;
  if (folder) for (const picture of pictures) writePicture(folder, picture);
  if (options.only && recorded && isElsewhere(where, recorded))
    throw new Error(`--only got another browser or renderer than the rest of ${file}; record all of it`);
  const kept = options.only ? (recorded?.pictures ?? []).filter(({ name }) => !name.includes(options.only)) : [];
  writeFileSync(file, toJson({ ...where, pictures: [...kept, ...pictures.map(entryOf)] }));
  console.log(`written: ${file}`);
  return 0;
}

try {
  process.exitCode = await main(process.argv.slice(2));
} catch (error) {
  console.error(error instanceof Error ? error.message : String(error));
  process.exitCode = 2;
}
