// Profiles by CDP: one for each file.
import base from './zz.config.mjs';
import { writeFileSync } from 'node:fs';
import { findBrowser, listTestArgs } from './scripts/find-browser.mjs';
import { playwrightLauncher } from '@web/test-runner-playwright';
let n = 0;
const launcher = playwrightLauncher({
  product: 'chromium',
  launchOptions: { executablePath: await findBrowser(), args: listTestArgs() },
  createBrowserContext: async ({ browser }) => browser.newContext(),
  createPage: async ({ context }) => {
    const page = await context.newPage();
    const cdp = await context.newCDPSession(page);
    await cdp.send('Profiler.enable');
    await cdp.send('Profiler.setSamplingInterval', { interval: 1000 });
    await cdp.send('Profiler.start');
    const close = context.close.bind(context);
    const g = page.goto.bind(page);
    page.goto = async (url, ...more) => {
      if (url === 'about:blank') { try { const { profile } = await cdp.send('Profiler.stop'); writeFileSync(`${process.env.PROFDIR}/${n++}.cpuprofile`, JSON.stringify(profile)); } catch (e) { console.log('prof', e.message); } }
      return g(url, ...more);
    };
    return page;
  },
});
export default { ...base, browsers: [launcher] };
