import { expect } from '@esm-bundle/chai';
import { deflateSync } from 'fflate';
import { MemoryStore } from '../../../src/sources/memory-store.ts';
import { isZip } from '../../../src/sources/is-zip.ts';
import { ZipStore } from '../../../src/sources/zip-store.ts';
import { expectError, fetchFixture } from '../../helpers/decode.ts';
import { zipBytes } from '../../helpers/zip-bytes.ts';
import type { ZipPart } from '../../helpers/zip-bytes.ts';

// Archives of test/fixtures/zip: by Info-ZIP's zip 3.0 and Python's zipfile, see make-zip-fixtures.py.

const base = 'https://archive.invalid/';

const openBytes = (bytes: Uint8Array<ArrayBuffer>): Promise<ZipStore> =>
  ZipStore.open(
    new MemoryStore({ bytes, url: 'https://example.test/a.zip', contentType: '' }),
    'https://example.test/a.zip',
    base,
    'a.zip',
  );
const openFixture = async (name: string): Promise<ZipStore> => openBytes(await fetchFixture(`zip/${name}.zip`));

describe('a ZIP archive', () => {
  for (const [name, path] of [
    ['one', 'study/scan.nii'],
    ['stored', 'scan.nii'],
    ['zip64', 'scan.nii'],
    ['described', 'scan.nii'],
    ['moved', 'scan.nii'],
    ['mac', 'sc%C3%A4n.nii'],
  ] as const) {
    it(`${name}.zip of another program holds the same bytes as the file`, async () => {
      const bytes = await fetchFixture(`zip/${name}.zip`);
      expect(isZip(bytes)).to.equal(name !== 'moved');
      const zip = await openBytes(bytes);
      const file = await zip.read(base + path);
      expect(file.bytes).to.deep.equal(await fetchFixture('nifti/v1-le-i2.nii'));
      expect(await zip.stat(base + path)).to.deep.equal({ size: file.bytes.length });
      expect(await zip.list()).to.include(base + path);
    });

    it(`${name}.zip gives any part of a file`, async () => {
      const zip = await openFixture(name);
      const whole = await fetchFixture('nifti/v1-le-i2.nii');
      for (const [start, end] of [
        [0, 4],
        [344, 400],
        [100, 10_000],
        [5000, 6000],
      ] as const) {
        expect((await zip.read(base + path, { range: { start, end } })).bytes).to.deep.equal(whole.slice(start, end));
      }
    });
  }

  it('lists files, not folders', async () => {
    expect(await (await openFixture('one')).list()).to.have.members([
      `${base}study/README.txt`,
      `${base}study/scan.nii`,
    ]);
    expect(await (await openFixture('empty')).list()).to.deep.equal([]);
  });

  it('says how many of its bytes a file takes, by which memory is limited', async () => {
    const { packedBytes, bytes } = await (await openFixture('one')).read(`${base}study/scan.nii`);
    expect(packedBytes).to.be.within(1, bytes.length - 1);
  });

  it('refuses files that are larger than a load may read, before it unpacks them', async () => {
    const { code, message } = await expectError(
      (await openFixture('one')).read(`${base}study/scan.nii`, { maxBytes: 100 }),
    );
    expect(code).to.equal('format/too-large');
    expect(message).to.contain('study/scan.nii in the ZIP archive a.zip').and.to.contain('at most 100');
  });

  it('does not lead out of itself', async () => {
    const zip = await openBytes(zipBytes([{ path: '../../etc/passwd', packed: new Uint8Array(3), crc: 0xff41d912 }]));
    expect(await zip.list()).to.deep.equal([`${base}etc/passwd`]);
    expect((await zip.read(`${base}etc/passwd`)).bytes.length).to.equal(3);
    expect((await expectError(zip.read(`${base}other`))).code).to.equal('source/not-found');
  });

  for (const [name, path, words] of [
    ['encrypted', 'scan.nii', 'is encrypted'],
    ['bzip2', 'scan.nii', 'is packed with bzip2'],
    ['lzma', 'scan.nii', 'is packed with LZMA'],
  ] as const) {
    it(`that ${words} is refused in words`, async () => {
      const zip = await openFixture(name);
      for (const range of [undefined, { start: 0, end: 4 }]) {
        const { code, message } = await expectError(zip.read(base + path, { range }));
        expect(code).to.equal('format/unsupported');
        expect(message).to.contain(words).and.to.contain('pack');
      }
    });
  }
});

