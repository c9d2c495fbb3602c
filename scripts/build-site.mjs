// `npm run site` builds the pages of docs as a static folder, packages/site/dist, and serves it; in packages/site `npm run build` builds only. The
// element and the studio have been built before. `npm start` shows the same pages, with the demos: scripts/site-plugin.mjs.
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildSite } from '../packages/site/build/build.mjs';
import { projectRoot } from './shared-data.mjs';
import { startStaticServer } from './static-server.mjs';

const folder = join(projectRoot, 'packages/site');
export const siteFolder = join(folder, 'dist');

export const buildSiteFolder = () => buildSite({ root: projectRoot, folder, out: siteFolder });

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { pages, examples, live } = await buildSiteFolder();
  console.log(`packages/site/dist is built: ${pages} pages, ${live} of ${examples} examples are live`);
  if (process.argv.includes('--serve')) {
    const { url } = await startStaticServer({ root: siteFolder });
    console.log(`${url}/index.html`);
  }
}
