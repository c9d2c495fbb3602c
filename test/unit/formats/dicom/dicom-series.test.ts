// Several series in one choice of files: what a page gets of them, and which one is shown.
import { expect } from '@esm-bundle/chai';
import { ctSlice } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields } from '../../../helpers/dicom-bytes.ts';
import { decodeSeries } from '../../../helpers/dicom-series.ts';
import { dicomBytes } from '../../../helpers/dicom-bytes.ts';
import { expectError } from '../../../helpers/decode.ts';

const slices = (count: number, fields: DicomFields): Uint8Array<ArrayBuffer>[] =>
  Array.from({ length: count }, (_, k) => dicomBytes(ctSlice(5 * k, fields, 100 * k)));
const mr = { Modality: 'MR', RescaleIntercept: undefined, RescaleSlope: undefined };
/** As a folder has them: by name, not by number. */
const study = [
  ...slices(3, { ...mr, SeriesInstanceUID: '1.2.9', SeriesNumber: '7', SeriesDescription: 'Geheim^Erna' }),
  ...slices(2, { SeriesInstanceUID: '1.2.3', SeriesNumber: '2' }),
  ...slices(1, { SeriesInstanceUID: '1.2.4', ImageType: 'ORIGINAL\\PRIMARY\\LOCALIZER', SeriesNumber: '1' }),
  ...slices(2, { ...mr, SeriesInstanceUID: '1.2.5' }),
];

describe('several series of DICOM', () => {
  it('are listed by the numbers of the scanner, those that only show places last', async () => {
    const { series, left } = await decodeSeries(study);
    const listed = series!.map(({ picture: _picture, ...rest }) => rest);
    const place = { plane: 'axial', spacing: [0.5, 0.75, 5] };
    expect(listed).to.deep.equal([
      { number: 1, shown: false, modality: 'CT', seriesNumber: 2, dimensions: [4, 3, 2], ...place },
      { number: 2, shown: true, modality: 'MR', seriesNumber: 7, dimensions: [4, 3, 3], ...place },
      { number: 3, shown: false, modality: 'MR', dimensions: [4, 3, 2], ...place },
      { number: 4, shown: false, modality: 'CT', seriesNumber: 1, dimensions: [4, 3, 1], ...place },
    ]);
    expect(left!.join()).to.contain('2 other series').and.to.contain('the one with the most voxels is shown');
    expect(JSON.stringify(series)).not.to.match(/geheim|1\.2\./i);
  });

  for (const [number, slicesOf, modality] of [
    [1, 2, 'CT'],
    [2, 3, 'MR'],
    [3, 2, 'MR'],
    [4, 1, 'CT'],
  ] as const) {
    it(`number ${number} is shown where it is wanted`, async () => {
      const { grid, format, series, left } = await decodeSeries(study, { series: number });
      expect(grid.dimensions).to.deep.equal([4, 3, slicesOf]);
      expect(format).to.equal(`DICOM, ${modality}`);
      expect(series!.filter(({ shown }) => shown).map((one) => one.number)).to.deep.equal([number]);
      expect(left!.join()).to.contain(`number ${number} is shown`);
    });
  }

  it('of one number differ in plane and spacing, and come in the order in which they were measured', async () => {
    const one = (uid: string, fields: DicomFields): Uint8Array<ArrayBuffer>[] =>
      slices(3, { ...mr, SeriesInstanceUID: uid, SeriesNumber: '4', ...fields });
    const axes = { coronal: [1, 0, 0, 0, 0, -1], sagittal: [0, 1, 0, 0, 0, -1], oblique: [1, 0, 0, 0, 0.8, -0.6] };
    const turned = Object.values(axes).flatMap((ImageOrientationPatient, i) =>
      Array.from({ length: 2 }, (_, k) =>
        dicomBytes(
          ctSlice(0, {
            ...mr,
            SeriesInstanceUID: `1.3.${i}`,
            SeriesNumber: '4',
            ImageOrientationPatient,
            ImagePositionPatient: [k, 2 * k, 0],
            AcquisitionTime: `11000${i}`,
          }),
        ),
      ),
    );
    const { series } = await decodeSeries([
      ...turned,
      ...one('1.2.2', { AcquisitionTime: '101500', PixelSpacing: [1, 1] }),
      ...one('1.2.1', { AcquisitionTime: '093000' }),
    ]);
    expect(series!.map(({ plane }) => plane)).to.deep.equal(['axial', 'axial', ...Object.keys(axes)]);
    expect(series![0].spacing).to.deep.equal([0.5, 0.75, 5]);
    expect(series![1].spacing).to.deep.equal([1, 1, 5]);
    expect(series![2].spacing![2]).to.be.closeTo(2, 1e-9);
    expect(series![3].spacing![2]).to.be.closeTo(1, 1e-9);
    expect(JSON.stringify(series)).not.to.match(/1\.[23]\.|101500|093000|11000/);
  });

  it('have the same numbers, whatever the order of the files', async () => {
    const sorted = (await decodeSeries(study)).series!;
    const turned = (await decodeSeries(study.map((_, i) => study[study.length - 1 - i]))).series!;
    expect(turned.map(({ seriesNumber }) => seriesNumber)).to.deep.equal(
      sorted.map(({ seriesNumber }) => seriesNumber),
    );
  });

  it('that are not there are refused in words', async () => {
    const error = await expectError(decodeSeries(study, { series: 5 }));
    expect(error.code).to.equal('attribute/invalid');
    expect(error.message).to.equal('series got "5"; expected a number from 1 to 4, as the files hold 4 series.');
    const one = await expectError(decodeSeries(study.slice(0, 3), { series: 2 }));
    expect(one.message).to.contain('expected 1, as the files hold one series');
  });

  it('are not listed where there is one', async () => {
    expect((await decodeSeries(study.slice(0, 3))).series).to.equal(undefined);
    expect((await decodeSeries(study.slice(0, 3), { series: 1 })).grid.dimensions).to.deep.equal([4, 3, 3]);
  });

  it('have a picture of the middle slice, in their window', async () => {
    const { picture } = (
      await decodeSeries([
        ...study,
        // Values 176 to 187 HU: white from 182.5 on, black up to 181.5.
        ...slices(3, { SeriesInstanceUID: '1.2.6', SeriesNumber: '1', WindowCenter: '-819', WindowWidth: '2' }),
      ])
    ).series![0];
    expect(picture).to.include({ width: 4, height: 3 });
    // The middle slice has the numbers 200 to 211, and -1024 is added.
    expect(picture!.aspect).to.be.closeTo((4 * 0.5) / (3 * 0.75), 1e-9);
    expect([...picture!.pixels]).to.deep.equal(
      Array.from({ length: 12 }, (_, i) => Math.min(255, Math.max(0, Math.round(255 * ((100 + i - 1024 + 820) / 2))))),
    );
  });

  it('of which one can not be decoded are listed without its picture', async () => {
    const cut = slices(1, { SeriesInstanceUID: '1.2.8', SeriesNumber: '9', Rows: [5] });
    const { series } = await decodeSeries([...study, ...cut]);
    expect(series!.find(({ seriesNumber }) => seriesNumber === 9)!.picture).to.equal(undefined);
  });

  it('have no number that may be another thing', async () => {
    const planted = slices(2, { SeriesInstanceUID: '1.2.8', SeriesNumber: '19010203' });
    expect(JSON.stringify((await decodeSeries([...study, ...planted])).series)).not.to.contain('1901');
  });
});
