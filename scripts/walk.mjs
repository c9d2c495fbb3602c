// A long random walk through the states of an element: `npm run walk -- --steps 2000 --seed 7 --engine Firefox`; see test/engines/walk.js.
import { spawnSync } from 'node:child_process';
import { parseArgs } from 'node:util';
import { projectRoot } from './shared-data.mjs';

const { values } = parseArgs({
  options: {
    steps: { type: 'string', default: '2000' },
    seed: { type: 'string', default: String(Math.ceil(Math.random() * 1e6)) },
    engine: { type: 'string', default: 'Chromium' },
    minutes: { type: 'string', default: '30' },
  },
});
const page = `/test/engines/walk.html?steps=${values.steps}&seed=${values.seed}`;
console.log(`${values.steps} steps with seed ${values.seed} in ${values.engine}`);
const { status } = spawnSync(
  process.execPath,
  ['test/engines/run.mjs', '--page', page, '--only', values.engine, '--minutes', values.minutes],
  { cwd: projectRoot, stdio: 'inherit' },
);
process.exitCode = status ?? 1;
