// <volume-drop> and <volume-series>: a reader's files, and what of them may be seen.
import type { Page } from '@playwright/test';
import { ctSlice, dicomBytes } from '../helpers/dicom-bytes.ts';
import type { DicomFields } from '../helpers/dicom-bytes.ts';
import { findFaults } from './helpers/axe.ts';
import { files as dataFiles } from './helpers/data.ts';
import { expect, fieldUrl, keptTest as test, open, settle, waitForEvent, withElement } from './helpers/harness.ts';

const [person, birth, number, uid, folder] = ['Geheim^Erna', '19010203', 'PID4711', '1.2.77.4711', 'Ordner_Geheim'];
const secrets = /geheim|19010203|4711|1\.2\.77|ordner/i;

/** A secret in every element that holds text. */
const planted: DicomFields = {
  StudyDate: birth,
  AccessionNumber: number,
  InstitutionName: person,
  ReferringPhysicianName: person,
  SeriesDescription: person,
  PatientName: person,
  PatientID: number,
  PatientBirthDate: birth,
  PatientComments: person,
  ImageComments: person,
  StudyInstanceUID: uid,
  SOPInstanceUID: uid,
  BurnedInAnnotation: 'YES',
};

interface Given {
  readonly path: string;
  readonly base64: string;
}

const give = (path: string, bytes: Uint8Array): Given => ({ path, base64: Buffer.from(bytes).toString('base64') });
/** Slices of 16 x 16 pixels: ctSlice has 4 x 3. */
const series = (count: number, which: number, fields: DicomFields = {}): Given[] =>
  Array.from({ length: count }, (_, k) =>
    give(
      `${folder}/${which}/${person}-${k}.dcm`,
      dicomBytes(
        ctSlice(
          5 * k,
          { ...planted, SeriesInstanceUID: `${uid}.${which}`, SeriesNumber: String(which), ...fields },
          100 * k,
        ),
      ),
    ),
  );
const study = [...series(4, 2), ...series(3, 5, { Modality: 'MR' })];
const page = `<main><h1>Files</h1><volume-view id="v" src="${fieldUrl}" alt="A field" controls></volume-view><volume-drop for="v"></volume-drop><volume-readout for="v"></volume-readout></main>`;

/** Drops files on an element, as far as a test can: the entries are made here, with folders. */
async function drop(target: Page, given: readonly Given[], selector = '#v', isPaste = false): Promise<void> {
  await target.evaluate(
    ([all, where, paste]) => {
      const data = new DataTransfer();
      for (const { path, base64 } of all) {
        const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
        data.items.add(new File([bytes], path.split('/').at(-1)!));
      }
      const element = document.querySelector(where)!;
      const event = paste
        ? new ClipboardEvent('paste', { clipboardData: data, bubbles: true, composed: true, cancelable: true })
        : new DragEvent('drop', { dataTransfer: data, bubbles: true, composed: true, cancelable: true });
      element.dispatchEvent(event);
      if (!event.defaultPrevented) throw new Error('nobody took it');
    },
    [given, selector, isPaste] as const,
  );
}

const status = (target: Page) => target.locator('volume-drop [part=status]');
const ready = async (target: Page): Promise<void> => {
  await target.waitForFunction(() => customElements.get('volume-drop') !== undefined);
  await settle(target, '#v');
};

test('says what was read, and lists the series with their pictures', async ({ page: target }) => {
  await open(target, page);
  await ready(target);
  await expect(target.locator('volume-drop')).toContainText('nothing is uploaded');
  await drop(target, study);
  await expect(status(target)).toHaveText('DICOM, CT, 4 × 3 × 4 voxels. Files: 7.');
  const rows = target.getByRole('radio');
  await expect(rows).toHaveCount(2);
  await expect(target.getByRole('radio', { name: 'CT · Series 2' })).toBeChecked();
  expect(
    await target.locator('volume-drop canvas').evaluateAll((all) => all.map((one) => (one as HTMLCanvasElement).width)),
  ).toEqual([4, 4]);
  // By keys: the arrow chooses the next one.
  await target.getByRole('radio', { name: 'CT · Series 2' }).focus();
  await target.keyboard.press('ArrowDown');
  await expect(status(target)).toHaveText('DICOM, MR, 4 × 3 × 3 voxels. Files: 7.');
  expect(
    await withElement(target, (view) => [view.getAttribute('series'), view.getView().series, view.volume!.source]),
  ).toEqual(['2', '2', { kind: 'files', count: 7 }]);
  await expect(target.getByRole('radio', { name: 'MR · Series 5' })).toBeChecked();
  expect(await findFaults(target)).toEqual([]);
});

