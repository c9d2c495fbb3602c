// The pictures of the demo gallery (demos/images) and of the docs (docs/images), made by the element itself:
// node docs/images/make-images.mjs [name ...].
import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { chromium } from '@playwright/test';
import { createServer } from 'vite';
import { findBrowser, listLaunchArgs } from '../../scripts/find-browser.mjs';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { guidePictures, photographArchive, photographGuide } from './guide-pictures.mjs';

/** @typedef {{ attributes: Record<string, string>, children?: string, background?: string }} Part - drawn side by side */
/** @typedef {{ file: string, size: [number, number], columns?: number, parts: Part[] }} Picture */

const mri = { src: '/demos/data/mni152-t1.nii.gz' };
const head = {
  src: '/demos/data/colin27-t1.nii.gz',
  shading: 'lit',
  cutout: '-120 -20 10 0 120 120',
  'transfer-function': '38 #5a3028 0, 52 #c08068 75%, 80 #e3b8a0 90%, 120 #fff2e6 95%',
};
const torso = { src: '/demos/data/ct-phantom.json' };
const upright = { ...torso, 'camera-target': '0 0 0', 'camera-orbit': '12deg 86deg 720' };
const grayUpright = { ...upright, 'transfer-function': 'gray' };
const island = { src: '/demos/data/storm-radar-island.json', rings: 'none' };
const terrain = `<volume-terrain src="${['N00E000', 'N00W001', 'S01E000', 'S01W001'].map((name) => `/demos/data/island/${name}.hgt.gz`).join(' ')}"></volume-terrain>`;
const storm = { src: '/demos/data/storm-synthetic.json' };
const probe = `
  <transform translation="-26 -20 -14">
    <shape><appearance><material diffusecolor="1 0.5 0.1" emissivecolor="0.25 0.1 0"></material></appearance><sphere radius="6"></sphere></shape>
    <transform rotation="1 0 0 1.5708" translation="0 0 65"><shape><appearance><material diffusecolor="0.2 0.85 0.5" emissivecolor="0.03 0.12 0.06"></material></appearance><cylinder radius="1.5" height="130"></cylinder></shape></transform>
  </transform>`;

/** @type {(name: string, parts: Part[], columns?: number) => Picture} */
const card = (name, parts, columns) => ({ file: `demos/images/${name}.webp`, size: [640, 480], columns, parts });
/** @type {(name: string, attributes: Record<string, string>) => Picture} */
const swatch = (name, attributes) => ({
  file: `demos/images/preset-${name}.webp`,
  size: [240, 180],
  parts: [{ attributes: { ...attributes, 'transfer-function': name } }],
});

const brain = {
  ...mri,
  'transfer-function': '0% #d8a48f 0, 33% #d8a48f 0, 40% #e2b9a6 60%, 100% #f4e4d8 90%',
  'camera-orbit': '65deg 75deg 82%',
};
const body = { ...torso, 'transfer-function': 'ct-soft-tissue', 'camera-orbit': '25deg 80deg 100%' };
const lamp =
  '<directionallight direction="-0.3 -0.9 -0.5"></directionallight><navigationinfo headlight="false"></navigationinfo>';
const styleTiles = [
  { attributes: body },
  {
    attributes: body,
    children:
      '<BoundaryEnhancementVolumeStyle retainedOpacity="0" boundaryOpacity="4" opacityFactor="1"></BoundaryEnhancementVolumeStyle>',
  },
  {
    attributes: body,
    children:
      '<SilhouetteEnhancementVolumeStyle silhouetteRetainedOpacity="0.02" silhouetteBoundaryOpacity="1" silhouetteSharpness="2"></SilhouetteEnhancementVolumeStyle>',
  },
  {
    attributes: brain,
    children:
      '<EdgeEnhancementVolumeStyle gradientThreshold="1.15" edgeColor="0.1 0.05 0.05"></EdgeEnhancementVolumeStyle>',
  },
  {
    attributes: brain,
    children: `<ToneMappedVolumeStyle coolColor="0.12 0.2 0.55" warmColor="1 0.82 0.55"></ToneMappedVolumeStyle>${lamp}`,
  },
  {
    attributes: brain,
    children:
      '<CartoonVolumeStyle parallelColor="1 0.87 0.7" orthogonalColor="0.35 0.1 0.2" colorSteps="4"></CartoonVolumeStyle>',
  },
  {
    attributes: brain,
    children: `<ShadedVolumeStyle lighting="true"><Material diffuseColor="1 0.95 0.9" specularColor="0.25 0.25 0.25" shininess="0.3" ambientIntensity="0.25"></Material></ShadedVolumeStyle>${lamp}`,
  },
  {
    attributes: brain,
    children:
      '<ShadedVolumeStyle lighting="true"></ShadedVolumeStyle><BlendedVolumeStyle weightConstant1="0.67" weightConstant2="0.33"><CartoonVolumeStyle colorSteps="3" parallelColor="0.4 0.9 1" orthogonalColor="0 0.1 0.4"></CartoonVolumeStyle></BlendedVolumeStyle>',
  },
];

