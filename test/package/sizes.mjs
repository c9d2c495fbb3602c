// Small files: each holds one idea, and a reader sees it whole.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';
import { listCode } from './list-code.mjs';

const LONGEST = 300;
/** Half of the files are shorter than this. */
const MEDIAN_BELOW = 100;

const files = listCode(/\.(ts|mjs|js|glsl|css|py|html)$/)
  .map((path) => ({ path, lines: readFileSync(join(projectRoot, path), 'utf8').split('\n').length - 1 }));
files.sort((a, b) => b.lines - a.lines);
const median = files[files.length >> 1].lines;

await check(`no file of code has more than ${LONGEST} lines`, () => {
  const tooLong = files.filter(({ lines }) => lines > LONGEST).map(({ path, lines }) => `${path}: ${lines} lines`);
  assert.ok(tooLong.length === 0, `split by what they hold:\n${tooLong.join('\n')}`);
  return `the longest of ${files.length}, ${files[0].path}, has ${files[0].lines}`;
});
await check(`the median is below ${MEDIAN_BELOW} lines`, () => {
  assert.ok(median < MEDIAN_BELOW, `${median} lines`);
  return `${median} lines`;
});
finish();
