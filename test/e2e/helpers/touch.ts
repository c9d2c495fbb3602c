// Fingers on the screen, as Chromium's protocol makes them: real ones, which scroll and are cancelled for it.
import type { Page } from '@playwright/test';

type Point = readonly [x: number, y: number];

/** Nine points of a straight way. */
export const line = (from: Point, to: Point): Point[] =>
  Array.from({ length: 9 }, (_, i) => [from[0] + ((to[0] - from[0]) * i) / 8, from[1] + ((to[1] - from[1]) * i) / 8]);

/** Put fingers down, move them along their ways, and lift them. */
export async function touch(page: Page, ways: readonly (readonly Point[])[]): Promise<void> {
  const session = await page.context().newCDPSession(page);
  const points = (i: number) => ways.map((way, id) => ({ x: way[i][0], y: way[i][1], id }));
  await session.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: points(0) });
  for (let i = 1; i < ways[0].length; i++)
    await session.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: points(i) });
  await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
}