/** @type {Picture[]} */
const pictures = [
  {
    file: 'docs/images/ambient-occlusion.webp',
    size: [1080, 720],
    columns: 3,
    parts: ['lit', 'ambient-occlusion'].flatMap((shading) => [
      { attributes: { ...mri, look: 'textbook', shading, 'camera-orbit': '125deg 70deg 92%' } },
      { attributes: { ...head, shading, 'camera-orbit': '35deg 66deg 92%' } },
      { attributes: { ...torso, look: 'textbook', shading, 'camera-orbit': '25deg 80deg 105%' } },
    ]),
  },
  { file: 'docs/images/x3d-styles.webp', size: [1280, 640], columns: 4, parts: styleTiles },
  {
    file: 'docs/images/volume-view.webp',
    size: [1600, 600],
    columns: 3,
    parts: [
      { attributes: { ...head, 'camera-orbit': '35deg 66deg 92%' } },
      { attributes: { ...torso, 'transfer-function': 'ct-soft-tissue', 'camera-orbit': '25deg 80deg 112%' } },
      {
        attributes: { ...island, 'vertical-exaggeration': '5', 'camera-orbit': '-30deg 62deg 52%' },
        children: terrain,
      },
    ],
  },
  card('one-tag', [{ attributes: { ...mri, 'camera-orbit': '30deg 75deg 78%' } }]),
  card(
    'mosaic',
    [
      { attributes: { ...mri, 'camera-orbit': '60deg 75deg 88%' } },
      { attributes: { src: '/demos/data/mni152-t1.json', 'camera-orbit': '60deg 75deg 88%' } },
    ],
    2,
  ),
  card(
    'presets',
    ['viridis', 'inferno', 'cividis', 'turbo'].map((name) => ({
      attributes: { ...mri, 'transfer-function': name, 'camera-orbit': '90deg 80deg 82%' },
    })),
    2,
  ),
  card('pictures', [{ attributes: { src: '/demos/data/torso-radiograph.dcm' } }]),
  card('transfer-function', [
    {
      attributes: {
        ...mri,
        'camera-orbit': '40deg 75deg 78%',
        'transfer-function':
          '0% hsl(210 60% 60%) 0, 20% hsl(210 60% 60%) 1.5%, 40% hsl(260 50% 70%) 0.4%, 75% gold 0.3%, 90% orange 4%, 100% white 8%',
      },
    },
  ]),
  card(
    'projection',
    [
      { attributes: { ...upright, 'transfer-function': 'ct-soft-tissue' } },
      { attributes: { ...grayUpright, projection: 'max', 'value-window': '0 700' } },
      {
        attributes: {
          ...grayUpright,
          projection: 'min',
          'value-window': '-1000 100',
          region: '-174 -15 -174 174 25 174',
        },
      },
      { attributes: { ...grayUpright, projection: 'average', 'value-window': '-700 -100' } },
    ],
    2,
  ),
  card(
    'lit',
    [
      { attributes: { ...head, 'camera-orbit': '35deg 66deg 92%' } },
      {
        attributes: {
          ...torso,
          shading: 'lit',
          'transfer-function': '150 #d9b88a 0, 250 #e6cfa5 50%, 700 #fff6e5 90%',
          'camera-orbit': '25deg 80deg 105%',
        },
      },
    ],
    2,
  ),
  card('styles', [styleTiles[3], styleTiles[4], styleTiles[5], styleTiles[2]], 2),
  card(
    'iso-surfaces',
    [
      {
        attributes: { ...torso, 'surface-values': '-300 #d9a98c 25%, 250 #f3e6cc', 'camera-orbit': '25deg 80deg 105%' },
      },
      { attributes: { ...mri, 'surface-values': '35% #d8a48f 30%, 72% #fff4e0', 'camera-orbit': '120deg 65deg 80%' } },
    ],
    2,
  ),
  card('cut', [
    {
      attributes: {
        ...mri,
        'transfer-function': '20% #191512 0, 24% #4a3f38 50%, 100% #fff8ee 50%',
        cutout: '-100 0 10 0 110 110',
        'camera-orbit': '40deg 55deg 78%',
      },
    },
  ]),
  card(
    'surfaces',
    [
      {
        attributes: {
          ...mri,
          'transfer-function': '20% #191512 0, 24% #4a3f38 50%, 100% #fff8ee 50%',
          cutout: '-100 -120 0 0 110 110',
          'camera-orbit': '50deg 62deg 82%',
        },
        children: '<volume-surface src="/demos/data/mni152-white.surf.gii"></volume-surface>',
      },
      {
        attributes: { ...island, 'vertical-exaggeration': '5', 'camera-orbit': '-30deg 62deg 36%' },
        children: terrain,
      },
    ],
    2,
  ),
  card('labels', [
    {
      attributes: { ...mri, 'camera-orbit': '125deg 70deg 92%' },
      children:
        '<volume-labels src="/demos/data/brodmann-2mm.nii.gz" table="/demos/data/brodmann-dseg.tsv"><volume-label value="48" hidden></volume-label></volume-labels>',
    },
  ]),
  card(
    'layers',
    [
      {
        attributes: {
          ...mri,
          'transfer-function': 'gray',
          shading: 'lit',
          'opacity-factor': '0.6',
          'camera-orbit': '235deg 45deg 90%',
        },
        children: '<volume-layer src="/demos/data/motor-synthetic.nii.gz" opacity-factor="2"></volume-layer>',
      },
      {
        attributes: {
          ...island,
          'vertical-exaggeration': '4',
          'opacity-factor': '1.5',
          'camera-target': '0 0 6000',
          'camera-orbit': '150deg 66deg 45%',
        },
        children: `<volume-layer src="/demos/data/storm-radar-1500-unfolded.json" blend="color"></volume-layer>${terrain}`,
      },
    ],
    2,
  ),
  card('microscopy', [{ attributes: { src: '/demos/data/cells-synthetic.ozx', 'camera-orbit': '25deg 38deg 58%' } }]),
  card('radar', [
    {
      attributes: {
        src: '/demos/data/storm-radar-1510.json',
        'vertical-exaggeration': '4',
        'camera-target': '-5000 0 9000',
        'camera-orbit': '200deg 60deg 50%',
        rings: '50',
      },
      children: '<volume-slice type="ppi"></volume-slice>',
    },
  ]),
  card(
    'camera',
    [
      ...['0deg 90deg 85%', '90deg 90deg 85%', '0deg 0deg 85%'].map((orbit) => ({
        attributes: { ...mri, 'camera-orbit': orbit },
      })),
      {
        attributes: { ...torso, 'transfer-function': 'ct-lung' },
        children:
          '<viewpoint position="90 0 20" orientation="0.6425 0.6425 0.4176 2.3505" fieldofview="0.8"></viewpoint>',
      },
    ],
    2,
  ),
  card('shapes', [
    {
      attributes: { ...mri, 'transfer-function': 'gray', 'opacity-factor': '0.25', 'camera-orbit': '55deg 70deg 85%' },
      children: probe,
    },
  ]),
  card(
    'steps',
    [20, 200].map((steps) => ({ attributes: { ...mri, steps: String(steps), 'camera-orbit': '30deg 70deg 70%' } })),
    2,
  ),
  card('css', [{ attributes: { ...mri, 'camera-orbit': '-40deg 75deg 80%' }, background: 'white' }]),
  card(
    'many',
    [
      { attributes: { ...torso, 'transfer-function': 'ct-bone', 'camera-orbit': '30deg 80deg 110%' } },
      { attributes: { ...mri, 'camera-orbit': '0deg 20deg 90%' } },
      { attributes: { ...storm, 'camera-orbit': '30deg 55deg 85%' } },
      { attributes: { ...torso, 'transfer-function': 'ct-lung', 'camera-orbit': '0deg 85deg 110%' } },
    ],
    2,
  ),
  card('no-bundler', [
    { attributes: { ...torso, 'transfer-function': 'ct-soft-tissue', 'camera-orbit': '25deg 80deg 108%' } },
  ]),
  ...['mri', 'gray', 'viridis', 'inferno', 'magma', 'plasma', 'cividis', 'turbo'].map((name) =>
    swatch(name, { ...mri, 'camera-orbit': '60deg 78deg 80%' }),
  ),
  ...['ct-bone', 'ct-soft-tissue', 'ct-angio', 'ct-lung'].map((name) =>
    swatch(name, { ...torso, 'camera-orbit': '25deg 80deg 100%' }),
  ),
  swatch('radar-dbz', { ...storm, 'camera-orbit': '30deg 55deg 75%' }),
];

