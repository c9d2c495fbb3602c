// The part of `npm test` that runs all cases that fuzzing ever found, and those with names, each with its memory measured.
import assert from 'node:assert/strict';
import { check, finish } from '../package/checks.mjs';
import { bundleWorker } from './bundle.mjs';
import { listCorpus } from './corpus-files.mjs';
import { Oracle } from './oracle.mjs';

/** Of so many sound cases of a format, this share must be volumes: else the grammar makes noise. */
const soundCases = 20;
const minVolumes = 0.6;

const oracle = new Oracle(await bundleWorker());
await oracle.ready();

/** @param {string} name @param {import('./messages.ts').Order} order */
const checkCase = (name, order) =>
  check(name, async () => {
    const { verdict } = await oracle.run(order);
    const { outcome, finding, ms, peak } = verdict;
    assert.equal(finding, null, finding ? `${finding.kind}: ${finding.detail}` : '');
    return `${outcome}, ${ms.toFixed(0)} ms, ${(peak / 2 ** 20).toFixed(1)} MB`;
  });

for (const format of oracle.formats) {
  await check(`${format}: what is sound is read`, async () => {
    let read = 0;
    for (let index = 0; index < soundCases; index++) {
      const { verdict } = await oracle.run({ type: 'sound', format, index });
      assert.equal(verdict.finding, null, verdict.finding?.detail);
      read += Number(verdict.outcome === 'volume' || verdict.outcome === 'value' || format === 'attributes');
    }
    assert.ok(read >= minVolumes * soundCases, `${read} of ${soundCases} are volumes`);
    return `${read} of ${soundCases}`;
  });
}
for (const name of oracle.named) await checkCase(name, { type: 'named', name });
for (const { name, found, made } of listCorpus())
  await checkCase(`${name}: was ${found.slice(0, 80)}`, { type: 'given', made });
await oracle.restart();
finish();
