// A view with all that can join it, moved by its page: what was set stays, and everything goes on in the new place.
import type { Page } from '@playwright/test';
import type { VolumePick } from '../../src/index.ts';
import { compare, expect, fieldUrl, open, test } from './helpers/harness.ts';
import { decodePicture } from './helpers/pictures.ts';
import type { Picture } from './helpers/pictures.ts';
import { attributesOf } from './helpers/reference.ts';
import { serveFiles } from './helpers/served-files.ts';
import { field } from './helpers/volumes.ts';
import { niftiBytes } from '../helpers/nifti-bytes.ts';

/** Two labels, 3 and 7, right and left of the middle. */
const atlas = niftiBytes({
  ...field,
  samples: field.samples.map((_, i) => (i % 24 < 12 ? 3 : 7)),
  slope: 1,
  intercept: 0,
});
const table = Buffer.from('index\tname\tcolor\n3\tRight side\t#ff0000\n7\tLeft side\t#0000ff\n');
const folder = '/test/e2e/pages/data/labels';
const small = `${attributesOf()} style="display: block; width: 120px; height: 90px"`;
const body = `<main><div id="box">
  <volume-view id="moved" pickable src="${fieldUrl}" ${small} alt="A field">
    <volume-labels src="${folder}/atlas.nii" table="${folder}/dseg.tsv"></volume-labels>
    <shape><appearance><material diffusecolor="0 1 0"></material></appearance><box size="4 4 40"></box></shape>
  </volume-view>
  <volume-clip for="moved" type="plane" normal="0 1 0" at="0"></volume-clip>
  <volume-readout for="moved"></volume-readout>
  <volume-legend for="moved"></volume-legend>
  <volume-label-list for="moved"></volume-label-list>
  <volume-slice-view for="moved" type="coronal" style="display: block; width: 120px"></volume-slice-view>
</div><div id="other"></div><div id="host"></div><iframe style="width: 500px; height: 900px; border: 0"></iframe></main>`;

interface Shown {
  readonly picture: Picture;
  readonly pane: Picture;
  readonly pick: VolumePick | null;
  /** What companions say. */
  readonly words: string[];
  readonly facts: unknown[];
}

/** Moves the box, then reads all that it shows. */
async function look(page: Page): Promise<Shown> {
  const box = await page.evaluateHandle(() => (window as never as { box: HTMLElement }).box);
  const found = await box.evaluate(async (all) => {
    const view = all.querySelector('volume-view')!;
    const pane = all.querySelector('volume-slice-view')!;
    const wait = (ms: number): Promise<void> => new Promise((resolve) => void setTimeout(resolve, ms));
    const until = async (holds: () => boolean): Promise<void> => {
      for (let i = 0; i < 200 && !holds(); i++) await wait(25);
    };
    const readout = all.querySelector('volume-readout')!;
    await view.whenRendered();
    await pane.whenRendered();
    await until(() => view.shadowRoot!.querySelector('.handle') !== null);
    // A click, as a hand makes it.
    const { left, top } = view.getBoundingClientRect();
    const picture = view.shadowRoot!.querySelector('.picture')!;
    const at = { clientX: left + 60, clientY: top + 40, bubbles: true, composed: true, isPrimary: true };
    let pick: unknown;
    view.addEventListener('volume-pick', ({ detail }) => (pick = detail), { once: true });
    (picture as HTMLElement).setPointerCapture = () => {};
    picture.dispatchEvent(new PointerEvent('pointerdown', at));
    picture.dispatchEvent(new PointerEvent('pointerup', at));
    picture.dispatchEvent(new MouseEvent('click', at));
    await until(() => pick !== undefined && /\d/.test(readout.shadowRoot!.textContent));
    const base64 = async (blob: Blob): Promise<string> =>
      btoa([...new Uint8Array(await blob.arrayBuffer())].map((byte) => String.fromCharCode(byte)).join(''));
    const canvas = pane.shadowRoot!.querySelector('canvas')!;
    const words = ['volume-readout', 'volume-legend', 'volume-label-list'].map((name) => {
      const root = all.querySelector(name)!.shadowRoot!;
      const spoken = root.querySelector('[role=status]')?.textContent ?? ''; // It comes a moment later.
      return root.textContent.replace(spoken, '').replace(/\s+/g, ' ').trim();
    });
    return {
      picture: await base64(await view.toBlob()),
      pane: canvas.toDataURL().split(',')[1],
      pick: pick as VolumePick | null,
      words,
      facts: [
        view.pickable,
        view.clientWidth,
        view.clientHeight,
        view.querySelector('volume-labels')!.labels.length,
        view.shadowRoot!.querySelectorAll('.handle').length,
        (window as never as { heard: number }).heard > 0,
      ],
    };
  });
  await page.evaluate(() => Object.assign(window, { heard: 0 }));
  return {
    ...found,
    picture: decodePicture(Buffer.from(found.picture, 'base64')),
    pane: decodePicture(Buffer.from(found.pane, 'base64')),
  };
}

const moves: Readonly<Record<string, () => void>> = {
  'another place of the page': () => document.querySelector('#other')!.append((window as never as { box: Node }).box),
  "an author's shadow root": () =>
    document
      .querySelector('#host')!
      .attachShadow({ mode: 'open' })
      .append((window as never as { box: Node }).box),
  'the document of a frame': () => {
    const { contentDocument } = document.querySelector('iframe')!;
    contentDocument!.body.append(contentDocument!.adoptNode((window as never as { box: Node }).box));
  },
  'the page, back again': () => document.querySelector('main')!.prepend((window as never as { box: Node }).box),
};

test('a view with everything that joins it shows and picks the same wherever its page moves it', async ({ page }) => {
  test.setTimeout(120_000);
  await serveFiles(page, folder, { 'atlas.nii': Buffer.from(atlas), 'dseg.tsv': table });
  await open(page, body);
  await page.evaluate(() => {
    Object.assign(window, { box: document.querySelector('#box'), heard: 0 });
    document
      .querySelector('volume-view')!
      .addEventListener('render', () => (window as never as { heard: number }).heard++);
  });
  const before = await look(page);
  expect(before.pick).not.toBeNull();
  expect(before.facts.slice(0, 3)).toEqual([true, 120, 90]);
  for (const [name, move] of Object.entries(moves)) {
    await page.evaluate(move);
    const after = await look(page);
    expect.soft(after.facts, name).toEqual(before.facts);
    expect.soft(after.words, name).toEqual(before.words);
    expect.soft(after.pick, name).toEqual(before.pick);
    expect.soft(compare(after.picture, before.picture).worst, name).toBeLessThanOrEqual(1);
    expect.soft(compare(after.pane, before.pane).worst, name).toBeLessThanOrEqual(1);
  }
});
