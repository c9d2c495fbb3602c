// What a page pays that uses nothing special: programs, contexts, and what is asked for over the network.
import { countGpuBytes } from '../bench/count-gpu-bytes.mjs';
import { expect, open, settle, test } from './helpers/harness.ts';

interface Counted {
  /** Of each program that was linked, whether it casts rays. */
  readonly programs: boolean[];
  /** How many there were at the first picture. */
  atFirst: number;
  contexts: number;
  /** How often pixels were read back, at each picture; and how often in all. */
  reads: number;
  readsAt: number[];
  /** Uploads of the means over spans of values. */
  tables: number;
  /** Pixels across of each picture. */
  widths: number[];
}

/** A scan that is lit pays for light, and one that is not does not. */
const plainScans = [
  { title: 'an unlit MRI', attributes: 'shading="unlit"', parts: [] },
  {
    title: 'an MRI that is lit by default',
    attributes: '',
    parts: ['styles', 'light', 'lights', 'points', 'style-detail', 'gradient', 'styled', 'keep-last', 'part-of-twins'],
  },
];

for (const { title, attributes, parts } of plainScans) {
  test(`${title} compiles one ray-caster, and asks for no part of other features`, async ({ page }) => {
    const scripts: string[] = [];
    page.on('request', (request) => {
      if (request.url().endsWith('.js'))
        scripts.push(
          new URL(request.url()).pathname
            .split('/')
            .at(-1)!
            .replace(/-.{8}\.js$/, ''),
        );
    });
    await page.addInitScript(countGpuBytes);
    await page.addInitScript(() => {
      const counted: Counted = { programs: [], atFirst: 0, contexts: 0, reads: 0, readsAt: [], tables: 0, widths: [] };
      Object.assign(window, { counted });
      const { linkProgram } = WebGL2RenderingContext.prototype;
      WebGL2RenderingContext.prototype.linkProgram = function (program) {
        counted.programs.push(
          (this.getAttachedShaders(program) ?? []).some((shader) =>
            this.getShaderSource(shader)?.includes('gatherSegment'),
          ),
        );
        linkProgram.call(this, program);
      };
      const getContext = HTMLCanvasElement.prototype.getContext as (
        this: HTMLCanvasElement,
        kind: string,
        options?: unknown,
      ) => RenderingContext | null;
      HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, options?: unknown) {
        if (kind === 'webgl2') counted.contexts++;
        return getContext.call(this, kind, options);
      } as typeof HTMLCanvasElement.prototype.getContext;
      const { readPixels, getBufferSubData, texImage2D } = WebGL2RenderingContext.prototype;
      WebGL2RenderingContext.prototype.readPixels = function (this: WebGL2RenderingContext, ...args: unknown[]) {
        // Into a buffer of the GPU: the page reads that later.
        if (typeof args[6] !== 'number') counted.reads++;
        Reflect.apply(readPixels, this, args);
      };
      WebGL2RenderingContext.prototype.getBufferSubData = function (this: WebGL2RenderingContext, ...args: unknown[]) {
        counted.reads++;
        Reflect.apply(getBufferSubData, this, args);
      };
      WebGL2RenderingContext.prototype.texImage2D = function (this: WebGL2RenderingContext, ...args: unknown[]) {
        if (args.at(-1) instanceof Float32Array && args[4] === 64) counted.tables++;
        Reflect.apply(texImage2D, this, args);
      };
      document.addEventListener(
        'render',
        (event) => {
          counted.atFirst ||= counted.programs.length;
          counted.readsAt.push(counted.reads);
          counted.widths.push((event as CustomEvent<{ width: number }>).detail.width);
        },
        true,
      );
    });
    await open(
      page,
      `<volume-view src="/demos/data/mni152-t1.nii.gz" ${attributes} style="width: 160px; height: 120px" alt="A head"></volume-view>`,
    );
    await settle(page);
    const bytes = await page.evaluate(() =>
      (window as unknown as { gpuBytes: () => { samples: number; textures: number } }).gpuBytes(),
    );
    const { programs, atFirst, contexts, readsAt, tables, widths } = await page.evaluate(
      () => (window as unknown as { counted: Counted }).counted,
    );
    expect(programs.filter((casts) => casts)).toHaveLength(1);
    // Two of x3dom's own come with every scene.
    expect(atFirst).toBeLessThanOrEqual(3);
    expect(programs.length).toBeLessThanOrEqual(4);
    expect(contexts, "the scene's, and one that tells what the device can do").toBeLessThanOrEqual(2);
    expect(readsAt[0], 'the first picture waits for nothing').toBe(0);
    expect(readsAt.at(-1), 'two lattices of three pictures tell the error').toBeLessThanOrEqual(6);
    expect(tables, 'what the coarse picture has made stays').toBe(1);
    expect(
      widths.every((width, i) => i === 0 || width >= widths[i - 1]),
      `no picture is smaller than the one before: ${widths.join(' ')}`,
    ).toBe(true);
    expect(widths.at(-1)).toBe(160);
    const expected = [
      'volume-view.js',
      'decode-worker.js',
      'x3dom.js',
      'framing',
      'gpu-timer',
      'upload-gradually',
      'view-quality',
      'emission-range',
      'depth-jumps',
      'interaction',
      'camera-moves',
      'pointer-place',
      'gather-picture',
      'worker-nifti',
      'worker-grid-samples',
      ...parts,
    ];
    // Where the final picture takes more than a second, which no test can say.
    expected.push('refining-sign', 'apply-sheet');
    expect(scripts.filter((name) => !expected.includes(name))).toEqual([]);
    expect(bytes.samples).toBe(197 * 233 * 189);
    expect(bytes.textures).toBeLessThan(1.3 * bytes.samples);
  });
}

test('what draws a radar is there before its file is', async ({ page }) => {
  const scripts: string[] = [];
  page.on('requestfinished', (request) =>
    scripts.push(
      new URL(request.url()).pathname
        .split('/')
        .at(-1)!
        .replace(/-.{8}\.js$/, ''),
    ),
  );
  let isHeld = false;
  const parts = ['polar-provider', 'other-shapes', 'read-cuts', 'presets', 'precompile'];
  // The picture of the manifest is held back until they are there: it would never come, were they asked for later.
  await page.route('**/storm-radar-1510.png', async (route) => {
    isHeld = true;
    await expect.poll(() => parts.filter((part) => !scripts.includes(part))).toEqual([]);
    await route.continue();
  });
  await open(
    page,
    '<volume-view src="/demos/data/storm-radar-1510.json" style="width: 200px; height: 150px" alt="A storm"></volume-view>',
  );
  await settle(page);
  expect(isHeld).toBe(true);
});
