// X3D of strangers between the tags, as a content system may let it pass: nothing of it runs, loads or hides the volume.
import type { Page } from '@playwright/test';
import { countGreen, plain, shape } from './helpers/green-shape.ts';
import { expect, expectSamePicture, sharePage, takePicture, test, withElement } from './helpers/harness.ts';
import { drawReference } from './helpers/reference.ts';

const shared = sharePage(plain);

/** What the console says of it, all of which the test expects. */
const said: string[] = [];

/** Put X3D between the tags and wait for the picture. */
async function put(page: Page, children: string): Promise<void> {
  said.length = 0;
  const listen = (message: { text: () => string }): void => void said.push(message.text());
  page.on('console', listen);
  await withElement(
    page,
    async (element, html) => {
      const drawn = new Promise((resolve) => element.addEventListener('render', resolve, { once: true }));
      element.innerHTML = html;
      await Promise.race([drawn, new Promise((resolve) => setTimeout(resolve, 400))]);
      await element.whenRendered().catch(() => {});
    },
    { argument: children },
  );
  page.off('console', listen);
}

const box = '<box size="8 8 60"></box>';
const green = '<appearance><material diffusecolor="0 0 0" emissivecolor="0 1 0"></material></appearance>';
const twoInEachTwo =
  `<group def="g0"><shape>${green}<box size="1 1 1"></box></shape></group>` +
  Array.from(
    { length: 30 },
    (_, i) => `<group def="g${i + 1}"><group use="g${i}"></group><group use="g${i}"></group></group>`,
  ).join('');
const quiet = /left out of the picture/;

test.use({ allowedLines: quiet });

test.afterEach(async () => {
  await put(shared(), '');
});

test.describe('X3D that would run something', () => {
  const clock = (attributes: string): string =>
    `<timesensor def="clock" cycleinterval="0.05" loop="true" ${attributes}></timesensor>`;
  for (const [name, html] of [
    ['an attribute onoutputchange', clock('onoutputchange="window.ran = 1"')],
    ['an attribute onoutputchange within a group', `<group>${clock('onoutputchange="window.ran = 1"')}</group>`],
    ['an attribute of another case', clock('onOutputChange="window.ran = 1"')],
    ['a scene of another file', '<inline url="/evil.x3d" load="true" onerror="window.ran = 1"></inline>'],
    ['an anchor', '<anchor url="/evil.html"></anchor>'],
    [
      'a prototype of another file',
      '<group><externprotodeclare name="P" url="/evil.x3d"></externprotodeclare><protoinstance name="P"></protoinstance></group>',
    ],
    [
      'a shader of another file',
      `<shape><appearance><composedshader><shaderpart type="fragment" url="/evil.glsl"></shaderpart></composedshader></appearance>${box}</shape>`,
    ],
    [
      'a film whose list is a script',
      `<shape><appearance><movietexture url="/evil.mpd"></movietexture></appearance>${box}</shape>`,
    ],
    [
      'data of another file',
      `<shape>${green}<binarygeometry coord="/evil.bin" vertexcount="3"></binarygeometry></shape>`,
    ],
    [
      'a buffer of an interpolator',
      '<positioninterpolator buffer="/evil.bin" key="0 1" keyvalue="0 0 0 1 1 1"></positioninterpolator>',
    ],
    ['a socket', '<remoteselectiongroup url="ws://127.0.0.1/evil"></remoteselectiongroup>'],
    ['a sound', '<sound><audioclip url="/evil.mp3" enabled="true"></audioclip></sound>'],
    [
      'the URL of a script',
      `<shape><appearance><imagetexture url="javascript:window.ran=1"></imagetexture></appearance>${box}</shape>`,
    ],
    [
      'a page of its own as a picture',
      `<shape><appearance><imagetexture url="data:text/html,evil"></imagetexture></appearance>${box}</shape>`,
    ],
    [
      'a blob',
      `<shape><appearance><imagetexture url="blob:http://127.0.0.1/evil"></imagetexture></appearance>${box}</shape>`,
    ],
  ] as const) {
    test(`${name} does not, and the console says so`, async () => {
      const page = shared();
      const asked: string[] = [];
      const listen = (request: { url: () => string }): void => void asked.push(request.url());
      page.on('request', listen);
      await put(page, html);
      await page.waitForTimeout(150);
      page.off('request', listen);
      expect(
        asked.filter((url) => url.includes('evil')),
        'requests',
      ).toEqual([]);
      expect(
        await page.evaluate(() => [
          (window as { ran?: number }).ran ?? null,
          document.querySelectorAll('body > audio, #AdditionalDashVideoScript').length,
        ]),
      ).toEqual([null, 0]);
      expect(said.filter((line) => quiet.test(line)).length, 'warnings').toBeGreaterThan(0);
    });
  }

  test('a picture on the server is loaded', async () => {
    const page = shared();
    const asked = page.waitForRequest(/field\.png/);
    await put(
      page,
      `<shape><appearance><imagetexture url='"/test/e2e/pages/data/field.png"'></imagetexture></appearance>${box}</shape>`,
    );
    await asked;
    expect(said).toEqual([]);
  });
});

