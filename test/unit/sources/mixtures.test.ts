// Several volumes in one choice of files, or in an archive: all are listed, one is shown, and what is not read is said.
import { expect } from '@esm-bundle/chai';
import { zipSync } from 'fflate';
import { Budget } from '../../../src/formats/base/budget.ts';
import type { SourceSettings } from '../../../src/formats/base/source-settings.ts';
import type { SeriesInfo, Volume } from '../../../src/volume/volume.ts';
import { decodeRequest } from '../../../src/worker/decode-request.ts';
import { expectError, fetchFixture, roomyLimits } from '../../helpers/decode.ts';
import { ctSlice, dicomBytes } from '../../helpers/dicom-bytes.ts';
import type { DicomFields } from '../../helpers/dicom-bytes.ts';
import { regions, structureSetFields } from '../../helpers/dicom-contours.ts';
import { overlapping, segmentationFields } from '../../helpers/dicom-segmentation.ts';
import { pageOrigin, withServer } from '../../helpers/fake-fetch.ts';
import { buildLevel3, builtProducts } from '../../helpers/level3-builder.ts';
import { niftiBytes } from '../../helpers/nifti-bytes.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';
import { grayPage, tiffBytes } from '../../helpers/tiff-bytes.ts';
import { pyramidFiles } from '../../helpers/zarr-bytes.ts';

const base = 'https://local-5.invalid/';
const environment = { pageOrigin, onProgress: () => undefined };

/** Files of a folder by their paths. */
type Files = Readonly<Record<string, Uint8Array<ArrayBuffer>>>;

