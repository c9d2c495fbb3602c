// What an author writes between the tags of an element counts wherever it stands in it: editors of web pages wrap it in paragraphs and divisions, and put line breaks between.
import type { Page } from '@playwright/test';
import { compare, expect, open, takePicture, keptTest as test, withElement } from './helpers/harness.ts';
import type { Picture } from './helpers/pictures.ts';

const data = '/test/fixtures/nifti';

/** What stands in a view, and what it needs of the view to be seen. */
const children: Readonly<Record<string, { readonly inside: string; readonly view?: string }>> = {
  'volume-slice': { inside: '<volume-slice type="axial"></volume-slice>', view: 'opacity-factor="0"' },
  'volume-labels with a volume-label': {
    inside: `<volume-labels src="${data}/labels-cal0.nii"><volume-label value="1" color="#0f0"></volume-label></volume-labels>`,
  },
  'volume-layer': {
    inside: `<volume-layer src="${data}/conflict.nii" transfer-function="0 red 0, 200 red 60%"></volume-layer>`,
  },
  'an X3D shape': {
    inside:
      '<shape><appearance><material diffusecolor="0 0 0" emissivecolor="0 1 0"></material></appearance><box size="8 8 60"></box></shape>',
  },
  'an X3D ClipPlane': { inside: '<ClipPlane plane="1 0 0 0"></ClipPlane>' },
  'an X3D style': { inside: '<ProjectionVolumeStyle type="MAX"></ProjectionVolumeStyle>' },
};

/** As WordPress and other editors leave it. */
const wraps: Readonly<Record<string, (inside: string) => string>> = {
  'a paragraph': (inside) => `<p>${inside}</p>`,
  'paragraphs of its own children too': (inside) =>
    `<div>${inside.replaceAll('><volume-label ', '><p><volume-label ').replaceAll('</volume-label>', '</volume-label></p>')}</div>`,
  'divisions and line breaks': (inside) => `<br>\n<div class="wp-block"><div>\n${inside}<br></div></div>`,
};

const view = (inside: string, attributes = ''): string =>
  `<main><h1>A ramp</h1><volume-view src="${data}/conflict.nii" transfer-function="100 black 0, 240 white 40%" steps="40" camera-orbit="30deg 60deg auto" alt="A ramp" ${attributes}>${inside}</volume-view></main>`;

/** The picture once nothing more comes. */
async function pictureOf(page: Page): Promise<Picture> {
  await withElement(page, async (element) => {
    await Promise.all(
      [...element.querySelectorAll('*')]
        .filter(({ localName }) => localName.startsWith('volume-'))
        .map(({ localName }) => customElements.whenDefined(localName)),
    );
    await element.whenRendered();
    await new Promise(requestAnimationFrame);
    await element.whenRendered();
  });
  return takePicture(page);
}

for (const [name, { inside, view: attributes }] of Object.entries(children)) {
  test(`${name} is found in what wraps it, also when it comes and goes later`, async ({ page }) => {
    await open(page, view('', attributes));
    const bare = await pictureOf(page);
    await open(page, view(inside, attributes));
    const plain = await pictureOf(page);
    expect(compare(plain, bare).worst, 'it is seen').toBeGreaterThan(20);
    for (const [how, wrap] of Object.entries(wraps)) {
      await open(page, view(wrap(inside), attributes));
      expect(compare(await pictureOf(page), plain).worst, how).toBe(0);
      await withElement(page, (element) => element.replaceChildren());
      expect(compare(await pictureOf(page), bare).worst, `${how}, gone`).toBe(0);
      await withElement(page, (element, html) => element.insertAdjacentHTML('beforeend', html), {
        argument: wrap(inside),
      });
      expect(compare(await pictureOf(page), plain).worst, `${how}, come later`).toBe(0);
    }
  });
}

test.describe('what stands in nothing', () => {
  test.use({
    allowedLines: /^warning: <volume-(slice|label|labels)> got no (volume|<volume-view>|<volume-labels>) around it/,
  });

  test('says so, and once it is where it belongs it counts', async ({ page, lines }) => {
    await open(page, view('', 'opacity-factor="0"'));
    const bare = await pictureOf(page);
    const codes = await page.evaluate(async () => {
      const seen: string[] = [];
      for (const name of ['volume-labels', 'volume-slice', 'volume-label']) {
        const element = document.createElement(name);
        element.id = name;
        element.setAttribute('type', 'axial');
        element.addEventListener('error', (event) =>
          seen.push((event as unknown as CustomEvent<{ code: string }>).detail.code),
        );
        document.body.append(element);
        await customElements.whenDefined(name);
      }
      await new Promise(requestAnimationFrame);
      return seen;
    });
    expect(codes).toEqual(['attribute/invalid', 'attribute/invalid', 'attribute/invalid']);
    expect(lines.filter((line) => line.includes('around it'))).toHaveLength(3);
    await withElement(page, (element) => element.append(document.querySelector('#volume-slice')!));
    expect(compare(await pictureOf(page), bare).worst).toBeGreaterThan(20);
  });
});
