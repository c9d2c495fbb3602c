#!/usr/bin/env node
// npm links a program when it installs, and only if its file is there; what it runs is built later.
import { existsSync } from 'node:fs';

const program = new URL('../dist/volume-view-prepare.js', import.meta.url);
if (existsSync(program)) await import(program.href);
else {
  console.error(
    'volume-view-prepare: got no dist folder; expected one from `npm run build` in the folder of the project',
  );
  process.exitCode = 1;
}