async function open(files: Files, settings: SourceSettings = {}): Promise<Volume> {
  const given = Object.entries(files).map(([path, bytes]) => {
    const file = new File([bytes], path.replace(/.*\//, ''));
    Object.defineProperty(file, 'webkitRelativePath', { value: `Doe_John/${path}` });
    return file;
  });
  return decodeRequest({ url: base, local: { base, files: given }, limits: roomyLimits, settings }, environment);
}

const openArchive = (files: Files, settings: SourceSettings = {}): Promise<Volume> =>
  withServer([{ pieces: [zipSync(files)] }], () =>
    decodeRequest({ url: `${pageOrigin}/a.zip`, limits: roomyLimits, settings }, environment),
  );

const under = (folder: string, files: Files): Files =>
  Object.fromEntries(Object.entries(files).map(([path, bytes]) => [`${folder}/${path}`, bytes]));
const slices = (count: number, fields: DicomFields = {}): Files =>
  Object.fromEntries(
    Array.from({ length: count }, (_, k) => [`${k}.dcm`, dicomBytes(ctSlice(5 * k, fields, 100 * k))]),
  );
const page = (k: number): Uint8Array<ArrayBuffer> =>
  tiffBytes([
    grayPage(
      4,
      3,
      Uint8Array.from({ length: 12 }, (_, i) => i + k),
    ),
  ]);

const nifti = { 'a.nii': await fetchFixture('nifti/v1-le-i2.nii') };
const packed = { 'b.nii.gz': await fetchFixture('nifti/v1-le-gz.nii.gz') };
const nrrd = { 'c.nrrd': await fetchFixture('nrrd/i4-little.nrrd') };
const detached = {
  'detached.mhd': await fetchFixture('metaimage/detached.mhd'),
  'data.raw': await fetchFixture('metaimage/data.raw'),
};
const radar = { 'storm.ar2v': await fetchFixture('nexrad/message-31-plain.ar2v') };
const image = { 'view.png': await fetchFixture('mosaic/gray-3x2.png') };
const zarr = under('cells.zarr', Object.fromEntries(pyramidFiles({ shape: [4, 5, 6] })));
const smallZarr = under('few.zarr', Object.fromEntries(pyramidFiles({ shape: [3, 3, 3] })));
const larger = { 'large.nii': niftiBytes(syntheticVolume({ dimensions: [20, 20, 20], kind: 'uint8' })) };
const tilts = Object.fromEntries(
  [5, 15].map((elevation) => [`N${elevation}R`, buildLevel3({ ...builtProducts.reflectivity94, elevation })]),
);
const contours = { 'contours.dcm': dicomBytes(structureSetFields(regions)) };
const report = { 'report.dcm': dicomBytes({ SOPClassUID: '1.2.840.10008.5.1.4.1.1.88.11', Modality: 'SR' }) };
const list = { DICOMDIR: dicomBytes({ OffsetOfTheFirstDirectoryRecordOfTheRootDirectoryEntity: [398] }) };
const text = { 'notes.txt': new TextEncoder().encode('nothing of a volume') };
const segmentation = { 'seg.dcm': dicomBytes(segmentationFields(overlapping)) };
const vtk = { 'old.vtk': new TextEncoder().encode('# vtk DataFile Version 3.0\nx\nASCII\n') };

/** What is said of a series. */
const sayOf = ({ number, shown, format, modality, dimensions, files, bytes }: SeriesInfo): string =>
  [
    `${number}${shown ? '*' : ''}`,
    format ?? '',
    modality,
    dimensions?.join('x') ?? '',
    files === undefined ? '' : `${files} in ${bytes}`,
  ]
    .filter(Boolean)
    .join(' ');

/** What is left out, wherever a volume says it. */
const leftOf = ({ radar, left = [] }: Volume): readonly string[] => radar?.left ?? left;

const niftiRow = '1 NIfTI 1 in 472';
const shownNifti = 'NIfTI-1 3x4x5';
const mixtures: Readonly<Record<string, Mixture>> = {
  'a series and a NIfTI': {
    files: { ...nifti, ...slices(3) },
    listed: [niftiRow, '2* CT 4x3x3'],
    shown: [shownNifti, 'DICOM, CT 4x3x3'],
    left: [/another volume in the files \(NIfTI\): the largest one is shown/],
  },
  'two series and a NIfTI that is larger': {
    files: {
      ...larger,
      ...under('A', slices(3, { SeriesNumber: '1' })),
      ...under('B', slices(2, { SeriesInstanceUID: '7', SeriesNumber: '2' })),
    },
    listed: ['1* NIfTI 20x20x20', '2 DICOM 5 in 2522'],
    shown: ['NIfTI-1 20x20x20', 'DICOM, CT 4x3x3', 'DICOM, CT 4x3x2'],
    left: [/another volume in the files \(DICOM of 5 files\): the largest/],
  },
  'two NIfTI, one of them packed': {
    files: { ...nifti, ...packed },
    listed: ['1* NIfTI 3x4x5', '2 NIfTI 1 in 195'],
    shown: [shownNifti, shownNifti],
    left: [/another volume in the files \(NIfTI\)/],
  },
  'NIfTI, NRRD and a header with its data': {
    files: { ...nifti, ...nrrd, ...detached },
    listed: ['1* NIfTI 3x4x5', '2 NRRD 1 in 311', '3 MetaImage 1 in 415'],
    shown: [shownNifti, 'NRRD 3x2x4', 'MetaImage 3x2x4'],
    left: [/2 other volumes in the files \(NRRD, MetaImage\)/],
  },
  'pages of TIFF and a NIfTI': {
    files: { ...nifti, '1.tif': page(1), '2.tif': page(2) },
    listed: ['1* NIfTI 3x4x5', '2 TIFF 2 in 244'],
    shown: [shownNifti, 'TIFF 4x3x2'],
    left: [/another volume in the files \(TIFF of 2 files\)/],
  },
  'an OME-Zarr, a series, a NIfTI and an image': {
    files: { ...zarr, ...nifti, ...slices(3), ...image },
    listed: ['1 OME-Zarr 7 in 1016', '2 NIfTI 1 in 472', '3* CT 4x3x3'],
    shown: ['OME-Zarr 0.4 6x5x4', shownNifti, 'DICOM, CT 4x3x3'],
    left: [/2 other volumes/, /^an image in the other files$/],
  },
  'two OME-Zarr': {
    files: { ...zarr, ...smallZarr },
    listed: ['1* OME-Zarr 6x5x4', '2 OME-Zarr 4 in 558'],
    shown: ['OME-Zarr 0.4 6x5x4', 'OME-Zarr 0.4 3x3x3'],
    left: [/another volume/],
  },
  'a radar scan and a NIfTI': {
    files: { ...radar, ...nifti },
    listed: [niftiRow, '2* NEXRAD Level II'],
    shown: [shownNifti, 'NEXRAD Level II'],
    left: [/another volume in the files \(NIfTI\)/],
  },
  'two radar scans': {
    files: { ...radar, 'later.ar2v': radar['storm.ar2v'] },
    listed: ['1* NEXRAD Level II', '2 NEXRAD Level II 1 in 44120'],
    shown: ['NEXRAD Level II', 'NEXRAD Level II'],
    left: [/another volume in the files \(NEXRAD Level II\)/],
  },
  'a series, and sweeps of another format of which each is a file': {
    files: { ...tilts, ...slices(3) },
    listed: ['1 NEXRAD Level III 2 in 456', '2* CT 4x3x3'],
    shown: ['NEXRAD Level III, product 94', 'DICOM, CT 4x3x3'],
    left: [/another volume in the files \(NEXRAD Level III of 2 files\)/],
  },
  'a series with its segmentation and contours, a report and the list of a disk': {
    files: { ...slices(3), ...segmentation, ...contours, ...report, ...list },
    listed: [],
    shown: ['DICOM, CT 4x3x3'],
    left: [/^1 file of 7: .* contours/, /^1 file of 7: .* segmentation/, /^1 file of 7 without a picture/],
  },
  'a volume beside images and a file that is not read': {
    files: { ...nifti, ...image, ...vtk },
    listed: [],
    shown: [shownNifti],
    left: [/^an image in the other files$/, /^another file, which is a VTK file: .*convert it/],
  },
  'an OME-Zarr and text': { files: { ...zarr, ...text }, listed: [], shown: ['OME-Zarr 0.4 6x5x4'], left: [] },
};

interface Mixture {
  readonly files: Files;
  /** Of all volumes, each as it is listed first; the star has the one that is shown. */
  readonly listed: readonly string[];
  /** Format and size of the volume of each number. */
  readonly shown: readonly string[];
  readonly left: readonly RegExp[];
}

const showOf = ({ format, grid }: Volume): string =>
  grid.kind === 'polar' ? format : `${format} ${grid.dimensions.join('x')}`;

describe('several volumes in one choice of files', () => {
  for (const [what, { files, listed, shown, left }] of Object.entries(mixtures)) {
    for (const [where, read] of [
      ['', open],
      [', in an archive', openArchive],
    ] as const) {
      it(`${what}${where}: all are listed, and what is not shown is said`, async () => {
        const volume = await read(files);
        expect(volume.series?.map(sayOf) ?? []).to.deep.equal(listed);
        const words = leftOf(volume);
        expect(words, words.join('\n')).to.have.length(left.length);
        for (const [i, pattern] of left.entries()) expect(words[i]).to.match(pattern);
        expect(JSON.stringify([volume.series, words])).not.to.match(/Doe|\.dcm|\.nii|\.ar2v/);
      });
    }

    it(`${what}: the attribute series has the number of each`, async () => {
      for (const [i, one] of shown.entries()) {
        const volume = await open(files, { series: i + 1 });
        expect(showOf(volume)).to.equal(one);
        expect(volume.series?.find((row) => row.shown)?.number).to.equal(listed.length > 0 ? i + 1 : undefined);
      }
    });
  }

  it('are one where a file is the data of a header, packed with bzip2 under any name', async () => {
    const whole = await fetchFixture('nrrd/bzip2.nrrd');
    const start = new TextDecoder('latin1').decode(whole).indexOf('\n\n') + 2;
    const head = new TextDecoder().decode(whole.slice(0, start - 1));
    for (const name of ['a.raw', 'a.dat', 'a.raw.bz2']) {
      const header = new TextEncoder().encode(`${head}data file: ${name}\n`);
      const volume = await open({ 'a.nhdr': header, [name]: whole.slice(start) });
      expect(volume, name).to.include({ format: 'NRRD' });
      expect([volume.left, volume.series], name).to.deep.equal([undefined, undefined]);
    }
  });

  it('are refused by a number that none of them has', async () => {
    const two = await expectError(open({ ...nifti, ...nrrd }, { series: 3 }));
    expect(two.code).to.equal('attribute/invalid');
    expect(two.message).to.contain('a number from 1 to 2');
    const series = await expectError(open({ ...nifti, ...slices(3) }, { series: 3 }));
    expect(series.message).to.contain('a number from 1 to 2, as the files hold 2 volumes');
  });

  it('in one archive of the same files have the samples of each alone', async () => {
    const mixed = await openArchive({ ...nifti, ...slices(3) }, { series: 2 });
    expect(mixed.samples).to.deep.equal((await open(slices(3))).samples);
    expect((await openArchive({ ...nifti, ...slices(3) }, { series: 1 })).samples).to.deep.equal(
      (await open(nifti)).samples,
    );
  });
});

describe('an archive in a folder or an archive', () => {
  const study = slices(4);
  for (const [what, files] of [
    ['in a folder', { 'images.zip': zipSync(study), 'read me.txt': text['notes.txt'] }],
    [
      'of which one has all files twice packed',
      { 'a/outer.zip': zipSync({ 'inner.zip': zipSync(study, { level: 9 }) }) },
    ],
  ] as const) {
    it(`${what} is a folder of its files`, async () => {
      for (const read of [open, openArchive]) {
        if (read === openArchive && what !== 'in a folder') continue; // That would be three archives in each other.
        const { format, samples, source } = await read(files);
        expect(format).to.equal('DICOM, CT');
        expect(samples).to.deep.equal((await open(study)).samples);
        expect(source!.count).to.be.greaterThan(3);
      }
    });
  }

  it('is one of several volumes', async () => {
    const { series, format } = await open({ ...nifti, 'images.zip': zipSync(study), 'cells.ozx': zipSync(zarr) });
    expect(format).to.equal('DICOM, CT');
    expect(series!.map(sayOf)).to.deep.equal(['1 OME-Zarr 7 in 1016', niftiRow.replace('1', '2'), '3* CT 4x3x4']);
  });

  it('of the same file names is not mixed up with another', async () => {
    const later = slices(3, { SeriesInstanceUID: '9.9', SeriesNumber: '5', Modality: 'MR' });
    const { series } = await open({ 'a.zip': zipSync(study), 'b.zip': zipSync(later) });
    expect(series!.map(sayOf)).to.deep.equal(['1 MR 4x3x3', '2* CT 4x3x4']);
  });

  it('that can not be read is said, and the others are shown', async () => {
    for (const bytes of [
      await fetchFixture('zip/encrypted.zip'),
      await fetchFixture('zip/lzma.zip'),
      zipSync(study).slice(0, 900),
    ]) {
      const volume = await open({ ...nifti, 'Doe_John.zip': bytes });
      expect(showOf(volume)).to.equal(shownNifti);
      expect(leftOf(volume).join())
        .to.match(/a zip archive: .*unpack it/)
        .and.not.to.match(/Doe/);
    }
  });

  it('deeper than two is said', async () => {
    const deep = zipSync({ 'b.zip': zipSync({ 'c.zip': zipSync(study) }) });
    const error = await expectError(open({ 'a.zip': deep, ...text }));
    expect(error.code).to.equal('format/unsupported');
    expect(error.message).to.contain('a zip archive').and.to.contain('unpack it');
  });

  it('may not unpack to more than the device holds', async () => {
    const large = zipSync({ 'a.bin': new Uint8Array(2 ** 24) }, { level: 0 });
    const files = [new File([zipSync({ ...nifti, 'large.zip': large })], 'a.zip')];
    const load = (bytes: number): Promise<Volume> =>
      decodeRequest(
        { url: base, local: { base, files }, limits: roomyLimits },
        { ...environment, budget: new Budget(bytes) },
      );
    expect(leftOf(await load(2 ** 25)).join()).to.contain('a zip archive');
    expect(leftOf(await load(2 ** 28))).to.deep.equal([]);
  });
});