/**
 * In the page: draw the parts with the element, side by side over a background.
 * @param {Picture} picture
 * @returns {Promise<string>} a data: URL
 */
async function paint({ size: [width, height], columns = 1, parts }) {
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  const [w, h] = [width / columns, height / Math.ceil(parts.length / columns)];
  for (const [i, { attributes, children = '', background }] of parts.entries()) {
    const view = document.createElement('volume-view');
    Object.assign(view.style, { position: 'absolute', width: `${w}px`, height: `${h}px` });
    view.innerHTML = children;
    for (const [name, value] of Object.entries(attributes)) view.setAttribute(name, value);
    document.body.append(view);
    const [x, y] = [(i % columns) * w, Math.floor(i / columns) * h];
    const shade = context.createRadialGradient(
      x + w / 2,
      y + h * 0.45,
      0,
      x + w / 2,
      y + h * 0.45,
      Math.hypot(w, h) * 0.42,
    );
    shade.addColorStop(0, background ?? '#262d3a');
    shade.addColorStop(1, background ?? '#0d1016');
    context.fillStyle = shade;
    context.fillRect(x, y, w, h);
    context.drawImage(await createImageBitmap(await view.toBlob({ width: w, height: h })), x, y);
    view.remove();
  }
  return canvas.toDataURL('image/webp', 0.92);
}

