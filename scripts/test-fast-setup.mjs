// Lets tests in Node fetch files of the project by their paths, as from the test server in a browser.
import { readFileSync } from 'node:fs';
import { findFile, findSharedData, projectRoot } from './shared-data.mjs';

const fetchFromNetwork = globalThis.fetch;

/** @type {typeof fetch} */
globalThis.fetch = async (input, init) => {
  if (typeof input !== 'string' || !input.startsWith('/')) return fetchFromNetwork(input, init);
  const file = findSharedData(input) ?? findFile(projectRoot, input.slice(1));
  return file ? new Response(readFileSync(file)) : new Response(null, { status: 404 });
};

// See test/helpers/cases.ts.
if (process.env.VOLUME_VIEW_ALL_CASES) Reflect.set(globalThis, '__allCases', true);
