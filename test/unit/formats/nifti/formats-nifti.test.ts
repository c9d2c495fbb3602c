import { rgbOf } from '../../../helpers/channels.ts';
import { expect } from '@esm-bundle/chai';
import { unzlibSync } from 'fflate';
import { windowFromHistogram } from '../../../../src/optics/transfer/window.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { decodeBytes, expectError, fetchFixture, valuesOf } from '../../../helpers/decode.ts';
import { compareValues, readExpected } from '../../../helpers/expected-file.ts';
import type { ExpectedFile } from '../../../helpers/expected-file.ts';
import { fetchSharedData } from '../../../helpers/shared-data.ts';

/** What nibabel says of a file; made by test/fixtures/make-fixtures.py. */
interface Expected extends ExpectedFile {
  version: number;
  dtype: string;
  shape: number[];
  affine: number[];
}

const fixtures = await readExpected<Expected>('nibabel-fixtures.json');
const shared = await readExpected<Expected>('nibabel-shared.json');

function compare(volume: Volume, expected: Expected): void {
  const volumes = expected.shape.slice(3).reduce((product, n) => product * n, 1);
  expect(volume.format).to.equal(`NIfTI-${expected.version}${volumes > 1 ? `, volume 1 of ${volumes}` : ''}`);
  volume.grid.indexToWorld.forEach((value, i) => {
    // nibabel makes the rotation of a quaternion in float32; an sform is copied.
    expect(value, `affine[${i}]`).to.be.closeTo(expected.affine[i], 1e-6 * Math.max(1, Math.abs(expected.affine[i])));
  });
  compareValues(volume, expected);
}

describe('NIfTI values, dimensions and affine against nibabel', () => {
  for (const expected of fixtures) {
    it(`${expected.path} (${expected.dtype})`, async () => {
      compare(await decodeBytes(await fetchFixture(expected.path), expected.path), expected);
    });
  }
});

/**
 * Colours that nibabel 5.4.2 wrote, packed by zlib (Base64), and their brightness: numpy.floor(.2126 * R + .7152 * G + .0722 * B + .5) of
 * what nibabel reads again.
 */
const colors = {
  RGB: {
    bytes:
      'eNqLYWQgCjADIQsDEwMjFKKCBgYJCG0PJByACIgbHCB8ZLzBGapmkAAmfJIOWISwiDU4YNOcp20Ipvv6+pb45ApdY4yKiipbxHviamtxcXEv694PvxWuX79upMUXenunvb19lZNA766q9PR0seuSJ5w3A0XefSqrv7n22bNnQXJc67QKAB+4LN4=',
    values: [
      142, 97, 157, 90, 142, 204, 115, 47, 233, 215, 42, 188, 63, 74, 172, 103, 160, 103, 63, 232, 195, 230, 40, 75,
    ],
  },
  RGBA: {
    bytes:
      'eNpjYGCMYSAGMAMhCwMTAyMUogBOBgYFBgb7BgYGByDPAUg4NED4yNh5A4QeRIAJl4QDNjEsgg44/JOnbQimzc3Ntz37tr974+0JiW5ubhs/h+pHvjDc8eLSpUuKrwuLpM8qLwkpLCy8YRsnL7l7T/TB1atX13DFTlwd+5YnY/78+Uprpymktby8aO7r6yv0OTiwrfun0VVWVtY9kezWqUWTp7QCAPrOOHg=',
    values: [
      55, 239, 205, 70, 116, 98, 210, 139, 80, 113, 82, 181, 171, 79, 190, 159, 146, 210, 77, 117, 211, 5, 28, 140,
    ],
  },
} as const;

describe('NIfTI colours', () => {
  for (const [name, { bytes, values }] of Object.entries(colors))
    it(`are shown, with their brightness as values: ${name}`, async () => {
      const file = unzlibSync(Uint8Array.from(atob(bytes), (sign) => sign.charCodeAt(0)));
      const volume = await decodeBytes(file, 'x.nii');
      expect(valuesOf(volume)).to.deep.equal(values);
      expect(volume.samples).to.be.instanceOf(Uint8Array);
      expect(volume.grid.spacing).to.deep.equal([2, 3, 4]);
      // The numbers follow the header of 352 bytes.
      const rgb = [...file.subarray(352)].filter((_, at) => name === 'RGB' || at % 4 < 3);
      expect(rgbOf(volume)).to.deep.equal(rgb);
      expect(volume.window).to.deep.equal([0, 255]);
      expect(volume.left).to.deep.equal(
        name === 'RGBA' ? ['where the voxels are transparent: they are shown as if they were not'] : undefined,
      );
    });
});

describe('NIfTI files of the shared data against nibabel', () => {
  for (const expected of shared) {
    it(expected.path, async function () {
      const bytes = new Uint8Array(await fetchSharedData(this, expected.path));
      compare(await decodeBytes(bytes, expected.path), expected);
    });
  }
});