/** The card of the paper's page shows what a mosaic is, on our own: the aorta may not be copied, nor pictures of it. */
async function paintMosaic() {
  const image = new Image();
  image.src = '/demos/data/mni152-t1.png';
  await image.decode();
  const canvas = Object.assign(document.createElement('canvas'), { width: 640, height: 480 });
  canvas.getContext('2d')?.drawImage(image, 788, 1165, 1242, 932, 0, 0, 640, 480);
  return canvas.toDataURL('image/webp', 0.8);
}

/**
 * The card of the companions' page: a volume with the editor and the legend as they stand in a page.
 * @param {import('@playwright/test').Page} page
 */
async function photographCompanions(page) {
  await page.setViewportSize({ width: 640, height: 480 });
  await page.setContent(`<!doctype html><title>Companions</title><script type="module" src="/src/index.ts"></script>
    <style>body { margin: 0; display: grid; grid: minmax(0, 1fr) auto / minmax(0, 1fr) 300px; gap: 14px; padding: 16px; box-sizing: border-box; height: 480px;
      background: #0f1217; color: #e6eaf0; color-scheme: dark } volume-view { width: 100%; height: 100%; aspect-ratio: auto; border-radius: 8px }
      ::part(factors), ::part(toolbar) { display: none }</style>
    <volume-view src="${storm.src}" camera-orbit="30deg 55deg 78%"></volume-view>
    <volume-transfer-function style="--volume-chart-height: 13rem"></volume-transfer-function>
    <volume-legend label="Reflectivity" style="grid-column: 1 / 3"></volume-legend>`);
  await page.evaluate(() =>
    Promise.all(
      ['volume-view', 'volume-transfer-function', 'volume-legend'].map((name) => customElements.whenDefined(name)),
    ).then(() => undefined),
  );
  await page.evaluate(() => document.querySelector('volume-view')?.whenRendered());
  return (await page.screenshot()).toString('base64');
}

