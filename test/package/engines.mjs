// Who installs this project with the oldest Node that it names hears nothing of engines: no package asks for a newer one.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';

/** @param {string} name */
const read = (name) => JSON.parse(readFileSync(join(projectRoot, name), 'utf8'));

/**
 * Whether the newest Node of a major version is in a range, of those that packages write: `>=18`, `^20.19.0 || >=22`, `18 || 20`, `*`.
 * @param {string} range
 * @param {number} major
 */
function admits(range, major) {
  return range.split('||').some((part) => {
    const bounds = [...part.matchAll(/(>=|>|<=|<|\^|~|=)?\s*v?(\d+|\*|x)/g)].filter(
      ({ index }) => index === 0 || part[index - 1] !== '.',
    );
    return bounds.every(([, sign = '=', number]) => {
      if (number === '*' || number === 'x') return true;
      if (sign === '>=' || sign === '>') return Number(number) <= major;
      if (sign === '<') return Number(number) > major;
      if (sign === '<=') return Number(number) >= major;
      return Number(number) === major;
    });
  });
}

const min = Number(/\d+/.exec(read('package.json').engines.node)?.[0]);

await check('ranges are read as they are meant', () => {
  const ranges = {
    '>=18': true,
    '>=22.0.0': false,
    '^20.19.0 || ^22.13.0 || >=24': true,
    '^22.13.0 || >=24': false,
    '18 || 20 || >=22': true,
    '>= 14': true,
    '*': true,
    '': true,
    '>=10 <20': false,
    '>=16.0.0 <23': true,
    '20.x': true,
  };
  for (const [range, expected] of Object.entries(ranges)) assert.equal(admits(range, 20), expected, range);
});

await check(`no package asks for a newer Node than ${min}, which package.json names`, () => {
  const asking = Object.entries(read('package-lock.json').packages)
    .filter(([, { engines, optional }]) => engines?.node && !optional && !admits(engines.node, min))
    .map(([path, { version, engines }]) => `${path} ${version} asks for ${engines.node}`);
  assert.deepEqual(asking, []);
});

finish();
