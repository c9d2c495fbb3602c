// Finds the Chromium for the tests, and its switches.
import { execFileSync, spawnSync } from 'node:child_process';
import { accessSync, constants, existsSync, readFileSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { pathToFileURL } from 'node:url';

const NAMES = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable', 'chrome', 'msedge'];

/** The usual places of Chrome when it is not on the PATH. */
function listUsualPlaces() {
  if (process.platform === 'darwin') {
    const apps = ['Google Chrome', 'Chromium', 'Microsoft Edge'];
    return apps.map((app) => `/Applications/${app}.app/Contents/MacOS/${app}`);
  }
  if (process.platform === 'win32') {
    const roots = [process.env.PROGRAMFILES, process.env['PROGRAMFILES(X86)'], process.env.LOCALAPPDATA];
    const tails = ['Google\\Chrome\\Application\\chrome.exe', 'Microsoft\\Edge\\Application\\msedge.exe'];
    return roots.flatMap((root) => (root ? tails.map((tail) => join(root, tail)) : []));
  }
  return ['/usr/bin', '/usr/local/bin', '/snap/bin', '/opt/google/chrome'].flatMap((folder) =>
    NAMES.map((name) => join(folder, name)),
  );
}

/** @param {string} path */
function isExecutable(path) {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

/**
 * The path of a program on the PATH, else null.
 * @param {string} name
 */
export function findOnPath(name) {
  const suffix = process.platform === 'win32' ? '.exe' : '';
  const folders = (process.env.PATH ?? '').split(delimiter).filter(Boolean);
  return folders.map((folder) => join(folder, name + suffix)).find(isExecutable) ?? null;
}

async function findPlaywrightChromium() {
  const { chromium } = await import('@playwright/test');
  try {
    const path = chromium.executablePath();
    return existsSync(path) ? path : null;
  } catch {
    return null; // Playwright has no build for this system.
  }
}

function findSystemBrowser() {
  const named = process.env.CHROME_PATH;
  if (named) {
    if (isExecutable(named)) return named;
    throw new Error(`CHROME_PATH got ${named}; expected the path of an executable Chrome or Chromium`);
  }
  return NAMES.map(findOnPath).find(Boolean) ?? listUsualPlaces().find(isExecutable) ?? null;
}

/** True where this process may install Debian packages. */
export function canInstallPackages() {
  if (process.platform !== 'linux' || process.getuid?.() !== 0 || !findOnPath('apt-get')) return false;
  const release = existsSync('/etc/os-release') ? readFileSync('/etc/os-release', 'utf8') : '';
  return /^ID(_LIKE)?=.*\b(debian|ubuntu)\b/m.test(release);
}

/**
 * Install Debian packages without asking; progress goes to stderr.
 * @param {string[]} packages
 * @returns {boolean} whether it worked
 */
export function installPackages(packages) {
  process.stderr.write(`Installing ${packages.join(', ')} with apt-get ...\n`);
  const env = { ...process.env, DEBIAN_FRONTEND: 'noninteractive' };
  /** @param {string[]} args */
  const apt = (args) => spawnSync('apt-get', args, { env, stdio: ['ignore', 'ignore', 'inherit'] }).status === 0;
  apt(['update', '-q']); // This may fail in part (one dead mirror), and the install still works.
  return apt(['install', '-y', '-q', '--no-install-recommends', ...packages]);
}

/**
 * The path of a Chromium or Chrome, which is installed if it is missing and can be installed.
 * @returns {Promise<string>}
 * @throws with the one command to run
 */
export async function findBrowser() {
  const found = process.env.CHROME_PATH
    ? findSystemBrowser()
    : ((await findPlaywrightChromium()) ?? findSystemBrowser());
  if (found) return found;
  // Ubuntu's `chromium` package is a stub that needs snap, so search again: success of apt is not enough.
  const installed = canInstallPackages() && installPackages(['chromium']) ? findSystemBrowser() : null;
  if (installed) return installed;
  throw new Error('No Chrome or Chromium was found. Run: npx playwright install --with-deps chromium');
}

/**
 * Features of Chromium that we disable. Each window would load the suggestions of its invisible address bar, twice, in a process of its
 * own: more than half of the work of opening a page. A process for the next page, which is started with each page and ends with it unused,
 * takes as much as the one that shows an empty page. This switch replaces the one of Playwright, so the list repeats Playwright's features.
 */
const disabledFeatures = [
  ...['WebUIOmniboxPopup', 'WebUIOmniboxAimPopup', 'SpareRendererForSitePerProcess'],
  ...[
    'AvoidUnnecessaryBeforeUnloadCheckSync',
    'DestroyProfileOnBrowserClose',
    'PaintHolding',
    'ThirdPartyStoragePartitioning',
  ],
  ...[
    'HttpsUpgrades',
    'HttpsFirstBalancedModeAutoEnable',
    'AvoidCorsURLLoaderRestartOnRedirect',
    'TcpPortRandomizationWin',
    'PreconnectToSearch',
  ],
  ...['LensOverlay', 'MediaRouter', 'OptimizationHints', 'NetworkTimeServiceQuerying', 'AimEnabled'],
];

/** Switches for every browser that we start: WebGL in software (or on the GPU), and no connections to services of the browser. */
export function listLaunchArgs() {
  // ANGLE would also compile each program for the CPU when it is linked, though most programs are never used for drawing.
  const noWarmUp = '--disable-angle-features=warmUpPipelineCacheAtLink';
  // A program that one context has compiled is used again by the next context.
  const oneCache = '--enable-angle-features=preferGlobalPipelineCache';
  const gl =
    process.env.VOLUME_VIEW_GPU === '1'
      ? ['--use-angle=vulkan', '--enable-features=Vulkan', '--ignore-gpu-blocklist']
      : ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', noWarmUp, oneCache];
  const quiet = [
    '--disable-background-networking',
    '--disable-component-update',
    '--disable-sync',
    '--no-first-run',
    '--disable-quic',
    `--disable-features=${disabledFeatures.join(',')}`,
  ];
  const root = process.getuid?.() === 0 ? ['--no-sandbox'] : [];
  return [...gl, ...quiet, ...root];
}

/**
 * Switches for the browsers of the tests: pages are composed without GL. With software rendering this saves a fifth of the work of opening
 * a page; WebGL itself does not change. Benchmarks do not use it, so that they measure what visitors get.
 */
export function listTestArgs() {
  return process.env.VOLUME_VIEW_GPU === '1' ? listLaunchArgs() : [...listLaunchArgs(), '--disable-gpu-compositing'];
}

// `node scripts/find-browser.mjs` prints the browser that would be used.
if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  const path = await findBrowser();
  console.log(`${path}\n${execFileSync(path, ['--version', ...listLaunchArgs()], { encoding: 'utf8' }).trim()}`);
}