/**
 * The card of the page with readouts: a torso somebody points at.
 * @param {import('@playwright/test').Page} page
 */
async function photographPointing(page) {
  await page.setViewportSize({ width: 640, height: 480 });
  await page.setContent(`<!doctype html><title>Pointing</title><script type="module" src="/src/index.ts"></script>
    <style>body { margin: 0; display: grid; grid: 480px / 330px 1fr; align-items: center; gap: 20px; background: #0f1217; color: #e6eaf0;
      color-scheme: dark } volume-view { width: 100%; height: 100%; aspect-ratio: auto } volume-readout { font-size: 17px } ::part(button), ::part(hint) { display: none }</style>
    <volume-view src="${torso.src}" transfer-function="ct-soft-tissue" camera-target="0 0 30" camera-orbit="12deg 86deg 760"></volume-view>
    <volume-readout></volume-readout>`);
  await page.evaluate(() =>
    Promise.all(['volume-view', 'volume-readout'].map((name) => customElements.whenDefined(name))).then(
      () => undefined,
    ),
  );
  await page.evaluate(() => document.querySelector('volume-view')?.whenRendered());
  await page.mouse.click(178, 235);
  await page.mouse.move(620, 20);
  await page.waitForTimeout(800);
  return (await page.screenshot()).toString('base64');
}

/** The stone of its page, once all bricks of the view have come. @param {import('@playwright/test').Page} page */
async function photographLarge(page) {
  await page.goto(`${server.resolvedUrls?.local[0]}demos/large.html`);
  await page.addStyleTag({ content: '#stone { inline-size: 640px !important; aspect-ratio: 4 / 3 }' });
  await page.evaluate(async () => {
    const view = /** @type {import('../../src/index.ts').VolumeView} */ (document.querySelector('#stone'));
    view.controls = false;
    await view.whenRendered();
  });
  return (await page.locator('#stone').screenshot()).toString('base64');
}

/**
 * The card of the page with values over time: a brain with a cross, and the curve below it.
 * @param {import('@playwright/test').Page} page
 */
async function photographOverTime(page) {
  await page.setViewportSize({ width: 640, height: 480 });
  await page.setContent(`<!doctype html><title>Over time</title><script type="module" src="/src/index.ts"></script>
    <style>body { margin: 0; background: #0f1217; color: #e6eaf0; color-scheme: dark } volume-view { width: 640px; height: 270px; aspect-ratio: auto }
      volume-readout { font-size: 17px; margin: 12px 24px } ::part(button), ::part(hint), ::part(row), ::part(curve-table), ::part(refining) { display: none }</style>
    <volume-view src="/demos/data/functional.nii" value-window="1500 6500" camera-orbit="0deg 32deg 100"></volume-view>
    <volume-readout curve></volume-readout>`);
  await page.evaluate(() =>
    Promise.all(['volume-view', 'volume-readout'].map((name) => customElements.whenDefined(name))).then(
      () => undefined,
    ),
  );
  await page.evaluate(() => document.querySelector('volume-view')?.whenRendered());
  await page.mouse.click(330, 150);
  await page.mouse.move(620, 470);
  await page.locator('volume-readout [part=curve-plot]').waitFor();
  await page.evaluate(() => document.querySelector('volume-view')?.showScan(11));
  await page.waitForTimeout(3000);
  return (await page.screenshot()).toString('base64');
}

/**
 * The card of the page with measures: a torso with a distance and a sphere.
 * @param {import('@playwright/test').Page} page
 */
async function photographMeasure(page) {
  await page.setViewportSize({ width: 640, height: 480 });
  await page.setContent(`<!doctype html><title>Measuring</title><script type="module" src="/src/index.ts"></script>
    <style>body { margin: 0; background: #0f1217 } volume-view { width: 640px; height: 480px } div { visibility: hidden }</style>
    <volume-view src="${torso.src}" transfer-function="ct-soft-tissue" camera-target="0 0 30" camera-orbit="12deg 76deg 760"></volume-view>
    <div><volume-measure label="Ribs" points="-147 2 47, 138 2 47"></volume-measure><volume-measure type="sphere" label="Liver" color="#ffb02e" points="75 0 -45, 75 0 -5"></volume-measure></div>`);
  await page.evaluate(() =>
    Promise.all(['volume-view', 'volume-measure'].map((name) => customElements.whenDefined(name))).then(
      () => undefined,
    ),
  );
  await page.evaluate(() => document.querySelector('volume-view')?.whenRendered());
  await page.waitForTimeout(800);
  await page.evaluate(() => document.querySelector('volume-view')?.whenRendered());
  return (await page.screenshot()).toString('base64');
}

