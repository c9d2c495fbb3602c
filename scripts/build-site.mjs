// `npm run site` builds the pages of docs as a static folder, packages/site/dist, and serves it; in packages/site `npm run build` builds only. The
// element has been built before.
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildSite } from '../packages/site/build/build.mjs';
import { buildStudio } from './build-studio.mjs';
import { projectRoot } from './shared-data.mjs';
import { startStaticServer } from './static-server.mjs';

const folder = join(projectRoot, 'packages/site');

/** Build the folder dist. */
export async function makeSite() {
  if (!existsSync(join(projectRoot, 'packages/studio/dist/index.html'))) await buildStudio();
  return buildSite({ root: projectRoot, folder, out: join(folder, 'dist') });
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { pages, examples, live } = await makeSite();
  console.log(`packages/site/dist is built: ${pages} pages, ${live} of ${examples} examples are live`);
  if (process.argv.includes('--serve')) {
    const { url } = await startStaticServer({ root: join(folder, 'dist') });
    console.log(`${url}/index.html`);
  }
}
