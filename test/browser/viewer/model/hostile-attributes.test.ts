// Texts of strangers in attributes: each is read, or refused in words, in a time that grows with its length.
import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { parseCssColor } from '../../../../src/optics/transfer/css-color.ts';
import { parseTransferFunction } from '../../../../src/optics/transfer/parse-transfer-function.ts';
import { readTransferFunction } from '../../../../src/optics/transfer/presets.ts';
import { readSettings } from '../../../../src/viewer/model/settings.ts';
import { readSource } from '../../../../src/viewer/loading/read-source.ts';
import type { GivenAttributes } from '../../../../src/viewer/model/settings.ts';
import { parseMosaicSize } from '../../../../src/volume/mosaic-size.ts';
import { readSlices } from '../../../../src/viewer/cuts/read-cuts.ts';
import * as kinds from '../../../../components/internal/property-kinds.ts';
import { noAttributes } from '../../../helpers/view-settings.ts';
import { cloudVolume } from '../../../helpers/polar-cloud.ts';

/** For a megabyte, ms: what grows with the square would take an hour, and a busy machine is not to fail it. */
const longest = 20_000;
const megabyte = 2 ** 20;

/** All that is read of one attribute. @returns what was wrong with it, if anything */
function read(name: keyof GivenAttributes, text: string): VolumeViewError | null {
  const settings = readSettings({ ...noAttributes, [name]: text });
  const { look: appearance, camera, quality, region, rings, time, playSpeed } = settings;
  const wrong = [appearance, camera, quality, region, rings, time, playSpeed].find(({ error }) => error)?.error ?? null;
  if (wrong || !settings.source) return wrong as VolumeViewError | null;
  try {
    readSource(settings.source);
    return null;
  } catch (error) {
    return error as VolumeViewError;
  }
}

const parts = [
  '1',
  ' ',
  '.',
  '1.',
  '-',
  'e1',
  '1 ',
  ',',
  '(',
  ')',
  '0 red 0,',
  'x',
  '\t1x',
  '%',
  '#',
  '9deg ',
  ' 1',
] as const;
const ends = ['', 'x', ' x', '!'] as const;

function within(what: string, run: () => void): void {
  const began = performance.now();
  run();
  expect(performance.now() - began, what).to.be.lessThan(longest);
}