test('takes what is pasted, and what is dropped on the element itself', async ({ page: target }) => {
  await open(target, page);
  await ready(target);
  await drop(target, [give('a.nii', new Uint8Array(dataFiles['ball.nii']))], 'body', true);
  await expect(status(target)).toContainText('NIfTI-1');
  await drop(target, series(3, 1), 'volume-drop');
  await expect(status(target)).toContainText('4 × 3 × 3 voxels. Files: 3.');
});

test('opens the dialogs of the browser by its buttons', async ({ page: target }) => {
  await open(target, page);
  await ready(target);
  const chosen = target.waitForEvent('filechooser');
  await target.getByRole('button', { name: 'Open files…' }).press('Enter');
  await (await chosen).setFiles([{ name: 'ball.nii', mimeType: '', buffer: Buffer.from(dataFiles['ball.nii']) }]);
  await expect(status(target)).toContainText('NIfTI-1');
  const folderChosen = target.waitForEvent('filechooser');
  await target.getByRole('button', { name: 'Open a folder…' }).click();
  expect((await folderChosen).isMultiple()).toBe(true);
});

test('says why files can not be read, and keeps the last picture', async ({ page: target }) => {
  await open(target, page);
  await ready(target);
  await drop(target, [
    give('Geheim.txt', new TextEncoder().encode('Dear Sir')),
    give('Geheim-2.txt', new Uint8Array(9)),
  ]);
  await expect(status(target)).toContainText('the choice of 2 files holds 2 files');
  await expect(status(target)).not.toContainText(secrets);
  expect(await withElement(target, (view) => view.volume!.dimensions)).toEqual([24, 20, 16]);
});

test('shows a frame over the picture while files are dragged', async ({ page: target }) => {
  await open(target, page);
  await ready(target);
  const box = await target.evaluate(() => {
    const data = new DataTransfer();
    data.items.add(new File(['a'], 'a.nii'));
    const view = document.querySelector('volume-view')!;
    view.dispatchEvent(new DragEvent('dragenter', { dataTransfer: data, bubbles: true, cancelable: true }));
    const { x, y, width, height } = view.getBoundingClientRect();
    return { x, y, width, height };
  });
  const frame = target.locator('volume-drop [part=frame]');
  await expect(frame).toBeVisible();
  await expect(frame).toHaveText('Drop to open');
  expect(await frame.boundingBox()).toEqual(box);
  await expect(frame).toBeHidden(); // Nothing is dragged any longer.
});

test('files that are dropped where no view is do not make the browser leave the page', async ({ page: target }) => {
  await open(target, '<volume-drop for="nowhere"></volume-drop>');
  await expect(target.locator('volume-drop')).toContainText('nowhere');
  const taken = await target.evaluate(() => {
    const data = new DataTransfer();
    data.items.add(new File(['a'], 'a.nii'));
    return ['dragover', 'drop'].map((type) => {
      const event = new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true });
      document.querySelector('volume-drop')!.dispatchEvent(event);
      return event.defaultPrevented;
    });
  });
  expect(taken).toEqual([true, true]);
});

test('a text that is pasted, and a link that is dragged, are none of its business', async ({ page: target }) => {
  await open(target, page);
  await ready(target);
  const taken = await target.evaluate(() => {
    const data = new DataTransfer();
    data.setData('text/plain', 'Hello');
    return [
      new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true }),
      new DragEvent('dragover', { dataTransfer: data, bubbles: true, cancelable: true }),
    ].map((event) => {
      document.querySelector('volume-view')!.dispatchEvent(event);
      return event.defaultPrevented;
    });
  });
  expect(taken).toEqual([false, false]);
});

