// The pictures of the guides in docs: pages as a reader sees them, photographed by make-images.mjs. Each has the markup that its guide explains.
import { join } from 'node:path';

/** @typedef {import('@playwright/test').Page} Page */
/**
 * @typedef {object} GuidePicture
 * @property {string} file - below docs/images, without its ending
 * @property {[number, number]} size - CSS pixels
 * @property {string} html - the body of the page
 * @property {string} [css]
 * @property {(page: Page) => Promise<void>} [act] - what a reader does before the photograph
 */

const data = '/demos/data';
const brain = `src="${data}/mni152-t1.nii.gz"`;
const head = `src="${data}/colin27-t1.nii.gz"`;
const torso = `src="${data}/ct-phantom.json"`;
const storm = `src="${data}/storm-radar-1510.json"`;
const upright = 'camera-target="0 0 0" camera-orbit="12deg 86deg 720"';
const skin = 'shading="lit" transfer-function="38 #5a3028 0, 52 #c08068 75%, 80 #e3b8a0 90%, 120 #fff2e6 95%"';
const open = 'transfer-function="20% #191512 0, 24% #4a3f38 50%, 100% #fff8ee 50%"';

/** Pictures with captions. @param {readonly [attributes: string, caption: string, children?: string][]} cells */
const figures = (cells) =>
  cells
    .map(
      ([attributes, caption, children = '']) =>
        `<figure><volume-view ${attributes}>${children}</volume-view><figcaption><code>${caption}</code></figcaption></figure>`,
    )
    .join('');
/** @param {number} columns @param {number} height - of each picture */
const grid = (columns, height) =>
  `body { display: grid; grid-template-columns: repeat(${columns}, minmax(0, 1fr)); gap: 10px } figure { margin: 0 } volume-view { inline-size: 100%; block-size: ${height}px; aspect-ratio: auto }`;