describe('NIfTI samples as stored', () => {
  const load = async (name: string): Promise<Volume> =>
    decodeBytes(await fetchFixture(`nifti/${name}.nii`), `${name}.nii`);

  it('keep small types in 8 and 16 bits', async () => {
    for (const name of ['v1-le-u1', 'v2-be-i1']) expect((await load(name)).samples).to.be.instanceOf(Uint8Array);
    for (const name of ['v1-be-u2', 'v1-le-i2']) expect((await load(name)).samples).to.be.instanceOf(Uint16Array);
  });

  it('keep 64-bit numbers apart that doubles do not distinguish', async () => {
    const volume = await load('v1-be-i8');
    expect(volume.samples).to.be.instanceOf(Uint16Array);
    expect(Array.from(volume.samples)).to.deep.equal(Array.from({ length: 60 }, (_, i) => 413 - 7 * i));
  });

  it('keep wide integers exact in float32, less an offset', async () => {
    const volume = await load('v1-le-u4');
    expect(volume.samples).to.be.instanceOf(Float32Array);
    expect(valuesOf(volume)).to.deep.equal(Array.from({ length: 60 }, (_, i) => 2 ** 32 - 2 - 300000 * i));
  });

  it('keep milliseconds of 10^9 seconds', async () => {
    const values = valuesOf(await load('far-from-zero'));
    values.forEach((value, i) => expect(value).to.be.closeTo(1e9 + i * 0.001, 1.2e-7)); // double's own grid at 10^9
  });

  it('take the range that the file wants to be shown in', async () => {
    expect((await load('float-offset')).window).to.deep.equal([5, 50]);
    const { window, histogram } = await load('v1-le-i2');
    expect(window, 'else that of its histogram').to.deep.equal(windowFromHistogram(histogram));
  });
});

/**
 * What headers of 60 numbers say of their axes, and the volume that SimpleITK 2.5.7 (niftilib) reads; of axes beyond the first number, nibabel
 * 5.4.2 as well. Of a length of 0 nibabel makes a volume without voxels.
 */
const oddAxes: readonly (readonly [dim: readonly number[], dimensions: readonly number[], volumes?: number])[] = [
  [
    [3, 4, 5, 0, 1, 1, 1, 1],
    [4, 5, 1],
  ],
  [
    [3, 4, 5, 0, 0, 0, 0, 0],
    [4, 5, 1],
  ],
  [
    [3, 4, 5, -1, 1, 1, 1, 1],
    [4, 5, 1],
  ],
  [
    [3, 4, 0, 0, 1, 1, 1, 1],
    [4, 1, 1],
  ],
  [[4, 4, 5, 0, 2, 0, 0, 0], [4, 5, 1], 2],
  [
    [4, 4, 5, 3, 0, 0, 0, 0],
    [4, 5, 3],
  ],
  [
    [4, 4, 5, 3, -3, 1, 1, 1],
    [4, 5, 3],
  ],
  [[7, 4, 5, 1, 3, 0, 0, 0], [4, 5, 1], 3],
  [
    [2, 4, 5, 0, 0, 0, 0, 0],
    [4, 5, 1],
  ],
  [
    [2, 4, 5, -7, 999, 3, 2, 9],
    [4, 5, 1],
  ],
  [
    [3, 4, 5, 3, 30_000, -2, 7, 1],
    [4, 5, 3],
  ],
];

describe('NIfTI files with axes of no length', () => {
  for (const version of [1, 2])
    for (const [dim, dimensions, volumes = 1] of oddAxes)
      it(`are as long as 1 there: NIfTI-${version}, ${dim.join(' ')}`, async () => {
        const bytes = await fetchFixture(version === 1 ? 'nifti/v1-le-i2.nii' : 'nifti/v2-le-i2.nii');
        const values = valuesOf(await decodeBytes(bytes.slice(), 'x.nii'));
        const view = new DataView(bytes.buffer);
        for (const [i, n] of dim.entries())
          if (version === 1) view.setInt16(40 + 2 * i, n, true);
          else view.setBigInt64(16 + 8 * i, BigInt(n), true);
        const volume = await decodeBytes(bytes, 'x.nii');
        expect(volume.grid.kind === 'cartesian' && volume.grid.dimensions).to.deep.equal(dimensions);
        expect(volume.format).to.equal(`NIfTI-${version}${volumes > 1 ? `, volume 1 of ${volumes}` : ''}`);
        expect(valuesOf(volume)).to.deep.equal(
          values.slice(
            0,
            dimensions.reduce((product, n) => product * n, 1),
          ),
        );
      });
});

