// One volume of files that a person chose, as the studio keeps and exports it.
import { expect } from '@esm-bundle/chai';
import { decode } from 'fast-png';
import { prepareChosen } from '../../../src/prepare/prepare-chosen.ts';
import { ctSlice, dicomBytes, pixelFields } from '../../helpers/dicom-bytes.ts';
import { dicomHead, dicomSecret } from '../../helpers/dicom-head.ts';

const asFiles = (files: Readonly<Record<string, Uint8Array>>): File[] =>
  Object.entries(files).map(([path, bytes]) => new File([bytes as Uint8Array<ArrayBuffer>], path));

const first = { series: null, scan: 0 };

describe('a volume of chosen files', () => {
  it('DICOM becomes an image with its own numbers, without a name, a date or an identifier', async () => {
    const made = await prepareChosen(asFiles(dicomHead()), first);
    if ('message' in made) throw new Error(made.message);
    const { manifest, png, report } = made as typeof made & { manifest: Record<string, unknown> };
    expect(report).to.deep.include({ format: 'DICOM, CT', unit: 'HU', dimensions: [32, 32, 32], bits: 16 });
    expect(report.error).to.deep.equal({ max: 0, rms: 0 });
    expect(manifest).to.include({ slices: 32, slope: 1, intercept: -1024, unit: 'HU' });
    // Voxel (16, 16, 16) is soft tissue at 40 HU: its tile is the 17th.
    const image = decode(png);
    const columns = Number(String(manifest.mosaic).split('x')[0]);
    const at = (Math.floor(16 / columns) * 32 + 16) * image.width + (16 % columns) * 32 + 16;
    expect(image.data[at] - 1024).to.equal(40);
    const texts = JSON.stringify([manifest, report]) + Buffer.from(png).toString('latin1');
    expect(texts).to.not.match(new RegExp(`${dicomSecret}|1\\.2\\.840\\.99999|19870605`));
  });

  it('of several series it is the chosen one', async () => {
    const seriesOf = (uid: string, count: number): Record<string, Uint8Array> =>
      Object.fromEntries(
        Array.from({ length: count }, (_, k) => [
          `${uid}-${k}.dcm`,
          dicomBytes(ctSlice(5 * k, { SeriesInstanceUID: uid, SOPInstanceUID: `${uid}.${k}` })),
        ]),
      );
    const files = asFiles({ ...seriesOf('1.2.7', 5), ...seriesOf('1.2.8', 3) });
    for (const [series, slices] of [
      [null, 5],
      [1, 5],
      [2, 3],
    ] as const) {
      const made = await prepareChosen(files, { series, scan: 0 });
      expect('report' in made && made.report.dimensions).to.deep.equal([4, 3, slices]);
    }
  });

  it('colours become their brightness, and the report says so', async () => {
    const colored = {
      ...pixelFields(new Uint8Array(12)),
      SamplesPerPixel: [3],
      PhotometricInterpretation: 'RGB',
      PlanarConfiguration: [0],
      PixelData: Uint8Array.from({ length: 36 }, (_, at) => (at % 3 === 0 ? 200 : at)),
    };
    const made = await prepareChosen(asFiles({ 'a.dcm': dicomBytes(ctSlice(0, colored)) }), first);
    expect('report' in made && made.report.left).to.deep.equal([
      'the colours: a mosaic holds one number for each voxel, which is their brightness',
    ]);
  });

  it('what can not be read is said in words, without a name', async () => {
    for (const files of [
      asFiles({ [`${dicomSecret}.txt`]: new TextEncoder().encode('Dear Sir') }),
      asFiles({ [`${dicomSecret}.dcm`]: dicomBytes(ctSlice(0)).slice(0, 200) }),
      [],
    ]) {
      const made = await prepareChosen(files, first);
      expect('message' in made && made.message)
        .to.be.a('string')
        .and.not.include(dicomSecret);
    }
    const made = await prepareChosen(asFiles(dicomHead()), { series: 9, scan: 0 });
    expect('message' in made && made.message).to.match(/series/);
  });
});
