// Scenes of the form of X3DOM's own examples, moved into the element: each draws what it says, before its background, and tells no
// error but what docs/guide/x3d-styles.md says. Their picture beside X3DOM's is made by scripts/x3dom-sheet.mjs.
import { encode } from 'fast-png';
import { exampleScenes } from '../../scripts/x3dom-scenes.mjs';
import { expect, keptTest as test, open, seenEvents, settle, takeScreenshot, withElement } from './helpers/harness.ts';
import type { Picture } from './helpers/pictures.ts';
import { serveFiles } from './helpers/served-files.ts';

const folder = '/test/e2e/pages/data/x3dom';
const [across, down, size] = [4, 4, 16];

/** Slices of a function of the volume's box, 0 to 255. */
function tile(valueOf: (x: number, y: number, z: number) => number): Buffer {
  const data = new Uint8Array(across * size * down * size);
  for (let i = 0; i < data.length; i++) {
    const [column, row] = [i % (across * size), Math.floor(i / (across * size))];
    const slice = Math.floor(row / size) * across + Math.floor(column / size);
    data[i] = Math.round(
      valueOf(((column % size) + 0.5) / size, ((row % size) + 0.5) / size, (slice + 0.5) / (across * down)),
    );
  }
  return Buffer.from(encode({ width: across * size, height: down * size, data, channels: 1, depth: 8 }));
}

/** A ball with a bright core, and air around it. */
const ball =
  (max: number) =>
  (x: number, y: number, z: number): number =>
    Math.max(0, max * Math.min(1, 2.4 - 6 * Math.hypot(x - 0.5, y - 0.5, z - 0.5)));
const red = Uint8Array.from({ length: 256 * 4 }, (_, i) => [255, 40, 20, Math.floor(i / 4)][i % 4]);
const files = {
  'body.png': tile(ball(200)),
  'inside.png': tile(ball(240)),
  'halves.png': tile((x) => (x < 0.5 ? 0 : 1)),
  'red.png': Buffer.from(encode({ width: 256, height: 1, data: red, channels: 4, depth: 8 })),
};
const atlas = (name: string) => ({ url: `${folder}/${name}`, slices: across * down, across, down });
const data = {
  brain: atlas('body.png'),
  body: atlas('body.png'),
  inside: atlas('inside.png'),
  halves: atlas('halves.png'),
  colors: `${folder}/red.png`,
};

/** What is seen: its share of the picture in per cent, and its mean colour, weighed by how much it differs from the background. */
function describe({ data: pixels, width, height }: Picture): {
  share: number;
  color: readonly number[];
  background: readonly number[];
  strongest: number;
} {
  const background = [0, 1, 2].map((c) => pixels[c]);
  let [count, weights, strongest] = [0, 0, 0];
  const color = [0, 0, 0];
  for (let i = 0; i < pixels.length; i += 4) {
    const weight = Math.max(...[0, 1, 2].map((c) => Math.abs(pixels[i + c] - background[c])));
    if (weight > 2) count++;
    strongest = Math.max(strongest, weight);
    weights += weight;
    for (let c = 0; c < 3; c++) color[c] += weight * pixels[i + c];
  }
  return { share: (100 * count) / (width * height), color: color.map((x) => x / weights), background, strongest };
}

const [black, white] = [
  [0, 0, 0],
  [255, 255, 255],
];
const isGray = ([r, g, b]: readonly number[]): boolean => Math.max(r, g, b) - Math.min(r, g, b) < 3;
const isYellow = ([r, g, b]: readonly number[]): boolean => Math.abs(r - g) < 10 && b < 0.4 * r;
const isRed = ([r, g, b]: readonly number[]): boolean => r > 2 * g && r > 2 * b;
const isBlue = ([r, g, b]: readonly number[]): boolean => b > r + 30 && b > g;
const isReddish = ([r, g, b]: readonly number[]): boolean => r > g + 8 && Math.abs(g - b) < 5;
const isColored = (color: readonly number[]): boolean => !isGray(color);

/** By title: the background, per cent that are covered at least and at most, a colour, and the strongest pixel. */
const expected: Readonly<
  Record<
    string,
    readonly [
      sky: readonly number[],
      share: readonly [number, number],
      color: (mean: readonly number[]) => boolean,
      strongest: readonly [number, number],
    ]
  >
> = {
  'No style': [white, [5, 60], isGray, [40, 200]],
  'Tone-mapped': [black, [10, 95], isYellow, [60, 255]],
  Blended: [black, [10, 95], isColored, [60, 255]],
  Cartoon: [white, [5, 60], isGray, [60, 255]],
  Composed: [white, [5, 60], isReddish, [20, 255]],
  Edges: [white, [20, 90], isGray, [60, 255]],
  'Iso-surface': [black, [10, 60], isGray, [150, 255]],
  'Projection, whole ray': [black, [5, 80], isGray, [100, 200]],
  Segmented: [black, [5, 80], isYellow, [40, 255]],
  Shaded: [white, [20, 90], isBlue, [40, 255]],
  Silhouette: [black, [5, 60], isGray, [40, 255]],
  'Opacity 0.4': [black, [0.5, 30], isGray, [3, 25]],
  'Opacity 0.8': [black, [1, 30], isGray, [6, 50]],
  'Opacity map': [black, [3, 30], isGray, [60, 200]],
  'Light 0.02': [black, [0.5, 30], isRed, [3, 40]],
  'Edges, 1.8': [black, [3, 30], isGray, [60, 220]],
  'Opacity 6, texture': [black, [3, 30], isRed, [90, 255]],
  Projection: [black, [3, 30], isGray, [100, 200]],
  'Depth-mapped': [black, [3, 60], isColored, [60, 255]],
};

test.use({ allowedLines: /shadows="true" of a ShadedVolumeStyle is left out of the picture/ });

for (const { file, title, html, code } of exampleScenes) {
  test(`${title}, as ${file}`, async ({ page }) => {
    await serveFiles(page, folder, files);
    await open(
      page,
      `<volume-view style="width: 120px; height: 120px" alt="A ball"><x3d>${html(data)}</x3d></volume-view>`,
      { head: '<style>volume-view::part(error) { display: none }</style>' },
    );
    await settle(page).catch(() => {}); // Of what is wrong the event tells.
    const errors = (await seenEvents(page))
      .filter(({ type }) => type === 'error')
      .map(({ detail }) => (detail as { code: string }).code);
    expect(errors.at(-1)).toBe(code);
    // In float64 it is the same.
    const checked = code ? null : await withElement(page, (element) => element.checkPicture());
    if (!code) expect(checked).toMatchObject({ off: 0, agrees: true });
    const { share, color, background, strongest } = describe(await takeScreenshot(page));
    const [sky, [min, max], isOfColor, [weak, strong]] = expected[title];
    expect(background).toEqual(sky);
    expect(share).toBeGreaterThan(min);
    expect(share).toBeLessThan(max);
    expect(isOfColor(color), `rgb ${color.join(' ')}`).toBe(true);
    expect(strongest).toBeGreaterThan(weak);
    expect(strongest).toBeLessThanOrEqual(strong);
  });
}
