import { expect } from '@esm-bundle/chai';
import { Validator } from '@cfworker/json-schema';
import type { Schema } from '@cfworker/json-schema';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { readManifest } from '../../../../src/formats/manifest/manifest.ts';
import { decodeBytes, expectError, fetchFile, fetchFixture, valuesOf } from '../../../helpers/decode.ts';

const encode = (value: unknown): Uint8Array<ArrayBuffer> =>
  new TextEncoder().encode(typeof value === 'string' ? value : JSON.stringify(value));
const affine12 = [1, 0, 0, 5, 0, 2, 0, 6, 0, 0, 3, 7];

const good: unknown[] = [
  { image: 'a.png' },
  {
    image: 'a.png',
    mosaic: '10x10',
    slices: 96,
    spacing: [0.8, 0.8, 1.2],
    window: [-100, 300],
    transferFunction: 'ct-angio',
    unit: 'HU',
    slope: 1,
    intercept: -1024,
    title: 't',
    credit: 'c',
  },
  { image: '../x/head.nii.gz', indexToWorld: affine12 },
  { image: 'a.png', indexToWorld: [...affine12, 0, 0, 0, 1], mosaic: '4 X 3' },
  { image: 'a.png', channels: 'high-low', spacing: [1, 1, -2.5] },
  { image: 'a.raw', raw: { type: 'int16', endian: 'big', dimensions: [512, 512, 96], offset: 0 } },
  { files: ['a', 'b'], raw: { type: 'float64', dimensions: [1, 1, 2] } },
  { image: 'a.png', mosaic: '2x1', elevations: [0.5, 1.2], range: [250, 500] },
  {
    image: 'a.png',
    mosaic: '2x1',
    elevations: [0.5, -1],
    range: [-375, 250],
    azimuth: [0.5, -1],
    beamWidth: 0.95,
    moment: 'VRAD',
    nyquist: 7.5,
    site: { name: 'here', latitude: 50, longitude: -6.5, height: 100 },
    time: '2020-02-07T13:00:00Z',
    sweeps: [
      {},
      {
        rays: 3,
        gates: 4,
        range: [1, 2],
        azimuth: [0, 1],
        azimuths: [1, 2.5, 350],
        elevations: [0.4, 0.5, -0.1],
        nyquist: 8,
        time: '2020-02-07T13:00:00.250Z',
        note: 'left alone',
      },
    ],
  },
  { image: 'a.png', slope: -0.5, unit: '', note: 'unknown fields are left alone' },
  { scans: [{ image: 'a.png' }] },
  { video: 'heart.webm', mosaic: '4x3', slices: 12, noDataBelow: 12 },
  { video: 'heart.webm', lossy: { rms: 0.5, p99: 1, max: 3, picture: { rms: 0.1, p99: 0.2, max: 4 } } },
  {
    video: 'storm.webm',
    mosaic: '2x2',
    scans: [{ time: '2020-02-07T13:00:00Z' }, { time: '2020-02-07T13:10:00Z', sweeps: [{ rays: 360 }] }],
  },
  {
    scans: [
      { image: 'a.png', time: '900 ms' },
      { image: 'b.png', time: '1 s' },
      { image: 'c.png', time: '2.5e1 s' },
    ],
  },
  { files: ['a.png', '../b.png', 'https://example.org/c.png'], spacing: [1, 1, 2] },
  { unit: 'HU', scans: [{ files: ['a.png'] }, { image: 'b.nrrd' }] },
  {
    mosaic: '2x2',
    unit: 'dBZ',
    scans: [
      { image: 'a.png', time: '2020-02-07T13:00:00Z' },
      { image: 'b.png', unit: 'm/s' },
      { image: 'c.png', time: '2020-02-07T13:10:00Z', note: 1 },
    ],
  },
];

