// What the program is asked for on its command line.
import { parseArgs } from 'node:util';

const usage = `npm run record -- [--check] [--pictures FOLDER] [--now FOLDER] [--only TEXT] [--file FILE]
  --check            compare with what is recorded; without it, record
  --pictures FOLDER  where the recorded pictures are: recording writes them, checking says how far others are from them
  --now FOLDER       with --check: write the pictures that differ
  --only TEXT        only scenes with TEXT in their name
  --file FILE        the hashes, instead of test/recorded/pictures.json`;

/**
 * @typedef {object} Options
 * @property {boolean} check
 * @property {string | undefined} pictures
 * @property {string | undefined} now
 * @property {string} only
 * @property {string | undefined} file
 */

/**
 * @param {readonly string[]} args
 * @returns {Options}
 * @throws with words for who typed them
 */
export function readOptions(args) {
  try {
    const { check, pictures, now, only, file } = parse(args);
    if (now && !check) throw new Error('--now got a folder without --check; expected both');
    return { check, pictures, now, only, file };
  } catch (error) {
    throw new Error(`${error instanceof Error ? error.message : String(error)}\n${usage}`, { cause: error });
  }
}

/** @param {readonly string[]} args */
function parse(args) {
  return parseArgs({
    args: [...args],
    options: {
      check: { type: 'boolean', default: false },
      pictures: { type: 'string' },
      now: { type: 'string' },
      only: { type: 'string', default: '' },
      file: { type: 'string' },
    },
  }).values;
}