describe('NIfTI files that are refused', () => {
  /** The plain int16 fixture with bytes written over. */
  const patched = async (
    at: number,
    value: number,
    type: 'Int16' | 'Float32' | 'Uint8' = 'Int16',
  ): Promise<Uint8Array<ArrayBuffer>> => {
    const bytes = await fetchFixture('nifti/v1-le-i2.nii');
    new DataView(bytes.buffer)[`set${type}`](at, value, true);
    return bytes;
  };
  const refuse = async (bytes: Uint8Array<ArrayBuffer>, name = 'x.nii') => expectError(decodeBytes(bytes, name));

  it('name the voxels of a header that asks for 10^12 of them', async () => {
    const bytes = await patched(42, 10000);
    for (const at of [44, 46]) new DataView(bytes.buffer).setInt16(at, 10000, true);
    const error = await refuse(bytes);
    expect(error.code).to.equal('format/too-large');
    expect(error.message).to.contain('10000 x 10000 x 10000').and.to.contain('1,000,000,000,000');
  });

  it('refuse NIfTI-2 dimensions of 64 bits', async () => {
    const bytes = await fetchFixture('nifti/v2-be-i2.nii');
    new DataView(bytes.buffer).setBigInt64(24, 2n ** 62n);
    expect((await refuse(bytes)).code).to.equal('format/too-large');
  });

  it('refuse CIFTI, which is no volume, with the program that takes the voxels out of it', async () => {
    const bytes = await fetchFixture('nifti/v2-be-i2.nii');
    new DataView(bytes.buffer).setInt32(504, 3002);
    const error = await refuse(bytes, 'x.dtseries.nii');
    expect(error.code).to.equal('format/unsupported');
    expect(error.message).to.contain('is CIFTI').and.to.contain('wb_command -cifti-separate');
  });

  it('refuse a small gzip file that asks for much, before it allocates', async () => {
    const bytes = await patched(42, 10000);
    new DataView(bytes.buffer).setInt16(44, 10000, true);
    const packed = await new Response(
      new Blob([bytes]).stream().pipeThrough(new CompressionStream('gzip')),
    ).arrayBuffer();
    const error = await refuse(new Uint8Array(packed), 'x.nii.gz');
    expect(error.code).to.equal('format/corrupt');
    expect(error.message).to.contain('ends early');
  });

  it('refuse bits in clear words', async () => {
    const error = await refuse(await patched(70, 1));
    expect(error.code).to.equal('format/unsupported');
    expect(error.message).to.contain('one bit per voxel');
  });

  it('refuse headers that contradict themselves', async () => {
    for (const [at, value] of [
      [40, 0],
      [40, 9],
      [42, -3],
      [42, 0],
      [70, 77],
    ] as const) {
      expect((await refuse(await patched(at, value))).code, `${value} at ${at}`).to.equal('format/corrupt');
    }
    const infinite = await patched(112, 1, 'Float32');
    new DataView(infinite.buffer).setFloat32(116, Infinity, true);
    expect((await refuse(infinite)).code).to.equal('format/corrupt');
    const text = await fetchFixture('nifti/v2-le-i2.nii');
    text[8] = 10;
    expect((await refuse(text)).message).to.contain('as text');
  });

  it('refuse a file that ends early', async () => {
    const bytes = await fetchFixture('nifti/v1-le-i2.nii');
    for (const length of [0, 1, 100, 347, 348, 352, 471]) {
      const error = await refuse(bytes.slice(0, length));
      expect(error.code, `${length} bytes`).to.be.oneOf(length === 0 ? ['format/unknown'] : ['format/corrupt']);
    }
    await decodeBytes(bytes.slice(0, 472), 'x.nii');
  });

  it('fall back to the spacing where both affines are unusable', async () => {
    const bytes = await fetchFixture('nifti/v1-le-i2.nii');
    bytes.fill(0, 280, 328);
    const volume = await decodeBytes(bytes, 'x.nii');
    expect(volume.grid.indexToWorld.every(Number.isFinite)).to.equal(true);
    expect(volume.grid.spacing.every((s) => s > 0)).to.equal(true);
  });
});

describe('the memory of a NIfTI file that is not packed', () => {
  /** 40 x 40 x 40 numbers of 16 bits that count up, as often as the series has volumes. */
  const countUp = async (offset: number, volumes: number): Promise<Uint8Array<ArrayBuffer>> => {
    const header = (await fetchFixture('nifti/v1-le-i2.nii')).subarray(0, 352);
    const bytes = new Uint8Array(offset + 2 * 40 ** 3 * volumes);
    bytes.set(header);
    const view = new DataView(bytes.buffer);
    [4, 40, 40, 40, volumes].forEach((n, i) => view.setInt16(40 + 2 * i, n, true));
    view.setFloat32(108, offset, true);
    view.setFloat32(112, 0, true);
    for (let i = 0; i < volumes * 40 ** 3; i++) view.setInt16(offset + 2 * i, (i % 40 ** 3) - 32_000, true);
    return bytes;
  };

  for (const offset of [352, 357]) {
    it(`is the file's own, and no copy: samples from byte ${offset} on`, async () => {
      const bytes = await countUp(offset, 1);
      const volume = await decodeBytes(bytes, 'x.nii');
      expect(volume.samples.buffer).to.equal(bytes.buffer);
      expect(volume.samples).to.have.length(40 ** 3);
      valuesOf(volume).forEach((value, i) => {
        if (value !== i - 32_000) throw new Error(`voxel ${i}: got ${value}`);
      });
    });
  }

  it('of a series holds the first volume alone', async () => {
    const bytes = await countUp(352, 3);
    const volume = await decodeBytes(bytes, 'x.nii');
    expect(volume.samples.buffer.byteLength).to.equal(2 * 40 ** 3);
    expect(volume.range).to.deep.equal([-32_000, 40 ** 3 - 1 - 32_000]);
  });
});
