import { expect } from '@esm-bundle/chai';
import { openFiles } from '../../../src/sources/open-files.ts';
import type { OpenedFiles } from '../../../src/sources/open-files.ts';
import { expectError, fetchFixture } from '../../helpers/decode.ts';

const base = 'https://local-1.invalid/';
const archive = (path: string): string => `https://archive.invalid/${path}`;

async function openFixture(name: string, isStack = false): Promise<OpenedFiles> {
  return openFiles(
    { bytes: await fetchFixture(`zip/${name}.zip`), url: `https://example.test/${name}.zip`, contentType: '' },
    { isStack },
  );
}

const local = (files: readonly unknown[], isStack = false): Promise<OpenedFiles> =>
  openFiles({ base, files }, { isStack });
const fileOf = async (fixture: string, name = fixture.replace(/.*\//, '')): Promise<File> =>
  new File([await fetchFixture(fixture)], name);

describe('the volume of an archive', () => {
  for (const [name, path] of [
    ['one', 'study/scan.nii'],
    ['mac', 'sc%C3%A4n.nii'],
    ['detached', 'brain/scan.mhd'],
    ['manifest', 'data/scan.json'],
    ['sidecar', 'sub-01_T1w.nii.gz'],
    ['zip64', 'scan.nii'],
  ] as const) {
    it(`${name}.zip is ${path}`, async () => {
      expect(await openFixture(name))
        .to.include({ first: archive(path) })
        .and.not.to.have.property('files');
    });
  }

  it('of images is all of them with stack, by their numbers', async () => {
    const paths = ['slices/1.png', 'slices/2.png', 'slices/10.png'].map(archive);
    expect(await openFixture('slices', true)).to.deep.include({ first: paths[0], files: paths });
  });

  it('of DICOM is all files of it', async () => {
    const paths = ['1.dcm', '2.dcm'].map(archive);
    expect(await openFixture('dicom')).to.deep.include({ first: paths[0], files: paths });
  });

  for (const [name, code, words] of [
    ['two', 'format/unsupported', ['holds 2 volumes', 'first.nii, second.nii.gz', 'expected one volume']],
    ['slices', 'format/unsupported', ['holds 3 images', 'stack']],
    ['none', 'format/unknown', ['holds 2 files', 'none of a known type']],
    ['empty', 'format/unknown', ['holds no files']],
  ] as const) {
    it(`${name}.zip is refused in words`, async () => {
      const error = await expectError(openFixture(name));
      expect(error.code).to.equal(code);
      for (const part of [`ZIP archive ${name}.zip`, ...words]) expect(error.message).to.contain(part);
    });
  }

  it('reads its own files and data: URLs, and requests nothing from a network', async () => {
    const { first, read } = await openFixture('detached');
    expect([...(await read(new URL('scan.raw', first).href, {})).bytes]).to.deep.equal([0, 1, 2, 3, 4, 5, 6, 7]);
    expect([...(await read('data:,AB', {})).bytes]).to.deep.equal([65, 66]);
    const { code, message } = await expectError(read('https://example.test/private', {}));
    expect(code).to.equal('source/not-found');
    expect(message).to.contain('https://example.test/private').and.to.contain('detached.zip');
  });
});

describe('files that a person chose', () => {
  it('are one volume by its file', async () => {
    const { first, read } = await local([await fileOf('nifti/v1-le-i2.nii', 'Häuser 1.nii')]);
    expect(first).to.equal(`${base}H%C3%A4user%201.nii`);
    const reports: number[][] = [];
    const { bytes } = await read(first, { onProgress: (...report) => reports.push(report) });
    expect(bytes).to.deep.equal(await fetchFixture('nifti/v1-le-i2.nii'));
    expect(reports.at(-1)).to.deep.equal([bytes.length, bytes.length]);
  });

  it('are an archive', async () => {
    const { first, read } = await local([await fileOf('zip/one.zip')]);
    expect(first).to.equal(archive('study/scan.nii'));
    expect((await read(first, {})).bytes).to.deep.equal(await fetchFixture('nifti/v1-le-i2.nii'));
  });

  it('of an archive are refused without its name, which may be that of a patient', async () => {
    const { message } = await expectError(local([await fileOf('zip/none.zip', 'Doe_John.zip')]));
    expect(message).to.contain('the ZIP archive that was chosen holds 2 files').and.not.to.contain('Doe');
  });

  it('are a header and its data, in any order', async () => {
    const { first, read } = await local([await fileOf('metaimage/data.raw'), await fileOf('metaimage/detached.mhd')]);
    expect(first).to.equal(`${base}detached.mhd`);
    expect((await read(`${base}data.raw`, {})).bytes).to.deep.equal(await fetchFixture('metaimage/data.raw'));
    const { code, message } = await expectError(read(`${base}other.raw`, {}));
    expect(code).to.equal('source/not-found');
    expect(message).to.contain('other.raw').and.to.contain('choose it');
  });

  it('are a folder, with its paths', async () => {
    const png = await fileOf('mosaic/gray-3x2.png');
    const json = await fileOf('mosaic/gray-3x2.json', 'scan.json');
    Object.defineProperty(png, 'webkitRelativePath', { value: 'study/gray-3x2.png' });
    Object.defineProperty(json, 'webkitRelativePath', { value: 'study/scan.json' });
    expect((await local([png, json])).first).to.equal(`${base}study/scan.json`);
  });

  it('are refused where they hold several volumes, or are no files', async () => {
    const two = await expectError(local([await fileOf('nifti/v1-le-i2.nii'), await fileOf('nifti/v1-le-gz.nii.gz')]));
    expect(two.code).to.equal('format/unsupported');
    expect(two.message).to.contain('2 volumes').and.to.contain('v1-le-i2.nii');
    const none = await expectError(local([null]));
    expect(none.code).to.equal('attribute/invalid');
    expect(none.message).to.contain('FileList');
  });

  it('are refused where the disk no longer gives them', async () => {
    const file = await fileOf('nifti/v1-le-i2.nii');
    const gone = () =>
      new ReadableStream({ start: (controller) => controller.error(new DOMException('gone', 'NotReadableError')) });
    const { first, read } = await local([file]);
    Object.defineProperty(file, 'stream', { value: gone });
    const native = globalThis.Response;
    // A response reads a file of a real disk itself.
    globalThis.Response = class extends native {
      constructor(_?: BodyInit | null, options?: ResponseInit) {
        super(gone(), options);
      }
    };
    try {
      const { code, message } = await expectError(read(first, {}));
      expect(code).to.equal('source/not-found');
      expect(message).to.contain('can not be read from the disk');
    } finally {
      globalThis.Response = native;
    }
  });

  it('are refused where they are too large', async () => {
    const { first, read } = await local([await fileOf('nifti/v1-le-i2.nii')]);
    const { code, message } = await expectError(read(first, { maxBytes: 10 }));
    expect(code).to.equal('format/too-large');
    expect(message).to.contain('the chosen file').and.not.to.contain('v1-le');
  });
});