const bad: [field: string, value: unknown][] = [
  ['image', {}],
  ['image', { image: '' }],
  ['image', { image: 3 }],
  ['files', { image: 'a', files: ['b'] }],
  ['files', { files: [] }],
  ['files', { files: 'a.png' }],
  ['files', { files: ['a.png', ''] }],
  ['files', { files: ['a'], scans: [{ image: 'b' }] }],
  ['scans[0].files', { scans: [{ image: 'a', files: ['b'] }] }],
  ['noDataBelow', { video: 'a', noDataBelow: -1 }],
  ['video', { video: '' }],
  ['video', { image: 'a', video: 'b' }],
  ['video', { files: ['a'], video: 'b' }],
  ['raw', { video: 'a', raw: { type: 'int16', dimensions: [1, 1, 1] } }],
  ['channels', { video: 'a', channels: 'high-low' }],
  ['scans[0].raw', { video: 'a', scans: [{ raw: { type: 'int16', dimensions: [1, 1, 1] } }] }],
  ['scans[0].channels', { video: 'a', scans: [{ channels: 'high-low' }] }],
  ['scans[0].video', { scans: [{ video: 'a' }] }],
  ['scans[0].video', { video: 'a', scans: [{ video: 'a' }] }],
  ['scans[0].image', { video: 'a', scans: [{ image: 'a' }] }],
  ['scans[0].files', { video: 'a', scans: [{ files: ['a'] }] }],
  ['lossy', { image: 'a', lossy: 1 }],
  ['lossy', { image: 'a', lossy: { rms: 1, max: 2 } }],
  ['lossy', { image: 'a', lossy: { rms: 1, p99: 1, max: -2 } }],
  ['lossy', { image: 'a', lossy: { rms: 1, p99: 1, max: 2, picture: 3 } }],
  ['mosaic', { image: 'a', mosaic: '10' }],
  ['mosaic', { image: 'a', mosaic: [10, 10] }],
  ['slices', { image: 'a', slices: 0 }],
  ['slices', { image: 'a', slices: 1.5 }],
  ['slices', { image: 'a', slices: '96' }],
  ['channels', { image: 'a', channels: 'rg' }],
  ['raw', { image: 'a', raw: 'int16' }],
  ['raw', { image: 'a', raw: { type: 'int16' } }],
  ['raw', { image: 'a', raw: { dimensions: [1, 1, 1] } }],
  ['raw', { image: 'a', raw: { type: 'short', dimensions: [1, 1, 1] } }],
  ['raw', { image: 'a', raw: { type: 'int16', dimensions: [1, 1] } }],
  ['raw', { image: 'a', raw: { type: 'int16', dimensions: [1, 0, 1] } }],
  ['raw', { image: 'a', raw: { type: 'int16', dimensions: [1, 1.5, 1] } }],
  ['raw', { image: 'a', raw: { type: 'int16', dimensions: [1, 1, 1], offset: -1 } }],
  ['raw', { image: 'a', raw: { type: 'int16', dimensions: [1, 1, 1], endian: 'middle' } }],
  ['spacing', { image: 'a', spacing: [1, 1] }],
  ['spacing', { image: 'a', spacing: [1, 0, 1] }],
  ['spacing', { image: 'a', spacing: '1 1 1' }],
  ['indexToWorld', { image: 'a', indexToWorld: [1, 2, 3] }],
  ['indexToWorld', { image: 'a', indexToWorld: [...affine12, 0, 0, 0, 2] }],
  ['slope', { image: 'a', slope: 0 }],
  ['slope', { image: 'a', slope: null }],
  ['intercept', { image: 'a', intercept: '0' }],
  ['unit', { image: 'a', unit: 5 }],
  ['window', { image: 'a', window: [1] }],
  ['window', { image: 'a', window: ['a', 'b'] }],
  ['transferFunction', { image: 'a', transferFunction: '' }],
  ['title', { image: 'a', title: [] }],
  ['credit', { image: 'a', credit: 1 }],
  ['elevations', { image: 'a', elevations: '0.5 1.2' }],
  ['elevations', { image: 'a', elevations: [] }],
  ['elevations', { image: 'a', elevations: [0.5, 91] }],
  ['range', { image: 'a', range: [250] }],
  ['range', { image: 'a', range: [250, 0] }],
  ['azimuth', { image: 'a', azimuth: [0, 0] }],
  ['azimuth', { image: 'a', azimuth: [0, 1, 2] }],
  ['beamWidth', { image: 'a', beamWidth: 0 }],
  ['moment', { image: 'a', moment: '' }],
  ['nyquist', { image: 'a', nyquist: -7 }],
  ['site', { image: 'a', site: [50, 6] }],
  ['site', { image: 'a', site: { latitude: '50' } }],
  ['time', { image: 'a', time: '2020-02-07' }],
  ['sweeps', { image: 'a', sweeps: {} }],
  ['sweeps', { image: 'a', sweeps: [1] }],
  ['sweeps', { image: 'a', sweeps: [{ rays: 0 }] }],
  ['sweeps', { image: 'a', sweeps: [{}, { azimuths: [] }] }],
  ['sweeps', { image: 'a', sweeps: [{ elevations: [1, 91] }] }],
  ['sweeps', { image: 'a', sweeps: [{ time: 'noon' }] }],
  ['image', { image: 'a', scans: [{ image: 'b' }] }],
  ['scans', { scans: { image: 'b' } }],
  ['scans', { scans: [] }],
  ['scans', { scans: ['a.png'] }],
  ['scans', { scans: [{ image: 'a', scans: [{ image: 'b' }] }] }],
  ['scans[1].image', { scans: [{ image: 'a' }, { time: '2020-02-07T13:00:00Z' }] }],
  ['scans[0].time', { scans: [{ image: 'a', time: 'noon' }] }],
  ['scans[0].time', { scans: [{ image: 'a', time: '9e999 s' }] }],
  ['unit', { unit: 5, scans: [{ image: 'a' }] }],
];