/** @type {readonly GuidePicture[]} */
export const guidePictures = [
  {
    file: 'guide-controls',
    size: [800, 500],
    html: `<volume-view ${head} ${skin} cutout="-120 -20 10 0 120 120" camera-target="0 -18 -14" camera-orbit="35deg 74deg 122%" controls></volume-view>`,
    css: 'volume-view { inline-size: 776px; block-size: 476px; aspect-ratio: auto }',
  },
  {
    file: 'guide-presets',
    size: [1000, 446],
    html: figures([
      [`${brain} camera-orbit="90deg 80deg 88%" transfer-function="mri"`, 'mri'],
      [`${brain} camera-orbit="90deg 80deg 88%" transfer-function="gray"`, 'gray'],
      [`${brain} camera-orbit="90deg 80deg 88%" transfer-function="viridis"`, 'viridis'],
      [
        `src="${data}/motor-synthetic.nii.gz" camera-orbit="90deg 80deg 88%" transfer-function="diverging"`,
        'diverging',
      ],
      [
        `${storm} rings="none" camera-target="-5000 0 9000" camera-orbit="200deg 60deg 66%" transfer-function="radar-dbz"`,
        'radar-dbz',
      ],
      ...['ct-bone', 'ct-soft-tissue', 'ct-angio', 'ct-lung'].map(
        (name) => /** @type {[string, string]} */ ([`${torso} ${upright} transfer-function="${name}"`, name]),
      ),
      [
        `src="${data}/storm-radar-1510-velocity.json" rings="none" camera-target="-5000 0 9000" camera-orbit="200deg 60deg 66%" transfer-function="radar-velocity"`,
        'radar-velocity',
      ],
    ]),
    css: grid(5, 185),
  },
  {
    file: 'guide-projection',
    size: [800, 690],
    html: figures([
      [`${torso} ${upright} transfer-function="ct-soft-tissue"`, 'no projection'],
      [`${torso} ${upright} transfer-function="gray" projection="max" value-window="0 700"`, 'projection="max"'],
      [
        `${torso} ${upright} transfer-function="gray" projection="min" value-window="-1000 100" region="-174 -15 -174 174 25 174"`,
        'projection="min"',
      ],
      [
        `${torso} ${upright} transfer-function="gray" projection="average" value-window="-700 -100"`,
        'projection="average"',
      ],
    ]),
    css: grid(2, 300),
  },
  {
    file: 'guide-slices',
    size: [800, 624],
    html: `<volume-slice-view for="v" type="axial" cursor="-22 -8 14"></volume-slice-view><volume-slice-view for="v" type="sagittal"></volume-slice-view>
      <volume-slice-view for="v" type="coronal"></volume-slice-view><volume-view id="v" ${head} ${skin} cutout="-120 -8 14 -22 120 120" camera-orbit="35deg 66deg 100%"></volume-view>`,
    css: 'body { display: grid; grid: 294px 294px / 1fr 1fr; gap: 12px } volume-view, volume-slice-view { inline-size: 100%; block-size: 100%; aspect-ratio: auto; margin: 0 }',
  },
  {
    file: 'guide-labels',
    size: [800, 480],
    html: `<volume-view id="v" ${brain} camera-orbit="125deg 70deg 84%"><volume-labels src="${data}/brodmann-2mm.nii.gz" table="${data}/brodmann-dseg.tsv"><volume-label value="48" hidden></volume-label></volume-labels></volume-view>
      <div><volume-label-list for="v"></volume-label-list><volume-readout for="v"></volume-readout></div>`,
    css: 'body { display: grid; grid: 456px / 460px 1fr; gap: 14px } volume-view { inline-size: 100%; block-size: 100%; aspect-ratio: auto } volume-label-list { block-size: 270px; margin: 0 }',
    act: async (page) => {
      await page.locator('volume-view').click({ position: { x: 150, y: 170 } });
      await page.mouse.move(790, 425);
    },
  },
  {
    file: 'guide-clip',
    size: [800, 320],
    html: `<volume-view id="one" ${brain} ${open} camera-orbit="60deg 65deg 76%"></volume-view><volume-view id="two" ${brain} ${open} camera-orbit="40deg 55deg 78%"></volume-view>
      <volume-clip for="one" type="plane" normal="1 0 0" at="-6"></volume-clip><volume-clip for="two" type="box" keep="outside" box="-100 0 10 0 110 110"></volume-clip>`,
    css: 'body { display: grid; grid: 296px / 1fr 1fr; gap: 12px } volume-view { inline-size: 100%; block-size: 100%; aspect-ratio: auto }',
  },
  {
    file: 'guide-measure',
    size: [800, 430],
    html: `<volume-view id="v" ${torso} transfer-function="ct-soft-tissue" camera-target="0 0 0" camera-orbit="12deg 76deg 720"></volume-view>
      <div><volume-measure for="v" label="Across the ribs" points="-147 2 47, 138 2 47"></volume-measure><volume-measure for="v" type="sphere" label="Inside the liver" color="#ffb02e" points="75 0 -45, 75 0 -15"></volume-measure></div>`,
    css: 'body { display: grid; grid: 406px / 1fr 300px; gap: 14px } volume-view { inline-size: 100%; block-size: 100%; aspect-ratio: auto }',
  },
  {
    file: 'guide-readout',
    size: [800, 352],
    html: `<volume-view id="v" ${torso} transfer-function="ct-soft-tissue" camera-target="0 0 30" camera-orbit="12deg 86deg 760"></volume-view><volume-readout for="v"></volume-readout>`,
    css: 'body { display: grid; grid: 326px / 470px 1fr; gap: 14px; align-items: center } volume-view { inline-size: 100%; block-size: 100%; aspect-ratio: auto }',
    act: async (page) => {
      await page.locator('volume-view').click({ position: { x: 252, y: 160 } });
      await page.mouse.move(790, 10);
    },
  },
  {
    file: 'guide-workspace',
    size: [1280, 756],
    html: `<volume-workspace><volume-view ${brain} camera-orbit="125deg 70deg 84%" alt="A brain"><volume-labels src="${data}/brodmann-2mm.nii.gz" table="${data}/brodmann-dseg.tsv"><volume-label value="48" hidden></volume-label></volume-labels></volume-view></volume-workspace>`,
    act: async (page) => {
      await page.locator('volume-view').click({ position: { x: 150, y: 150 } });
      await page.mouse.move(1275, 750);
    },
  },
  {
    file: 'guide-editor',
    size: [900, 436],
    html: `<div><volume-view id="v" ${storm} rings="none" camera-target="-5000 0 9000" camera-orbit="200deg 60deg 46%"></volume-view><volume-legend for="v" label="Reflectivity"></volume-legend></div><volume-transfer-function for="v"></volume-transfer-function>`,
    css: 'body { display: grid; grid-template-columns: 1fr 380px; gap: 14px } volume-view { inline-size: 100%; block-size: 310px; aspect-ratio: auto }',
  },
  {
    file: 'guide-radar',
    size: [800, 540],
    html: `<volume-view id="v" src="placed" vertical-exaggeration="4" camera-target="0 0 0" camera-orbit="180deg 42deg 84%" style="inline-size: 776px; block-size: 430px; aspect-ratio: auto"></volume-view><volume-legend for="v" label="Reflectivity"></volume-legend>`,
    // The synthetic storm is nowhere; to show the map it is given a place.
    act: async (page) => {
      await page.evaluate(async (url) => {
        const { image, ...manifest } = await (await fetch(url)).json();
        const placed = {
          ...manifest,
          image: new URL(image, new URL(url, location.href)).href,
          site: { name: 'Synthetic', latitude: 55.6, longitude: 11.6, height: 60 },
        };
        const file = new Blob([JSON.stringify(placed)], { type: 'application/json' });
        document.querySelector('volume-view')?.setAttribute('src', URL.createObjectURL(file));
      }, `${data}/storm-radar-1510.json`);
    },
  },
];

