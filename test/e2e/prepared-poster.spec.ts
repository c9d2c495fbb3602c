import { join } from 'node:path';
import { FolderStore, folderBase } from '../../packages/prepare/src/folder-store.ts';
import { decodeSource } from '../../src/prepare/decode-source.ts';
import { drawPoster } from '../../src/prepare/draw-poster.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { urlInStore } from '../../src/sources/byte-store.ts';
import { expect, open, settle, takePicture, test } from './helpers/harness.ts';

// The picture that `volume-view-prepare` draws in Node is the one that a page shows.

const folder = join(import.meta.dirname, '../../demos/data');
const size = 64;

async function readVolume(name: string): Promise<Volume> {
  const store = new FolderStore(folder, { only: [name, name.replace('.json', '.png')] });
  for await (const one of decodeSource(
    store,
    { first: urlInStore(folderBase, name), phase: 1 },
    { deviceBytes: 2 ** 30 },
  )) {
    if ('error' in one) throw one.error;
    return one.volume;
  }
  throw new Error(`no volume in ${name}`);
}

for (const name of ['mni152-t1.nii.gz', 'ct-phantom.nii.gz', 'storm-radar-1500.json', 'motor-synthetic.nii.gz'])
  test(`the poster of ${name} is the picture of the element`, async ({ page }) => {
    test.setTimeout(180_000);
    const { pixels } = await drawPoster(await readVolume(name), size);
    await open(
      page,
      `<volume-view src="/demos/data/${name}" rings="none" map="none" style="width: ${size}px; height: ${size}px; aspect-ratio: auto"></volume-view>`,
    );
    await settle(page);
    const { data, width, height } = await takePicture(page);
    expect([width, height]).toEqual([size, size]);
    const differences: number[] = [];
    let shown = 0;
    for (let at = 0; at < data.length; at += 4) {
      // What a white page shows. Both have colours that are multiplied by the opacity.
      const onWhite = (c: number): number => data[at + c] + 255 - data[at + 3];
      const drawn = (c: number): number => 255 * (pixels[at + c] + 1 - pixels[at + 3]);
      const worst = Math.max(...[0, 1, 2].map((c) => Math.abs(onWhite(c) - drawn(c))));
      if (data[at + 3] > 0 || pixels[at + 3] > 0) shown++;
      differences.push(worst);
    }
    differences.sort((a, b) => b - a);
    // Over the pixels that show something: others would dilute it.
    const rmse = Math.hypot(...differences) / Math.sqrt(shown);
    expect(shown).toBeGreaterThan((size * size) / 20);
    expect(rmse).toBeLessThan(1);
    expect(differences[0], 'the worst pixel').toBeLessThan(5);
    expect(differences[Math.floor(shown / 100)], 'all but one pixel of a hundred').toBeLessThan(2);
  });