/**
 * The card of the page with notes: the middle of a brain with names.
 * @param {import('@playwright/test').Page} page
 */
async function photographNotes(page) {
  await page.setViewportSize({ width: 640, height: 480 });
  const notes = [
    ['0.5 -6 25', 'Corpus callosum'],
    ['1.5 -17 8', 'Thalamus'],
    ['0.5 -27 -34', 'Pons'],
    ['1 -63 -24', 'Cerebellum'],
    ['2 -84 6', 'Visual cortex'],
  ].map(([position, label]) => `<volume-note position="${position}" label="${label}"></volume-note>`);
  await page.setContent(`<!doctype html><title>Notes</title><script type="module" src="/src/index.ts"></script>
    <style>body { margin: 0; background: #0f1217 } volume-view { width: 640px; height: 480px } ::part(note) { font-size: 16px }</style>
    <volume-view src="${mri.src}" region="0 -120 -80 90 90 100" transfer-function="20% #191512 0, 24% #4a3f38 50%, 100% #fff8ee 50%" camera-orbit="82deg 84deg 92%">${notes.join('')}</volume-view>`);
  await page.evaluate(() =>
    Promise.all(['volume-view', 'volume-note'].map((name) => customElements.whenDefined(name))).then(() => undefined),
  );
  await page.evaluate(() => document.querySelector('volume-view')?.whenRendered());
  await page.waitForTimeout(1500);
  return (await page.screenshot()).toString('base64');
}

/**
 * The card of the page with a tour: the third of five steps, with its text below the picture.
 * @param {import('@playwright/test').Page} page
 */
async function photographTour(page) {
  await page.setViewportSize({ width: 640, height: 480 });
  const empty = '<volume-step><h2>x</h2></volume-step>';
  await page.setContent(`<!doctype html><title>Tour</title><script type="module" src="/src/index.ts"></script>
    <style>body { margin: 0; background: #0f1217; color: #e8edf4; font: 22px/1.4 system-ui, sans-serif } volume-view { width: 640px; height: 326px } ::part(note) { font-size: 16px } volume-tour { margin: 12px 24px } h2 { margin: 0; font-size: 30px }</style>
    <volume-view id="brain" src="${mri.src}" transfer-function="20% #191512 0, 24% #4a3f38 50%, 100% #fff8ee 50%"><volume-note id="callosum" position="0.5 -6 25" label="Corpus callosum"></volume-note></volume-view>
    <volume-tour for="brain" step="3">${empty.repeat(2)}<volume-step camera-orbit="82deg 84deg 92%" region="0 -120 -80 90 90 100"><h2>What joins the halves</h2></volume-step>${empty.repeat(2)}</volume-tour>`);
  await page.evaluate(() =>
    Promise.all(['volume-view', 'volume-note', 'volume-tour'].map((name) => customElements.whenDefined(name))).then(
      () => undefined,
    ),
  );
  await page.evaluate(() => document.querySelector('volume-view')?.whenRendered());
  await page.waitForTimeout(1500);
  return (await page.screenshot()).toString('base64');
}

/**
 * The card of the lesson on a storm: its second step, with a question below the picture.
 * @param {import('@playwright/test').Page} page
 */