describe('a damaged ZIP archive', () => {
  const plain: ZipPart = { path: 'a', packed: Uint8Array.from([1, 2, 3]), crc: 0x55bc801d };
  const deflated = (length: number): ZipPart => ({
    path: 'a',
    packed: deflateSync(new Uint8Array(length)),
    method: 8,
    size: length,
  });

  it('is distinguished from a sound one', async () => {
    expect((await (await openBytes(zipBytes([plain]))).read(`${base}a`)).bytes).to.deep.equal(plain.packed);
  });

  for (const [what, bytes, code, words] of [
    ['is cut short', zipBytes([plain]).slice(0, -8), 'format/corrupt', 'cut short'],
    [
      'has a list beyond its end',
      zipBytes([plain], { listOffset: 1e6 }),
      'format/corrupt',
      'list of files that does not lie in it',
    ],
    [
      'has a list that is too long',
      zipBytes([plain], { listBytes: 1e6 }),
      'format/corrupt',
      'list of files that does not lie in it',
    ],
    ['counts more files than its list has', zipBytes([plain], { count: 2 }), 'format/corrupt', 'list of files'],
    ['counts more files than there may be', zipBytes([plain], { count: 65_535 }), 'format/too-large', '65,535'],
    ['is one of several parts', zipBytes([plain], { disk: 1 }), 'format/unsupported', 'one part of several'],
    ['has a file beyond its list', zipBytes([{ ...plain, offset: 40 }]), 'format/corrupt', 'overlap'],
    ['lists a file twice', zipBytes([plain, { ...plain, path: 'b', offset: 0 }]), 'format/corrupt', 'overlap'],
    ['claims what deflate can not hold', zipBytes([{ ...deflated(10), size: 1e9 }]), 'format/corrupt', '1,000,000,000'],
    ['stores fewer bytes than it says', zipBytes([{ ...plain, size: 4 }]), 'format/corrupt', '3 bytes hold 4'],
    ['has no size', zipBytes([{ ...plain, size: 0xffffffff }]), 'format/corrupt', 'size is missing'],
  ] as const) {
    it(`that ${what} is refused`, async () => {
      const error = await expectError(openBytes(bytes));
      expect(error.code).to.equal(code);
      expect(error.message).to.contain(words).and.to.contain('a.zip');
    });
  }

  for (const [what, part] of [
    ['has other bytes', { ...plain, crc: 1 }],
    ['has more bytes than it says', { ...deflated(1000), size: 999, crc: 0x1 }],
    ['has fewer bytes than it says', { ...deflated(1000), size: 1001, crc: 0x1 }],
    ['is no deflate data', { path: 'a', packed: Uint8Array.from([7, 7, 7]), method: 8, size: 100 }],
  ] as const) {
    it(`with a file that ${what} is refused`, async () => {
      const { code, message } = await expectError((await openBytes(zipBytes([part]))).read(`${base}a`));
      expect(code).to.equal('format/corrupt');
      expect(message).to.contain('a in the ZIP archive a.zip');
    });
  }

  it('never gives another error, wherever one byte of it is changed', async () => {
    const sound = await fetchFixture('zip/two.zip');
    let refused = 0;
    for (let at = 0; at < sound.length; at++) {
      const bytes = sound.slice();
      bytes[at] ^= 0xff;
      const outcome = await readAll(bytes).catch((error: unknown) => error);
      if (outcome !== null) refused++;
      if (outcome instanceof Error)
        expect(outcome, `byte ${at}: ${String(outcome)}`)
          .to.have.property('code')
          .that.match(/^(format|source)\//);
    }
    expect(refused).to.be.greaterThan(sound.length / 4);
  });

  async function readAll(bytes: Uint8Array<ArrayBuffer>): Promise<null> {
    const zip = await openBytes(bytes);
    for (const url of await zip.list()) await zip.read(url);
    return null;
  }
});
