// Several scans, each of one value and one colour: what serves them, and what shows which one is seen.
import type { Page } from '@playwright/test';
import { syntheticVolume } from '../../helpers/synthetic.ts';
import { niftiBytes } from '../../helpers/nifti-bytes.ts';
import { expect, seenEvents, settle, withElement } from './harness.ts';
import { decodePicture } from './pictures.ts';

/** One colour a scan: red, green, blue, yellow, cyan, magenta, white, gray. */
export const colors = ['#f00', '#0f0', '#00f', '#ff0', '#0ff', '#f0f', '#fff', '#888'];
const valueOf = (scan: number): number => (20 + 20 * scan) / 255;
export const look = `transfer-function="${colors.map((color, i) => `${valueOf(i)} ${color} 100%`).join(', ')}" value-window="0 1" steps="16"`;

/** When scan i began. */
export const timeOf = (scan: number): string => `2018-12-20T06:${String(6 * scan).padStart(2, '0')}:28Z`;
export const urls = (count: number): string[] => Array.from({ length: count }, (_, i) => `/scans/${i}.nii`);
export const several = (count: number): string => `src="${urls(count).join(' ')}" ${look} alt="Scans"`;

interface Server {
  /** Numbers of the scans in the order in which they were asked for. */
  readonly asked: number[];
  /** Scans that do not come until they are let go. */
  readonly held: Set<number>;
}

interface ServerOptions {
  readonly missing?: readonly number[];
  readonly manifest?: object;
  /** Slices of a scan. */
  readonly height?: (scan: number) => number;
}

/** Serve scans of one value each, some of them missing, and manifests. */
export async function serve(
  page: Page,
  { missing = [], manifest = {}, height = () => 8 }: ServerOptions = {},
): Promise<Server> {
  const server: Server = { asked: [], held: new Set() };
  await page.route('**/scans/*.nii', async (route) => {
    const scan = Number(/(\d+)\.nii/.exec(route.request().url())![1]);
    server.asked.push(scan);
    if (missing.includes(scan)) return route.fulfill({ status: 404, body: 'no' });
    while (server.held.has(scan)) await new Promise((resolve) => setTimeout(resolve, 20));
    const volume = syntheticVolume({ dimensions: [8, 8, height(scan)], field: () => valueOf(scan) });
    await route
      .fulfill({ body: Buffer.from(niftiBytes(volume)), contentType: 'application/octet-stream' })
      .catch(() => {});
  });
  await page.route('**/scans/list.json', (route) => route.fulfill({ json: manifest }));
  return server;
}

export const listed = (count: number): object => ({
  scans: Array.from({ length: count }, (_, i) => ({ image: `${i}.nii`, time: timeOf(i) })),
});

interface Reported {
  readonly index: number;
  readonly time: string | null;
  readonly count: number;
}

/** Changes of time that the page was told. */
export async function reported(page: Page): Promise<Reported[]> {
  return (await seenEvents(page)).filter(({ type }) => type === 'time-change').map(({ detail }) => detail as Reported);
}

export const shown = (page: Page): Promise<number | undefined> => withElement(page, (element) => element.scan?.index);
export const expectShown = (page: Page, index: number): Promise<void> => expect.poll(() => shown(page)).toBe(index);

/** The colour in the middle of the picture as it stands on the screen, each channel 0 to 15. */
export async function middle(page: Page, x = 59, y = 44): Promise<string> {
  const { data } = decodePicture(await page.screenshot({ clip: { x, y, width: 2, height: 2 } }));
  return `#${[...data.subarray(0, 3)].map((x) => Math.round(x / 17).toString(16)).join('')}`;
}

export async function expectMiddle(page: Page, scan: number): Promise<void> {
  await settle(page);
  await expect.poll(() => middle(page)).toBe(colors[scan]);
}