async function photographStormLesson(page) {
  await page.setViewportSize({ width: 640, height: 480 });
  await page.setContent(`<!doctype html><title>Lesson</title><script type="module" src="/src/index.ts"></script>
    <style>body { margin: 0; background: #0f1217; color: #e8edf4; font: 20px/1.4 system-ui, sans-serif; color-scheme: dark } volume-view { width: 640px; height: 300px } ::part(note) { font-size: 16px } volume-question { margin: 12px 24px } ul { list-style: none } h2 { margin: 0; font-size: 26px } ::part(answers) { grid-template-columns: 1fr 1fr; }</style>
    <volume-view id="storm" src="/demos/data/storm-radar.json" vertical-exaggeration="3" camera-target="-20000 -50000 6000" camera-orbit="190deg 62deg 26%" rings="none"><volume-note position="-36000 -58000 5000" label="Hail core"></volume-note></volume-view>
    <volume-question for="storm"><h2>What does a red echo mean?</h2><ul><li>Warm air</li><li correct>Heavy rain, or hail</li></ul></volume-question>`);
  await page.evaluate(() =>
    Promise.all(['volume-view', 'volume-note', 'volume-question'].map((name) => customElements.whenDefined(name))).then(
      () => undefined,
    ),
  );
  await page.evaluate(() => document.querySelector('volume-view')?.whenRendered());
  await page.waitForTimeout(1500);
  return (await page.screenshot()).toString('base64');
}

/**
 * A step of a lesson: its picture on paper, or the card of its page.
 * @param {import('@playwright/test').Page} page
 * @param {string} lesson - name of its page
 * @param {number} step - from 1
 * @param {'print' | 'card'} use - on white, or on the dark ground of the cards
 */
async function photographStep(page, lesson, step, use) {
  await page.setViewportSize(use === 'card' ? { width: 640, height: 480 } : { width: 480, height: 360 });
  await page.goto(new URL(`/demos/${lesson}.html`, page.url()).href);
  const ground = use === 'card' ? '#0f1217' : '#fff';
  await page.addStyleTag({
    content: `body { margin: 0 } volume-view { position: fixed !important; inset: 0 !important; z-index: 9 !important; inline-size: 100vw !important; block-size: 100vh !important; max-block-size: none !important; border-radius: 0 !important; background: ${ground} !important }`,
  });
  await page.evaluate(
    (to) =>
      customElements.whenDefined('volume-tour').then(() => {
        const tour = /** @type {HTMLElementTagNameMap['volume-tour']} */ (document.querySelector('volume-tour'));
        [tour.duration, tour.step] = [0, to];
      }),
    step,
  );
  for (let i = 0; i < 2; i++) {
    await page.waitForTimeout(1500); // The labels and the marks come after the volume.
    await page.evaluate(() => document.querySelector('volume-view')?.whenRendered());
  }
  return (await page.screenshot()).toString('base64');
}

/**
 * The card of the page on which a reader's folder is opened.
 * @param {import('@playwright/test').Page} page
 */
async function photographOpenFiles(page) {
  await page.setViewportSize({ width: 640, height: 480 });
  await page.setContent(`<!doctype html><title>Open</title><script type="module" src="/src/index.ts"></script>
    <style>body { margin: 0; background: #0f1217; color: #e8eaee; font: 20px system-ui } volume-view { width: 640px; height: 320px; max-height: none } volume-drop { margin: 12px }</style>
    <volume-view src="/demos/data/head-mr-dicom.zip" look="textbook" camera-orbit="145deg 60deg auto"></volume-view><volume-drop></volume-drop>`);
  await page.evaluate(() =>
    Promise.all(['volume-view', 'volume-drop'].map((name) => customElements.whenDefined(name))).then(() => undefined),
  );
  await page.evaluate(() => document.querySelector('volume-view')?.whenRendered());
  await page.waitForTimeout(1500);
  return (await page.screenshot()).toString('base64');
}

/**
 * The card of the page with two volumes under a divider.
 * @param {import('@playwright/test').Page} page
 */
async function photographCompare(page) {
  await page.setViewportSize({ width: 640, height: 480 });
  await page.setContent(`<!doctype html><title>Compare</title><script type="module" src="/src/index.ts"></script>
    <style>body { margin: 0; background: #0f1217 } volume-compare { inline-size: 640px } volume-view { width: 640px; height: 480px; max-height: none }</style>
    <volume-compare layout="slider"><volume-view src="/demos/data/colin27-t1.nii.gz" look="textbook" camera-orbit="40deg 60deg auto"></volume-view><volume-view src="${mri.src}" look="textbook"></volume-view></volume-compare>`);
  await page.evaluate(() =>
    Promise.all(['volume-view', 'volume-compare'].map((name) => customElements.whenDefined(name))).then(
      () => undefined,
    ),
  );
  await page.evaluate(() =>
    Promise.all([...document.querySelectorAll('volume-view')].map((view) => view.whenRendered())),
  );
  await page.waitForTimeout(1500);
  await page.evaluate(() =>
    Promise.all([...document.querySelectorAll('volume-view')].map((view) => view.whenRendered())),
  );
  return (await page.screenshot()).toString('base64');
}