describe('attributes of strangers', () => {
  const names = Object.keys(noAttributes) as (keyof GivenAttributes)[];

  for (const name of names) {
    it(`${name}: a megabyte is read, and not by the square`, () => {
      for (const [text, length] of [
        ['1', megabyte],
        ['1', 2 * megabyte],
        ['1', 4 * megabyte],
      ] as const) {
        within(`${length} of ${text}`, () => read(name, `${text.repeat(length)}x`));
      }
      for (const part of parts) {
        for (const end of ends) within(`${part} … ${end}`, () => read(name, part.repeat(2 ** 17 / part.length) + end));
      }
    });
  }

  it('transfer functions: a megabyte is refused, and not by the square', async () => {
    for (const text of ['1'.repeat(megabyte), `${'1'.repeat(megabyte)}x`]) {
      within('digits', () =>
        expect(() => parseTransferFunction(`${text} red 1`, [0, 1])).to.throw(VolumeViewError, /at most 131,072/),
      );
    }
    for (const part of parts) {
      for (const end of ends) {
        const text = part.repeat(2 ** 16 / part.length) + end;
        for (const one of [
          text,
          `0 red 0, ${text}`,
          `0 ${text} 0`,
          `0 rgb(${text}) 0`,
          `0 red ${text}`,
          `${text} red 0`,
        ]) {
          within(one.slice(0, 20), () =>
            expect(() => parseTransferFunction(one, [0, 1]), one.slice(0, 20)).to.throw(VolumeViewError),
          );
        }
      }
    }
    const began = performance.now();
    await readTransferFunction('a-'.repeat(megabyte), [0, 1]).catch(() => null);
    expect(performance.now() - began).to.be.lessThan(longest);
  });

  it('transfer functions say what is too long', () => {
    const messageOf = (text: string): string => {
      try {
        parseTransferFunction(text, [0, 1]);
        return '';
      } catch (error) {
        return (error as Error).message;
      }
    };
    expect(messageOf(`0 ${'a'.repeat(5000)} 1`))
      .to.contain('of 5,000 characters; expected at most 200')
      .and.have.length.below(400);
    expect(messageOf(`${'1'.repeat(201)} red 1`)).to.contain('of 201 characters');
    expect(messageOf(Array.from({ length: 1025 }, (_, i) => `${i} red 1`).join(','))).to.contain('1025 stops');
    expect(
      parseTransferFunction(
        Array.from({ length: 1024 }, (_, i) => `${i}.25 color(display-p3 0.1 0.2 0.3) 1`).join(','),
        [0, 1],
      ),
    ).to.have.length(1024);
  });

  it('colours that are as long as they may be are read at once', () => {
    for (const part of [...parts, 'rgb(', '1 1 1/', 'hsl(1 ', '0x', 'color('])
      within(part, () => parseCssColor(part.repeat(200 / part.length)));
  });

  it('the readers of properties and of mosaics take as little time', () => {
    for (const [name, kind] of Object.entries(kinds) as [string, { read?: (text: string) => unknown }][]) {
      for (const part of parts) within(`${name} ${part}`, () => kind.read?.(`${part.repeat(2 ** 17)}x`));
    }
    for (const part of [' ', '1', 'x', '1x', ' x ']) within(part, () => parseMosaicSize(`${part.repeat(megabyte)}!`));
  });

  it('say how long they are, and show the beginning alone', () => {
    const error = read('steps', 'x'.repeat(1e6))!;
    expect(error.message).to.contain('1000000 characters').and.have.length.below(200);
    expect(read('elevations', '1 '.repeat(50_000))!.message).to.contain('at most 65536 characters');
    expect(read('elevations', '1 '.repeat(4097))).to.be.instanceOf(VolumeViewError);
    expect(read('elevations', '1 '.repeat(4096))).to.equal(null);
    expect(read('moment', 'M'.repeat(201))!.message).to.contain('at most 200 characters');
  });

  it('give no number that a picture can not be drawn with', () => {
    const bad: [keyof GivenAttributes, string[]][] = [
      ['spacing', ['1e400 1 1', '1 1 1e300', '1e-300 1 1', '1 1 -1e13']],
      ['range', ['0 1e308', '1e308 1e308', '1e400 1', '-1e400 1', '1 1e400']],
      ['azimuth', ['1e308 1', '0 1e308', '1e400 1', '0 -1e400']],
      ['elevations', ['1e400', '0.5 1e308']],
      ['verticalExaggeration', ['1e400', '1e300', '1e-300']],
      ['clean', ['1e400', '-1e400', 'NaN']],
      ['valueWindow', ['0 1e400', '-1.7e308 1.7e308']],
      ['region', ['0 0 0 1 1 1e400']],
      ['cameraTarget', ['1e400 0 0', '0 0 1e300']],
      [
        'cameraOrbit',
        ['1e400deg 0deg 100%', '0deg 1e309rad 1', '0deg 0deg 1e400', '0deg 0deg 1e300%', '0deg 0deg 1e-300'],
      ],
      ['fieldOfView', ['1e400deg']],
      ['referenceLength', ['1e300', '1e-300']],
      ['opacityFactor', ['1e300']],
      ['lightFactor', ['1e300']],
      ['maxError', ['1e-300']],
      ['targetFps', ['1e300']],
    ];
    for (const [name, texts] of bad)
      for (const text of texts) expect(read(name, text), `${name} ${text}`).to.be.instanceOf(VolumeViewError);
  });
});

describe('slices of strangers', () => {
  it('lie where a radar can see', () => {
    const volume = cloudVolume(1);
    const host = document.createElement('volume-view');
    const texts = [
      'type="section" from="1e300 0" to="0 0"',
      'type="section" from="0 0" to="1e400 1"',
      'type="cappi" height="1e300"',
      'type="rhi" azimuth="1e300"',
      `type="cappi" height="${'1'.repeat(2 ** 18)}x"`,
    ];
    for (const text of texts) {
      host.innerHTML = `<volume-slice ${text}></volume-slice>`;
      const { slices, error } = readSlices(host, volume, null);
      expect(slices, text).to.have.length(0);
      expect(error?.code, text).to.equal('attribute/invalid');
    }
  });
});
