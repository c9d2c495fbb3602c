// Many elements that differ, their contexts, and how to wait for their pictures.
import type { Page } from '@playwright/test';
import { ballUrl, fieldUrl, withElement } from './harness.ts';
import type { Picture } from './pictures.ts';
import { attributesOf, drawReference } from './reference.ts';
import { ball } from './volumes.ts';

/** Half as wide and high as the other specs' pictures: there are many. */
const [width, height] = [60, 45];

export const black = `<style>volume-view { background: black; width: ${width}px; height: ${height}px }</style>`;
/** What a reference is drawn with for an element of such a page: its toBlob. */
export const sized = { width, height } as const;
/** And what stands on the screen. */
export const onBlack = { ...sized, background: [0, 0, 0] } as const;

/** One of a row of elements that differ. */
export const element = (i: number, children = ''): string =>
  `<volume-view id="v${i}" src="${i % 2 ? ballUrl : fieldUrl}" ${attributesOf({ steps: String(20 + i) })}>${children}</volume-view>`;

export const expected = (i: number): Picture =>
  drawReference({ steps: 20 + i, ...(i % 2 ? { volume: ball } : {}), ...onBlack });

interface Count {
  /** WebGL contexts that are not lost. */
  now(): number;
  /** The most of them at any time. */
  max: number;
}

declare global {
  interface Window {
    __contexts: Count;
  }
}

/** Count the page's contexts from its very beginning, those that only ask what the device can do too. */
export async function countContexts(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const all = new Set<WebGLRenderingContext | WebGL2RenderingContext>();
    const count: Count = { now: () => [...all].filter((context) => !context.isContextLost()).length, max: 0 };
    const original = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...args: unknown[]) {
      const context = Reflect.apply(original, this, args) as RenderingContext | null;
      if (context instanceof WebGLRenderingContext || context instanceof WebGL2RenderingContext) all.add(context);
      count.max = Math.max(count.max, count.now());
      return context as never;
    };
    window.__contexts = count;
  });
}

export const contexts = (page: Page): Promise<{ now: number; max: number }> =>
  page.evaluate(() => ({ now: window.__contexts.now(), max: window.__contexts.max }));

/** Whether an element has a scene of its own, and not only its last picture. */
export const isLive = (page: Page, i: number): Promise<boolean> =>
  withElement(page, (view) => view.shadowRoot!.querySelector('x3d') !== null, { selector: `#v${i}` });

/** Wait until elements have drawn their final pictures, without asking them for it. */
export async function waitUntilDrawn(page: Page, numbers: readonly number[]): Promise<void> {
  await page.waitForFunction(
    (wanted) =>
      wanted.every((i) => {
        const view = document.querySelector<HTMLElementTagNameMap['volume-view']>(`#v${i}`);
        return view?.renderStats?.converged;
      }),
    numbers,
  );
}