/**
 * In a page: a PNG as WebP.
 * @param {{ png: string, quality: number }} picture - in base64
 */
async function toWebp({ png, quality }) {
  const image = new Image();
  image.src = `data:image/png;base64,${png}`;
  await image.decode();
  const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
  canvas.getContext('2d')?.drawImage(image, 0, 0);
  return canvas.toDataURL('image/webp', quality);
}

const wanted = process.argv.slice(2);
const server = await createServer({
  root: projectRoot,
  logLevel: 'error',
  server: { port: 0, open: false, hmr: false, watch: null },
});
await server.listen();
const browser = await chromium.launch({ executablePath: await findBrowser(), args: listLaunchArgs() });
const page = await browser.newPage();
await page.goto(`${server.resolvedUrls?.local[0]}demos/index.html`);
await page.setContent('<!doctype html><title>Pictures</title><script type="module" src="/src/index.ts"></script>');
await page.evaluate(() => customElements.whenDefined('volume-view').then(() => undefined));
page.on('pageerror', (error) => console.log(String(error)));
pictures.push(card('paper', []));
/** Photographs of pages. They come last: each fills the page. */
/** @typedef {(page: import('@playwright/test').Page) => Promise<string>} Photographer - PNG in base64 */
/** @type {(guide: import('./guide-pictures.mjs').GuidePicture) => [Picture, Photographer]} */
const photographFor = (guide) => [
  { file: `docs/images/${guide.file}.webp`, size: guide.size, parts: [] },
  (one) => photographGuide(one, guide),
];
/** @type {(lesson: string, count: number) => [Picture, Photographer][]} */
const postersOf = (lesson, count) =>
  Array.from({ length: count }, (_, i) => [
    { file: `demos/images/${lesson}-${i + 1}.webp`, size: [480, 360], parts: [] },
    (one) => photographStep(one, lesson, i + 1, 'print'),
  ]);
const archive = process.env.VOLUME_VIEW_ARCHIVE;
/** @type {(folder: string) => [Picture, Photographer]} */
const photographOfArchive = (folder) => [
  { file: 'docs/images/guide-archive.webp', size: [1000, 770], parts: [] },
  (one) => photographArchive(one, folder),
];
/** @type {Map<Picture, Photographer>} */
const photographs = new Map([
  [card('companions', []), photographCompanions],
  [card('pointing', []), photographPointing],
  [card('large', []), photographLarge],
  [card('over-time', []), photographOverTime],
  [card('measure', []), photographMeasure],
  [card('notes', []), photographNotes],
  [card('tour', []), photographTour],
  [card('storm-lesson', []), photographStormLesson],
  [card('compare', []), photographCompare],
  [card('open-files', []), photographOpenFiles],
  ...guidePictures.map(photographFor),
  ...(archive ? [photographOfArchive(archive)] : []),
  [card('brain-lesson', []), (one) => photographStep(one, 'brain-lesson', 6, 'card')],
  ...postersOf('brain-lesson', 7),
  ...postersOf('storm-lesson', 4),
]);
pictures.push(...photographs.keys());
for (const picture of pictures) {
  if (wanted.length > 0 && !wanted.some((name) => picture.file.includes(name))) continue;
  const photograph = photographs.get(picture);
  const url = photograph
    ? await page.evaluate(toWebp, {
        png: await photograph(page),
        quality: picture.file.includes('/guide-') ? 0.8 : 0.92,
      })
    : picture.parts.length > 0
      ? await page.evaluate(paint, picture)
      : await page.evaluate(paintMosaic);
  const bytes = Buffer.from(url.slice(url.indexOf(',') + 1), 'base64');
  mkdirSync(dirname(join(projectRoot, picture.file)), { recursive: true });
  writeFileSync(join(projectRoot, picture.file), bytes);
  console.log(`${picture.file}: ${bytes.length} bytes`);
}
await browser.close();
await server.close();