/** What JSON Schema has no words for. */
const badBeyondSchema: [field: string, value: unknown][] = [
  ['window', { image: 'a', window: [300, -100] }],
  [
    'scans[1].time',
    { mosaic: '1x1', elevations: [1], range: [0, 1], scans: [{ image: 'a' }, { image: 'b', time: '2 s' }] },
  ],
  [
    'scans',
    {
      scans: [
        { image: 'a', time: '2 s' },
        { image: 'b', time: '1 s' },
      ],
    },
  ],
  [
    'scans',
    {
      scans: [
        { image: 'a', time: '2 s' },
        { image: 'b', time: '2020-02-07T13:00:00Z' },
      ],
    },
  ],
  ['time', { image: 'a', time: '2020-13-07T13:00:00Z' }],
  [
    'scans',
    {
      scans: [
        { image: 'a', time: '2020-02-07T13:10:00Z' },
        { image: 'b' },
        { image: 'c', time: '2020-02-07T13:00:00Z' },
      ],
    },
  ],
  ['indexToWorld', { image: 'a', indexToWorld: [1, 0, 0, 0, 2, 0, 0, 0, 0, 0, 3, 0] }],
];

function errorOf(value: unknown): VolumeViewError | null {
  try {
    readManifest(encode(value));
    return null;
  } catch (error) {
    expect(error).to.be.instanceOf(VolumeViewError);
    return error as VolumeViewError;
  }
}