/**
 * A photograph of one, PNG in base64.
 * @param {Page} page - of the development server
 * @param {GuidePicture} picture
 */
export async function photographGuide(page, { size: [width, height], html, css = '', act }) {
  await page.setViewportSize({ width, height });
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.setContent(`<!doctype html><html lang="en"><title>Guide</title><script type="module" src="/src/index.ts"></script>
    <style>body { margin: 12px; font: 14px/1.4 system-ui, sans-serif; background: #fff; color: #1c2330 } volume-view { border-radius: 6px }
      figcaption { padding-block: 2px 4px } code { font: 12px ui-monospace, monospace } ${css}</style>${html}`);
  const names = [...new Set(html.match(/(?<=<)volume-[\w-]+/g))];
  await page.evaluate(
    (all) => Promise.all(all.map((name) => customElements.whenDefined(name))).then(() => undefined),
    names,
  );
  const settle = () =>
    page.evaluate(async () => {
      const elements = /** @type {(Element & { whenRendered(): Promise<unknown> })[]} */ ([
        ...document.querySelectorAll('volume-view, volume-slice-view'),
      ]);
      for (const element of elements) await element.whenRendered();
    });
  if (!html.includes('src="placed"')) await settle();
  await act?.(page);
  // What follows a picture: names, measures, the map.
  await page.waitForTimeout(1500);
  await settle();
  await page.waitForTimeout(500);
  return (await page.screenshot()).toString('base64');
}

/**
 * A photograph of the gallery of an archive, which make-images.mjs does not make itself, as it takes minutes. It has copies of the scans of
 * demos/data that are one volume and no labels: `volume-view-archive SCANS --out FOLDER`, then `VOLUME_VIEW_ARCHIVE=FOLDER node docs/images/make-images.mjs guide-archive`.
 * @param {Page} page - of the development server
 * @param {string} folder
 */
export async function photographArchive(page, folder) {
  await page.setViewportSize({ width: 1000, height: 770 });
  await page.route('**/archive/**', (route) => {
    const path = new URL(route.request().url()).pathname.replace('/archive/', '');
    return route.fulfill({ path: join(folder, path) });
  });
  await page.goto(new URL('/archive/index.html', page.url()).href);
  await page.getByRole('listitem').first().waitFor();
  await page.waitForLoadState('networkidle');
  return (await page.screenshot()).toString('base64');
}