test('volume-series alone lists the series of an archive', async ({ page: target }) => {
  const { zipSync } = await import('fflate');
  const zip = zipSync(Object.fromEntries(study.map(({ path, base64 }) => [path, Buffer.from(base64, 'base64')])));
  const src = `data:application/zip;base64,${Buffer.from(zip).toString('base64')}`;
  await open(
    target,
    `<volume-view id="v" src="${src}" series="2" alt="A study"></volume-view><volume-series for="v"></volume-series>`,
  );
  await settle(target, '#v');
  await expect(target.getByRole('radio', { name: 'MR · Series 5' })).toBeChecked();
  await target.getByRole('radio', { name: 'CT · Series 2' }).check();
  await expect.poll(() => withElement(target, (view) => view.volume!.format)).toBe('DICOM, CT');
  await withElement(target, (view) => {
    view.series = 9;
  });
  const { detail } = await waitForEvent(target, 'error');
  expect((detail as Error).message).toContain('expected a number from 1 to 2');
});

test('nothing of what files say of a patient, and no name of a file, is anywhere in the page', async ({
  page: target,
}) => {
  const said: string[] = [];
  target.on('console', (message) => said.push(message.text()));
  target.on('pageerror', (error) => said.push(String(error)));
  await open(target, page);
  await ready(target);
  await target.evaluate(() => {
    const view = document.querySelector('volume-view')!;
    const events: string[] = [];
    Object.assign(window, { events });
    const { dispatchEvent } = EventTarget.prototype;
    EventTarget.prototype.dispatchEvent = function (event) {
      if (this === view || (this as Element).localName?.startsWith('volume-'))
        events.push(
          `${event.type} ${JSON.stringify((event as CustomEvent).detail)} ${(event as CustomEvent).detail?.message ?? ''} ${String((event as CustomEvent).detail?.cause)}`,
        );
      return dispatchEvent.call(this, event);
    };
  });
  const broken = study.map((one, i) => (i === 1 ? { ...one, base64: one.base64.slice(0, -40) } : one));
  for (const given of [
    study,
    broken,
    [
      study[0],
      give(`${person}.nii`, new Uint8Array(dataFiles['ball.nii'])),
      give(`${person}-2.nii`, new Uint8Array(dataFiles['ball.nii'])),
    ],
    [give(`${person}.txt`, new Uint8Array(99))],
  ]) {
    await drop(target, given);
    await expect(status(target)).not.toHaveText('Reading …');
  }
  await drop(target, study);
  await expect(status(target)).toContainText('Files: 7.');
  // The warning, once.
  const left = await withElement(target, (view) =>
    view.volume!.left!.filter((text) => text.includes('BurnedInAnnotation')),
  );
  expect(left).toHaveLength(1);
  await target
    .getByRole('button', { name: /more|save|menu/i })
    .first()
    .click();
  const all = await target.evaluate(() => {
    const seen: string[] = [document.title];
    const visit = (root: Document | ShadowRoot | Element): void => {
      // The head has scripts of tests before this one.
      seen.push(root instanceof Document ? root.body.outerHTML : root.innerHTML);
      root.querySelectorAll('*').forEach((one) => one.shadowRoot && visit(one.shadowRoot));
    };
    visit(document);
    for (const element of document.querySelectorAll<HTMLElement>('volume-view, volume-drop, volume-readout')) {
      for (
        let at: object | null = element;
        at && at !== HTMLElement.prototype;
        at = Object.getPrototypeOf(at) as object | null
      ) {
        for (const [name, { get }] of Object.entries(Object.getOwnPropertyDescriptors(at))) {
          // The page itself gave the files, and has them.
          if (!get || ['files', 'renderComplete'].includes(name)) continue;
          try {
            seen.push(`${name} ${JSON.stringify(get.call(element))}`);
          } catch {
            seen.push(name);
          }
        }
      }
    }
    return [...seen, ...(window as unknown as { events: string[] }).events];
  });
  expect(all.length).toBeGreaterThan(100);
  for (const text of [...all, ...said]) expect(text).not.toMatch(secrets);
});