test.describe('X3D that makes no sense', () => {
  for (const [name, html] of [
    ['a use of what is around it', '<group def="a"><group use="a"></group></group>'],
    ['a use of itself by its id', '<group id="a"><transform><group use="a"></group></transform></group>'],
    [
      'names of the language itself',
      '<group use="constructor"></group><group def="__proto__"><group use="__proto__"></group></group>',
    ],
    [
      'a route to nowhere',
      `<timesensor def="t" loop="true"></timesensor><route fromnode="t" fromfield="constructor" tonode="t" tofield="__proto__"></route>`,
    ],
    [
      'a shader with a mistake',
      `<shape><appearance><composedshader><shaderpart type="VERTEX">x</shaderpart><shaderpart type="FRAGMENT">y</shaderpart></composedshader></appearance>${box}</shape>`,
    ],
    ['a scale that is not finite', `<transform scale="1e400 1 1"><shape>${green}${box}</shape></transform>`],
    [
      'numbers that are none',
      `<transform translation="a b c"><shape>${green}<sphere radius="large"></sphere></shape></transform>`,
    ],
    [
      'scales that become infinite together',
      `${'<transform scale="1e17 1e17 1e17">'.repeat(20)}<shape>${green}${box}</shape>${'</transform>'.repeat(20)}`,
    ],
    ['a viewpoint from nowhere', '<viewpoint position="1e300 0 0"></viewpoint>'],
    [
      'a point that is too far for a GPU',
      `<shape>${green}<indexedfaceset coordindex="0 1 2 -1"><coordinate point="0 0 0, 1 0 0, 0 1e39 0"></coordinate></indexedfaceset></shape>`,
    ],
    [
      'a point that is nowhere',
      `<shape>${green}<indexedfaceset solid="false" coordindex="0 1 2 -1"><coordinate point="0 0 0, 1 0 0, 0 -1e400 0"></coordinate></indexedfaceset></shape>`,
    ],
    [
      'indices without points',
      `<shape>${green}<indexedfaceset coordindex="0 1 2 -1 7 99999999 1 -1"></indexedfaceset></shape>`,
    ],
    [
      'points that are too few',
      `<shape>${green}<indexedfaceset coordindex="0 1 2 -1 7 99999999 1 -1"><coordinate point="0 0"></coordinate></indexedfaceset></shape>`,
    ],
    [
      'a picture of pixels that lacks them',
      `<shape><appearance><pixeltexture image="3 3 4"></pixeltexture></appearance>${box}</shape>`,
    ],
    [
      'a picture of too many pixels',
      `<shape><appearance><pixeltexture image="99999 99999 4 1"></pixeltexture></appearance>${box}</shape>`,
    ],
    ['a surface of too many parts', `<shape>${green}<sphere subdivision="100000 100000"></sphere></shape>`],
    ['lights without number', '<pointlight></pointlight>'.repeat(150)],
    ['two in each two, thirty times', twoInEachTwo],
    ['a thousand within each other', `${'<group>'.repeat(1000)}${'</group>'.repeat(1000)}`],
    ['a node where it has no place', '<material></material><box></box><coordinate point="1 2 3"></coordinate>'],
    ['an x3d and a scene', `<x3d><scene><shape>${green}${box}</shape></scene></x3d>`],
    [
      'keys without values',
      `<timesensor def="c" loop="true"></timesensor><transform def="m"></transform><positioninterpolator def="p" key="0 1"></positioninterpolator><route fromnode="c" fromfield="fraction_changed" tonode="p" tofield="set_fraction"></route><route fromnode="p" fromfield="value_changed" tonode="m" tofield="set_translation"></route>`,
    ],
  ] as const) {
    test(`${name}: the volume and the other shapes stay`, async () => {
      const page = shared();
      await put(page, html + shape('0 1 0'));
      expect(
        await withElement(page, (element) => element.shadowRoot!.querySelector('.error')?.textContent ?? null),
        'no error',
      ).toBe(null);
      const picture = await takePicture(page);
      expect(
        picture.data.some((x, i) => i % 4 === 0 && x > 20),
        'the volume',
      ).toBe(true);
      expect(countGreen(picture), 'the other shape').toBeGreaterThan(40);
      await put(page, '');
      expectSamePicture(await takePicture(page), drawReference());
    });
  }

  test('the console says which attribute of which element holds a number that can not be drawn', async () => {
    const page = shared();
    const reported = (): string[] => said.filter((line) => quiet.test(line));
    const points =
      '<indexedfaceset coordindex="0 1 2 -1"><coordinate point="0 0 0, 1 0 0, 0 -1e39 0"></coordinate></indexedfaceset>';
    for (const [html, line] of [
      [
        '<transform id="far" translation="0 1e400 0"></transform>',
        '<transform> (id "far") was left out of the picture: translation of <transform> got "1e400"',
      ],
      [
        `<group><shape>${green}<sphere radius="large"></sphere></shape></group>`,
        '<group> was left out of the picture: radius of <sphere> got "large"',
      ],
      [`<shape>${green}${points}</shape>`, '<shape> was left out of the picture: point of <coordinate> got "-1e39"'],
      [
        '<viewpoint position="1e300 0 0"></viewpoint>',
        '<viewpoint> was left out of the picture: position of <viewpoint> got "1e300"',
      ],
    ] as const) {
      await put(page, html);
      expect(reported()).toEqual([`<volume-view>: ${line}; expected numbers up to 1e18.`]);
    }
    await put(page, `<group><shape>${green}<sphere radius="2"></sphere></shape></group>`);
    expect(reported()).toEqual([]);
    const later = page.waitForEvent('console', { predicate: (message) => quiet.test(message.text()) });
    await withElement(page, (element) => element.querySelector('sphere')!.setAttribute('radius', 'NaN'));
    expect((await later).text()).toBe(
      '<volume-view>: <sphere> was left out of the picture: radius of <sphere> got "NaN"; expected numbers up to 1e18.',
    );
  });

  test('what is put right is there', async () => {
    const page = shared();
    await put(page, shape('0 1 0').replace('<transform', '<transform scale="1 1 1e300"'));
    expect(said.some((line) => quiet.test(line))).toBe(true);
    expect(countGreen(await takePicture(page))).toBe(0);
    await withElement(page, (element) => element.querySelector('transform')!.setAttribute('scale', '1 1 1'));
    await expect.poll(async () => countGreen(await takePicture(page))).toBeGreaterThan(40);
    await withElement(page, (element) => element.querySelector('transform')!.removeAttribute('scale'));
    expect(countGreen(await takePicture(page))).toBeGreaterThan(40);
  });
});

test("the author's elements stay as they were written", async () => {
  const page = shared();
  const html = `${shape('0 1 0')}<timesensor def="t" loop="true" onclick="1"></timesensor>`;
  await put(page, html);
  expect(countGreen(await takePicture(page))).toBeGreaterThan(40);
  expect(
    await withElement(page, (element) => [
      element.innerHTML,
      [...element.querySelectorAll('*')].flatMap((one) => Object.keys(one)),
    ]),
  ).toEqual([html, []]);
});
