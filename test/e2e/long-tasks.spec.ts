// What would keep the page's thread busy: to read what the GPU has not drawn yet. Counted, not timed; `npm run bench -- load` times.
import { expect, open, settle, test } from './helpers/harness.ts';

interface Watched {
  reads: number;
  /** Reads for which the page had to wait, by the pictures that had been shown before. */
  readonly waits: number[];
  shown: number;
}

for (const [name, tag] of [
  ['an MRI', 'src="/demos/data/mni152-t1.nii.gz"'],
  ['surfaces of a CT', 'src="/demos/data/ct-phantom.nii.gz" preset="ct-bone" surface-values="200 white"'],
  ['a radar with its rings', 'src="/demos/data/storm-radar-1510.json"'],
] as const) {
  test(`the page's thread never waits for what is read of ${name}: it reads when the GPU has drawn that`, async ({
    page,
  }) => {
    await page.addInitScript(() => {
      const watched: Watched = { reads: 0, waits: [], shown: 0 };
      Object.assign(window, { watched });
      const gl = WebGL2RenderingContext.prototype;
      const { readPixels, getBufferSubData, fenceSync, clientWaitSync } = gl;
      // By contexts: how many drawings there were, and how many of them are known to be done.
      const drawn = new WeakMap<WebGL2RenderingContext, { count: number; done: number }>();
      const fences = new WeakMap<WebGLSync, number>();
      // The GPU copies what is read later into a buffer, in order with its drawings: by buffers, the number of the copy.
      const copies = new WeakMap<WebGLBuffer, number>();
      const bound = (context: WebGL2RenderingContext): WebGLBuffer =>
        context.getParameter(context.PIXEL_PACK_BUFFER_BINDING) as WebGLBuffer;
      const of = (context: WebGL2RenderingContext): { count: number; done: number } =>
        drawn.get(context) ?? { count: 0, done: 0 };
      for (const draw of ['drawArrays', 'drawElements'] as const) {
        const original = gl[draw] as (...args: unknown[]) => void;
        gl[draw] = function (this: WebGL2RenderingContext, ...args: unknown[]) {
          drawn.set(this, { ...of(this), count: of(this).count + 1 });
          original.apply(this, args);
        };
      }
      gl.fenceSync = function (condition, flags) {
        const fence = fenceSync.call(this, condition, flags);
        if (fence) fences.set(fence, of(this).count);
        return fence;
      };
      gl.clientWaitSync = function (fence, flags, timeout) {
        const status = clientWaitSync.call(this, fence, flags, timeout);
        if (status !== this.TIMEOUT_EXPIRED)
          drawn.set(this, { ...of(this), done: Math.max(of(this).done, fences.get(fence) ?? 0) });
        return status;
      };
      gl.readPixels = function (this: WebGL2RenderingContext, ...args: unknown[]) {
        watched.reads++;
        const { count, done } = of(this);
        if (typeof args[6] === 'number') {
          drawn.set(this, { count: count + 1, done });
          copies.set(bound(this), count + 1);
          return Reflect.apply(readPixels, this, args);
        }
        // What a device's filters do is asked of a few pixels, once, before there is a picture.
        const isPicture = Number(args[2]) * Number(args[3]) > 64;
        if (isPicture && done < count) watched.waits.push(watched.shown);
        Reflect.apply(readPixels, this, args);
      };
      gl.getBufferSubData = function (this: WebGL2RenderingContext, ...args: unknown[]) {
        if (of(this).done < (copies.get(bound(this)) ?? Infinity)) watched.waits.push(watched.shown);
        Reflect.apply(getBufferSubData, this, args);
      };
      document.addEventListener('render', () => watched.shown++, true);
    });
    await open(page, `<volume-view ${tag} style="width: 300px; height: 300px" alt="A scan"></volume-view>`);
    await settle(page);
    // What is learnt of the last picture comes after it.
    const { reads, waits, shown } = await page.evaluate(async () => {
      const { watched } = window as unknown as { watched: Watched };
      for (let before = -1; before < watched.reads;) {
        before = watched.reads;
        await new Promise((resolve) => setTimeout(resolve, 500));
      }
      return watched;
    });
    expect(shown).toBeGreaterThanOrEqual(2);
    expect(reads, 'errors are measured').toBeGreaterThanOrEqual(4);
    expect(waits).toEqual([]);
  });
}
