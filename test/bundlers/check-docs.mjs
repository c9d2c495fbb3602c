// What docs/guide/bundlers.md says is what the apps do: each marked block is in its file, each command is one that was run.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { apps } from './apps.mjs';

/** @param {string} path */
const read = (path) => readFileSync(join(projectRoot, path), 'utf8');

export function checkDocs() {
  const docs = read('docs/guide/bundlers.md');
  const blocks = [...docs.matchAll(/<!-- (\S+) -->\n```\w+\n([^]*?)```/g)];
  assert.ok(blocks.length > 3);
  for (const [, path, text] of blocks)
    assert.ok(read(path).includes(text), `docs/guide/bundlers.md shows what is not in ${path}:\n${text}`);
  for (const { command } of apps)
    assert.ok(
      docs.includes(`\`${command.replace(/ --no-autoinstall$/, '')}\``),
      `docs/guide/bundlers.md does not say: ${command}`,
    );
  return `${blocks.length} blocks, ${apps.length} commands`;
}
