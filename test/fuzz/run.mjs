// `npm run fuzz -- --minutes N [--cases N] [--format F] [--seed S]`: cases of all formats, or of one. See docs/develop/fuzzing.md.
import { parseArgs } from 'node:util';
import { bundleWorker } from './bundle.mjs';
import { listCorpus, saveCase } from './corpus-files.mjs';
import { minimise } from './minimise.mjs';
import { Oracle } from './oracle.mjs';
import { Tally, formatTable } from './tally.mjs';

const { values } = parseArgs({
  options: {
    minutes: { type: 'string' },
    cases: { type: 'string' },
    format: { type: 'string' },
    seed: { type: 'string', default: '1' },
    'dry-run': { type: 'boolean', default: false },
  },
});
const seed = readNumber('seed', values.seed, 1);
const cases = readNumber('cases', values.cases, Infinity);
const minutes = readNumber('minutes', values.minutes, values.cases === undefined ? 5 : Infinity);

/** A worker learns which cases are worth changing; with each so many it begins anew, so that a case depends on few others. */
const batch = 1000;

const oracle = new Oracle(await bundleWorker());
await oracle.ready();
const formats = values.format === undefined ? oracle.formats : [values.format];
if (!formats.every((format) => oracle.formats.includes(format)))
  throw new Error(`--format got ${values.format}; expected one of ${oracle.formats.join(', ')}`);

// Ended early, it says what it has done.
const asked = new AbortController();
process.once('SIGINT', () => asked.abort());

/** @type {Tally[]} */
const tallies = [];
for (const format of formats) {
  const tally = new Tally(format);
  tallies.push(tally);
  const end = Date.now() + (minutes * 60_000) / formats.length;
  for (let index = 0; index < cases && Date.now() < end && !asked.signal.aborted; index++) {
    if (index % batch === 0) {
      await oracle.restart();
      if (index > 0) console.log(`${format}: ${index} cases`);
    }
    const { made, verdict } = await oracle.run({ type: 'draw', format, seed, index });
    const isNew = tally.add(index, verdict);
    if (!isNew) continue;
    console.log(
      `${format} ${index}: ${verdict.finding?.kind}: ${verdict.finding?.detail.split('\n').slice(0, 4).join(' | ')}`,
    );
    if (values['dry-run'] || !made) continue;
    const { made: small, verdict: last } = await minimise(oracle, made, verdict);
    console.log(`  saved as ${saveCase({ format, seed, index, made: small, verdict: last })}`);
  }
  console.log(`${format}: ${tally.cases} cases`);
}
console.log(`\nSeed ${seed}\n\n${formatTable(tallies)}\n`);
console.log(`${listCorpus().length} cases in the corpus`);
await oracle.restart();
process.exitCode = tallies.some(({ findings }) => findings.size > 0) ? 1 : 0;

/** @param {string} name @param {string | undefined} text @param {number} others */
function readNumber(name, text, others) {
  const value = text === undefined ? others : Number(text);
  if (!(value >= 0)) throw new Error(`--${name} got ${text}; expected a number`);
  return value;
}
