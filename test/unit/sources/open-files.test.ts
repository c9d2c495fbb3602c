import { expect } from '@esm-bundle/chai';
import { openFiles } from '../../../src/sources/open-files.ts';
import type { OpenedFiles } from '../../../src/sources/opened-files.ts';
import { LocalStore } from '../../../src/sources/local-store.ts';
import { PrivateStore } from '../../../src/sources/private-store.ts';
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

describe('a manifest among chosen files', () => {
  it('is the volume, whatever it names: an image, a video, files or scans', async () => {
    const named = { image: 'a.png', video: 'a.webm', files: ['a.dcm'], scans: [{ image: 'a.png' }] };
    for (const [name, value] of Object.entries(named)) {
      const manifest = new File([JSON.stringify({ title: 'x', [name]: value })], 'scan.json');
      const other = new File([new Uint8Array(40)], 'a.webm');
      const { first, files } = await local([manifest, other]);
      expect(new URL(first).pathname, name).to.match(/json$/);
      expect(files).to.equal(undefined);
    }
  });

  it('that is no JSON is still one by its name, and data that begin with a brace by chance are none', async () => {
    const data = await fetchFixture('metaimage/data.raw');
    data[0] = 0x7b;
    const chosen = [await fileOf('metaimage/detached.mhd'), new File([data], 'data.raw')];
    expect((await local(chosen)).first).to.match(/\.mhd$/);
    for (const name of ['scan.json', 'SCAN.JSON'])
      expect((await local([...chosen, new File(['{ "image": '], name)])).first, name).to.match(/\.json$/i);
  });

  it('is no JSON of another program, whether it is valid or not', async () => {
    const volume = await fileOf('nifti/v1-le-i2.nii', 'scan.nii');
    for (const text of [
      '{"EchoTime": 0.03, "SliceTiming": [0, 1.5]}',
      // Python 3.11: json.dumps({"EchoTime": math.nan, "SliceTiming": [math.inf, -math.inf]})
      '{"EchoTime": NaN, "SliceTiming": [Infinity, -Infinity]}',
      '{"EchoTime": NaN, "ImageType": ["ORIGINAL", "image"], "Comment": "files of a scan"}',
      '{"EchoTime": 0.03,\n',
      '{ EchoTime: 0.03 } // image',
      '',
      'null',
      '["image"]',
      '{"meta": {"files": [1]}}',
    ]) {
      const { first, files } = await local([volume, new File([text], 'scan.json')]);
      expect([new URL(first).pathname.slice(-4), files], text).to.deep.equal(['.nii', undefined]);
    }
  });
});

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
    expect(first).to.equal(`${base}file-1.nii`);
    const reports: number[][] = [];
    const { bytes } = await read(first, { onProgress: (...report) => reports.push(report) });
    expect(bytes).to.deep.equal(await fetchFixture('nifti/v1-le-i2.nii'));
    expect(reports.at(-1)).to.deep.equal([bytes.length, bytes.length]);
  });

  it('are an archive', async () => {
    const { first, read } = await local([await fileOf('zip/one.zip')]);
    expect(first).to.equal(archive('folder-1/file-2.nii'));
    expect((await read(first, {})).bytes).to.deep.equal(await fetchFixture('nifti/v1-le-i2.nii'));
  });

  it('of an archive are refused without its name, which may be that of a patient', async () => {
    const { message } = await expectError(local([await fileOf('zip/none.zip', 'Doe_John.zip')]));
    expect(message).to.contain('the ZIP archive that was chosen holds 2 files').and.not.to.contain('Doe');
  });

  it('are a header and its data, in any order', async () => {
    const { first, read } = await local([await fileOf('metaimage/data.raw'), await fileOf('metaimage/detached.mhd')]);
    expect(first).to.equal(`${base}file-2.mhd`);
    expect((await read(`${base}data.raw`, {})).bytes).to.deep.equal(await fetchFixture('metaimage/data.raw'));
    const { code, message } = await expectError(read(`${base}Doe_John.raw`, {}));
    expect(code).to.equal('source/not-found');
    expect(message).to.contain('.raw').and.to.contain('choose it').and.not.to.contain('Doe');
  });

  it('are a folder, with its paths', async () => {
    const png = await fileOf('mosaic/gray-3x2.png');
    const json = await fileOf('mosaic/gray-3x2.json', 'scan.json');
    Object.defineProperty(png, 'webkitRelativePath', { value: 'study/gray-3x2.png' });
    Object.defineProperty(json, 'webkitRelativePath', { value: 'study/scan.json' });
    expect((await local([png, json])).first).to.equal(`${base}folder-1/file-2.json`);
  });

  it('are refused where they are no files', async () => {
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
    Object.defineProperty(file, 'arrayBuffer', { value: () => new Response(gone()).arrayBuffer() });
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
      expect(message).to.contain('the chosen file can not be read: it was moved');
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

  it('are a folder by its handle, with all folders in it', async () => {
    const inner = folderOf('Doe_John', [await fileOf('metaimage/data.raw')]);
    const header = await fileOf('metaimage/detached.mhd', 'Doe.mhd');
    const moved = new File([(await header.text()).replace('data.raw', 'Doe_John/data.raw')], 'Doe.mhd');
    const { first, read } = await local([folderOf('study', [inner, moved])]);
    expect(first).to.equal(`${base}folder-1/file-2.mhd`);
    const data = await read(new URL('Doe_John/data.raw', first).href, {});
    expect(data.bytes).to.deep.equal(await fetchFixture('metaimage/data.raw'));
    expect(data.url).not.to.contain('folder-2'); // As it was asked for.
  });

  it('are refused where a folder can not be read', async () => {
    const gone = {
      kind: 'directory',
      name: 'Doe_John',
      values() {
        throw new DOMException('Doe_John', 'NotFoundError');
      },
    };
    const { code, message } = await expectError(local([gone]));
    expect(code).to.equal('source/not-found');
    expect(message).to.contain('the chosen folder').and.not.to.contain('Doe');
  });

  it('of one name in several folders are all there', async () => {
    const [a, b] = [await fileOf('zip/none.zip', 'a'), await fileOf('zip/none.zip', 'a')];
    const error = await expectError(local([a, b]));
    expect(error.message).to.contain('the choice of 2 files');
  });

  it('are found by a header that names folders which were not chosen, or another case', async () => {
    const { url } = await privately(folder(['h.mhd', 'Doe.raw', 'A/i.mhd', 'B/Roe.raw']));
    for (const path of ['data/Doe.raw', 'DOE.RAW', 'data/more/doe.RAW', 'folder-1/Doe.raw'])
      expect(await url(path), path).to.equal('Doe.raw');
    // The data of other headers are in other folders, and none of several is chosen.
    await expectError(url('folder-1/Roe.raw'));
    const { url: ofTwo } = await privately(folder(['h.mhd', 'Doe.raw', 'B/Doe.raw']));
    expect(await ofTwo('Doe.raw')).to.equal('Doe.raw');
    for (const path of ['data/Doe.raw', 'DOE.RAW']) await expectError(ofTwo(path));
  });

  it('that are called as messages call files are not mistaken', async () => {
    const [raw, header] = [await fileOf('metaimage/data.raw', 'file-2.raw'), await fileOf('metaimage/detached.mhd')];
    const named = new File([(await header.text()).replace('data.raw', 'file-2.raw')], 'b.mhd');
    const other = new File(['other'], 'a.raw');
    const { first, read } = await local([raw, named, other]);
    expect((await read(new URL('file-2.raw', first).href, {})).bytes).to.deep.equal(
      await fetchFixture('metaimage/data.raw'),
    );
  });

  it('are a pair of which each is found by the name of the other', async () => {
    const pair = ['Doe_John.HDR', 'Doe_John.IMG.gz'].map((name) => new File([name], name));
    const { list, url } = await privately(pair);
    expect(list).to.deep.equal(['file-1.HDR', 'file-1.IMG.gz'].map((name) => base + name));
    expect(await url('file-1.IMG.gz')).to.equal('Doe_John.IMG.gz');
  });
});

/** Files that hold their paths. */
const folder = (paths: readonly string[]): File[] =>
  paths.map((path) => {
    const file = new File([path], path.replace(/.*\//, ''));
    Object.defineProperty(file, 'webkitRelativePath', { value: path });
    return file;
  });

/** As a browser gives it. */
function folderOf(name: string, inside: readonly (File | object)[]): object {
  return {
    kind: 'directory',
    name,
    async *values() {
      for (const one of inside)
        yield one instanceof File ? { kind: 'file', name: one.name, getFile: async () => one } : one;
    },
  };
}

async function privately(
  files: readonly File[],
): Promise<{ list: readonly string[]; url(path: string): Promise<string> }> {
  const store = await PrivateStore.of(new LocalStore(files, base), base, () => false);
  return {
    list: await store.list(),
    url: async (path) => new TextDecoder().decode((await store.read(base + path)).bytes),
  };
}