describe('the manifest and its JSON schema', () => {
  const readSchema = async () =>
    JSON.parse(new TextDecoder().decode(await fetchFile('/schema/manifest.json'))) as Schema;

  it('accept the same', async () => {
    const schema = new Validator(await readSchema(), '2020-12');
    for (const value of good) {
      expect(schema.validate(value), JSON.stringify(value)).to.deep.include({ valid: true });
      expect(errorOf(value)).to.equal(null);
    }
  });

  it('refuse the same, and the error names the field', async () => {
    const schema = new Validator(await readSchema(), '2020-12');
    for (const [field, value] of bad) {
      expect(schema.validate(value), JSON.stringify(value)).to.deep.include({ valid: false });
      const error = errorOf(value);
      expect(error?.code, JSON.stringify(value)).to.equal('manifest/invalid');
      expect(error?.message).to.contain(`"${field}"`).and.to.contain('expected');
    }
    for (const [field, value] of badBeyondSchema) expect(errorOf(value)?.message).to.contain(`"${field}"`);
  });

  it('list the same fields', async () => {
    const { properties } = await readSchema();
    expect(Object.keys(properties ?? {})).to.have.members(Object.keys(readManifest(encode({ image: 'a' }))));
  });

  it('are not JSON, or no object', () => {
    for (const text of ['{', '{"image": }', '[1]', '{"image": "a.png",}'])
      expect(errorOf(text)?.code).to.equal('manifest/invalid');
  });
});

describe('a volume by its manifest', () => {
  const image = 'mosaic/gray-3x2.png';

  it('has the values, the position and the texts of the manifest', async () => {
    const manifest = {
      image,
      mosaic: '3x2',
      slices: 5,
      slope: 2,
      intercept: -10,
      unit: 'HU',
      window: [-10, 200],
      transferFunction: 'gray',
      title: 'T',
      credit: 'C',
      indexToWorld: affine12,
    };
    const volume = await decodeBytes(encode(manifest), 'a.json');
    expect(volume).to.deep.include({
      unit: 'HU',
      title: 'T',
      credit: 'C',
      transferFunction: 'gray',
      format: 'PNG mosaic',
    });
    expect(volume.grid.dimensions).to.deep.equal([4, 4, 5]);
    expect(volume.window).to.deep.equal([-10, 200]);
    expect(volume.grid.indexToWorld).to.deep.equal([...affine12, 0, 0, 0, 1]);
    expect(volume.grid.spacing).to.deep.equal([1, 2, 3]);
    valuesOf(volume).forEach((value, i) => expect(value).to.equal(2 * (20 * Math.floor(i / 16) + (i % 16)) - 10));
  });

  it('gives way to attributes', async () => {
    const manifest = { image, mosaic: '1x1', slices: 1, spacing: [9, 9, 9] };
    const volume = await decodeBytes(encode(manifest), 'a.json', {
      mosaic: { columns: 3, rows: 2 },
      slices: 4,
      spacing: [1, 2, 3],
    });
    expect(volume.grid.dimensions).to.deep.equal([4, 4, 4]);
    expect(volume.grid.spacing).to.deep.equal([1, 2, 3]);
  });

  it('may name a NIfTI file, whose slope and intercept come first', async () => {
    const manifest = { image: 'nifti/v1-le-scaled.nii', slope: 10, intercept: 1, spacing: [1, 1, 1] };
    const volume = await decodeBytes(encode(manifest), 'a.json');
    valuesOf(volume).forEach((value, i) => expect(value).to.equal(10 * (0.5 * i - 32) + 1));
    volume.grid.spacing.forEach((s) => expect(s).to.be.closeTo(1, 1e-12));
  });

  it('that names another manifest, or no URL, is refused', async () => {
    const other = await expectError(decodeBytes(encode({ image: 'nibabel-shared.json' }), 'a.json'));
    expect(other.code).to.equal('manifest/invalid');
    expect((await expectError(decodeBytes(encode({ image: 'http://' }), 'a.json'))).code).to.equal('manifest/invalid');
  });

  it('with an image and no mosaic says which attribute to write', async () => {
    const error = await expectError(decodeBytes(await fetchFixture(image), 'a.png'));
    expect(error.code).to.equal('mosaic/layout');
    expect(error.message).to.contain('mosaic="COLUMNSxROWS"');
  });
});
