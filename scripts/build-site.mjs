// `npm run site` builds the pages of docs as a static folder, packages/site/dist, and serves it; in packages/site `npm run build` builds only. The
// element and the studio have been built before.
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildSite } from '../packages/site/build/build.mjs';
import { projectRoot } from './shared-data.mjs';
import { startStaticServer } from './static-server.mjs';

const folder = join(projectRoot, 'packages/site');

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { pages, examples, live } = await buildSite({ root: projectRoot, folder, out: join(folder, 'dist') });
  console.log(`packages/site/dist is built: ${pages} pages, ${live} of ${examples} examples are live`);
  if (process.argv.includes('--serve')) {
    const { url } = await startStaticServer({ root: join(folder, 'dist') });
    console.log(`${url}/index.html`);
  }
}
