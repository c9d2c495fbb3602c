// NIfTI, NRRD, MetaImage and mosaics of strangers: what they may ask for, and where they may lie.
import { expect } from '@esm-bundle/chai';
import { encode as encodePng } from 'fast-png';
import { gzipSync } from 'fflate';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import { Budget } from '../../../../src/formats/base/budget.ts';
import { decodeFile } from '../../../../src/formats/decode.ts';
import type { DecodedVolume, DecodeSettings } from '../../../../src/formats/base/decoded-volume.ts';
import { PartGatherer } from '../../../../src/formats/base/gather-parts.ts';
import { expandPattern } from '../../../../src/formats/grid-files/find-data-files.ts';
import { storeSamples } from '../../../../src/formats/base/store-samples.ts';
import { numberTypes } from '../../../../src/formats/base/number-types.ts';
import { corners } from '../../../../src/volume/grid.ts';
import { decodeBytes, expectError, fetchFixture, fixtureContext, urlOf } from '../../../helpers/decode.ts';

type Bytes = Uint8Array<ArrayBuffer>;

const bytesOf = (text: string): Bytes => new TextEncoder().encode(text);
const join = (...parts: Uint8Array[]): Bytes => Uint8Array.from(parts.flatMap((part) => [...part]));

function decode(
  bytes: Bytes,
  name: string,
  settings: DecodeSettings = {},
  budget = new Budget(),
): Promise<DecodedVolume> {
  return decodeFile({ bytes, url: urlOf(name), contentType: '' }, settings, { ...fixtureContext(), budget });
}

interface Nifti {
  dim?: number[];
  datatype?: number;
  fields?: [at: number, type: 'Float32' | 'Int16' | 'Uint8', value: number][];
}

/** A NIfTI-1 file of 2 x 2 x 2 bytes, or of other ones. */
function nifti({ dim = [2, 2, 2], datatype = 2, fields = [] }: Nifti, data = new Uint8Array(8)): Bytes {
  const bytes = new Uint8Array(352 + data.length);
  const view = new DataView(bytes.buffer);
  view.setInt32(0, 348, true);
  [dim.length, ...dim].forEach((n, i) => view.setInt16(40 + 2 * i, n, true));
  view.setInt16(70, datatype, true);
  [1, 2, 3, 4].forEach((n, i) => view.setFloat32(76 + 4 * i, n, true));
  view.setFloat32(108, 352, true);
  bytes.set(bytesOf('n+1'), 344);
  for (const [at, type, value] of fields) view[`set${type}`](at, value, true);
  bytes.set(data, 352);
  return bytes;
}

const nrrd = (fields: Record<string, string>, data: Uint8Array = new Uint8Array(8)): Bytes =>
  join(
    bytesOf(
      `NRRD0004\n${Object.entries({ type: 'uint8', dimension: '3', sizes: '2 2 2', encoding: 'raw', ...fields })
        .map(([name, value]) => `${name}: ${value}\n`)
        .join('')}\n`,
    ),
    data,
  );

const metaImage = (fields: Record<string, string>): Bytes =>
  join(
    bytesOf(
      Object.entries({
        ObjectType: 'Image',
        NDims: '3',
        DimSize: '2 2 2',
        ElementType: 'MET_UCHAR',
        ...fields,
        ElementDataFile: 'LOCAL',
      })
        .map(([name, value]) => `${name} = ${value}\n`)
        .join(''),
    ),
    new Uint8Array(8),
  );

const png = (edge: number): Bytes =>
  new Uint8Array(encodePng({ width: edge, height: edge, data: new Uint8Array(edge * edge), channels: 1, depth: 8 }));
const mosaic = { columns: 2, rows: 2 };

describe('the budget of a load', () => {
  const edge = 64;
  const samples = new Uint8Array(edge ** 3);
  const files: [what: string, name: string, bytes: () => Bytes, settings?: DecodeSettings][] = [
    ['NIfTI', 'a.nii.gz', () => gzipSync(nifti({ dim: [edge, edge, edge] }, samples))],
    ['NIfTI with doubles', 'a.nii', () => nifti({ dim: [16, 16, 16], datatype: 64 }, new Uint8Array(8 * 16 ** 3))],
    ['NRRD', 'a.nrrd', () => nrrd({ sizes: `${edge} ${edge} ${edge}`, encoding: 'gzip' }, gzipSync(samples))],
    ['a mosaic', 'a.png', () => png(512), { mosaic }],
    ["a radar's mosaic", 'a.png', () => png(512), { mosaic, elevations: [1, 2, 3, 4], range: [0, 100] }],
  ];
  for (const [what, name, bytes, settings] of files) {
    it(`is drawn on by ${what}`, async () => {
      const budget = new Budget();
      const volume = await decode(bytes(), name, settings, budget);
      expect(budget.allowedBytes - budget.leftBytes).to.be.at.least(volume.samples.byteLength);
      const error = await expectError(decode(bytes(), name, settings, new Budget(volume.samples.byteLength - 1)));
      expect(error.code).to.equal('format/too-large');
      expect(error.message).to.contain('is allowed');
    });
  }

  it('is drawn on for second copies of samples', () => {
    const cases = [
      ['int32', 1, 2 ** 20],
      ['float64', 1, 1.5],
      ['int64', 0, 0],
      ['uint64', 0, 0],
    ] as const;
    for (const [type, at, value] of cases) {
      const bytes = new Uint8Array(8 * 100);
      if (type === 'int32') new Int32Array(bytes.buffer)[at] = 200;
      else if (type === 'float64') new Float64Array(bytes.buffer)[at] = value;
      const budget = new Budget(10);
      budget.addFile(100);
      expect(() => storeSamples(bytes, numberTypes[type], true, { slope: 1, intercept: 0, budget }), type).to.throw(
        VolumeViewError,
        'the samples asks for',
      );
    }
  });

  it('has parts of many files wait until it allows for all', () => {
    const budget = new Budget(1000);
    budget.addFile(1);
    budget.take(700, 'all else');
    const parts = new PartGatherer(400, 'the parts', budget);
    budget.take(200, 'a part');
    parts.add(new Uint8Array(200).fill(1));
    expect([parts.length, budget.leftBytes]).to.deep.equal([200, 100]);
    budget.giveBack(700);
    budget.take(200, 'a part');
    parts.add(new Uint8Array(200).fill(2));
    expect(Array.from(parts.finish())).to.deep.equal([
      ...Array.from({ length: 200 }, () => 1),
      ...Array.from({ length: 200 }, () => 2),
    ]);
    expect(budget.leftBytes).to.equal(600);
    const refused = new PartGatherer(601, 'the parts', budget);
    refused.add(new Uint8Array(0));
    expect(() => refused.finish()).to.throw(VolumeViewError, 'the parts asks for 601 bytes');
  });
});

describe('headers of strangers', () => {
  const long = 2 ** 18;
  const within = async (bytes: Bytes, name: string): Promise<string> => {
    const began = performance.now();
    const answer = await decode(bytes, name).then(
      () => 'volume',
      (error: VolumeViewError) => error.code,
    );
    expect(performance.now() - began, name).to.be.lessThan(20_000);
    return answer;
  };

  it('are read in a time that grows with their length', async () => {
    const blanks = ' '.repeat(long);
    for (const line of [
      `a${blanks}b`,
      `a: ${blanks}b`,
      `${blanks}: b`,
      `a: b${blanks}c`,
      `units: "${'\\"'.repeat(long / 2)}`,
      `space directions: ${'('.repeat(long)}`,
      `data file: a%d${blanks}1 2x`,
      `data file: ${'%'.repeat(long)} 1 2`,
      `sizes: ${'1 '.repeat(long / 2)}`,
    ]) {
      await within(
        join(
          bytesOf(`NRRD0004\n${line}\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n\n`),
          new Uint8Array(8),
        ),
        'a.nrrd',
      );
      await within(
        join(
          bytesOf(
            `ObjectType = Image\nNDims = 3\n${line.replace(':', ' =')}\nDimSize = 2 2 2\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n`,
          ),
          new Uint8Array(8),
        ),
        'a.mha',
      );
    }
  });

  it('say which field is too long', async () => {
    const error = await expectError(decode(nrrd({ units: `"${'u'.repeat(5000)}"` }), 'a.nrrd'));
    expect(error.message).to.contain('5,002 characters as units; expected at most 4,096');
    expect(await decode(nrrd({ 'a note:=b': 'n'.repeat(5000), content: 'c'.repeat(5000) }), 'a.nrrd')).to.include({
      unit: '',
    });
    expect((await expectError(decode(metaImage({ Offset: '1 '.repeat(2500) }), 'a.mha'))).message).to.contain(
      '4,999 characters as Offset',
    );
    expect((await decode(metaImage({ Comment: 'c'.repeat(5000) }), 'a.mha')).format).to.equal('MetaImage');
  });

  it('name files by patterns as before', () => {
    const names = (text: string): string[] | null => expandPattern('the header', text);
    expect(names('slice%03d.raw 1 3 1')).to.deep.equal(['slice001.raw', 'slice002.raw', 'slice003.raw']);
    expect(names('a b %2i c 9 10')).to.deep.equal(['a b  9 c', 'a b 10 c']);
    expect(names('a%d 4 1 -2 2')).to.deep.equal(['a4', 'a2']);
    expect(names('100%.raw')).to.equal(null);
    expect(names('100%.raw 1 2')).to.equal(null);
    expect(names('5% %d 1 2')).to.deep.equal(['5% 1', '5% 2']);
    expect(names('1 2 3')).to.equal(null);
    expect(names('-%d 1 2')).to.deep.equal(['-1', '-2']);
  });

  it('can not name a field that objects have', async () => {
    expect(
      await within(
        join(
          bytesOf(
            'ObjectType = Image\nconstructor = 1\n__proto__ = 2\ntoString = 3\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n',
          ),
          new Uint8Array(8),
        ),
        'a.mha',
      ),
    ).to.equal('volume');
  });
});

describe('where volumes of strangers lie', () => {
  const srow = (values: number[]): Nifti['fields'] => [
    [254, 'Int16', 1],
    ...values.map((value, i): [number, 'Float32', number] => [280 + 4 * i, 'Float32', value]),
  ];
  const diagonal = (a: number, b: number, c: number, offset = 0): number[] => [a, 0, 0, offset, 0, b, 0, 0, 0, 0, c, 0];
  const refused: [what: string, bytes: Bytes, name: string, settings?: DecodeSettings][] = [
    ['an sform of 1e30', nifti({ fields: srow(diagonal(1e30, 1, 1)) }), 'a.nii'],
    [
      'an sform that overflows in millimetres',
      nifti({ fields: [...srow(diagonal(1e11, 1, 1))!, [123, 'Uint8', 1]] }),
      'a.nii',
    ],
    [
      'an sform that vanishes in millimetres',
      nifti({ fields: [...srow(diagonal(1e-11, 1, 1))!, [123, 'Uint8', 3]] }),
      'a.nii',
    ],
    ['an origin of 1e38', nifti({ fields: srow(diagonal(1, 1, 1, 1e38)) }), 'a.nii'],
    ['steps of 1e-30', nifti({ fields: srow(diagonal(1e-30, 1e-30, 1e-30)) }), 'a.nii'],
    ["NRRD's directions of 1e200", nrrd({ space: 'RAS', 'space directions': '(1e200,0,0) (0,1,0) (0,0,1)' }), 'a.nrrd'],
    ["NRRD's kilometres", nrrd({ spacings: '1e8 1 1', units: '"km" "mm" "mm"' }), 'a.nrrd'],
    ["MetaImage's spacing of 1e300", metaImage({ ElementSpacing: '1e300 1 1' }), 'a.mha'],
    ["MetaImage's spacing of 1e-300", metaImage({ ElementSpacing: '1 1e-300 1' }), 'a.mha'],
    ["an attribute's spacing", nifti({}), 'a.nii', { spacing: [1e300, 1, 1] }],
    ["a mosaic's spacing", png(4), 'a.png', { mosaic, spacing: [1, 1e-200, 1] }],
    ["a radar's range of [0, 1e308]", png(8), 'a.png', { mosaic, elevations: [1, 2], range: [0, 1e308] }],
    ['a radar behind itself', png(8), 'a.png', { mosaic, elevations: [1, 2], range: [-1e6, 1] }],
    [
      "a radar's azimuths without an end",
      png(8),
      'a.png',
      { mosaic, elevations: [1, 2], range: [0, 100], azimuth: [0, 1e308] },
    ],
    [
      'a radar that is exaggerated by 1e300',
      png(8),
      'a.png',
      { mosaic, elevations: [1, 2], range: [0, 100], verticalExaggeration: 1e300 },
    ],
    [
      'a line of two million voxels',
      nrrd({ sizes: `1 1 ${2 ** 21}`, encoding: 'gzip' }, gzipSync(new Uint8Array(2 ** 21))),
      'a.nrrd',
    ],
  ];
  for (const [what, bytes, name, settings] of refused) {
    it(`${what} is refused`, async () => {
      const error = await expectError(decode(bytes, name, settings));
      expect(error.code).to.be.oneOf(['format/corrupt', 'mosaic/layout']);
      expect(error.message).to.contain('expected');
    });
  }

  it('whatever a header says, what comes is finite', async () => {
    const extremes = [0, -1, 1e-40, 1e-20, 1e20, 3e38, NaN, Infinity, -Infinity];
    const places = [76, 80, 84, 88, 112, 116, 256, 260, 268, 280, 284, 300, 292];
    let volumes = 0;
    for (const at of places) {
      for (const value of extremes) {
        for (const [qform, sform] of [
          [0, 0],
          [1, 0],
          [0, 1],
        ]) {
          const bytes = nifti({
            fields: [...srow(diagonal(2, 3, 4))!, [252, 'Int16', qform], [254, 'Int16', sform], [at, 'Float32', value]],
          });
          try {
            const { grid, slope, intercept } = await decode(bytes, 'a.nii');
            volumes++;
            expect(
              [...grid.indexToWorld, ...grid.spacing, ...corners(grid).flat(), slope, intercept].every(Number.isFinite),
              `${at} ${value}`,
            ).to.equal(true);
          } catch (error) {
            expect(error, `${at} ${value}`).to.be.instanceOf(VolumeViewError);
          }
        }
      }
    }
    expect(volumes).to.be.greaterThan(100);
  });

  it('values that lie farther apart than numbers go are refused', async () => {
    const data = new Uint8Array(Float64Array.of(-1.7e308, 1.7e308, 0, 0, 0, 0, 0, 0).buffer);
    const error = await expectError(decodeBytes(nifti({ datatype: 64 }, data), 'a.nii'));
    expect(error.message).to.contain('too far apart');
  });
});

// Expected values are those of nibabel 5.4.2 for the same bytes: `Nifti1Image.from_file_map(…)`, its `affine` and `get_fdata()`.
describe('NIfTI as nibabel has it', () => {
  const sform: Nifti['fields'] = [1, 0, 0, 5, 0, 2, 0, 6, 0, 0, 3, 7].map((value, i) => [
    280 + 4 * i,
    'Float32',
    value,
  ]);
  const qoffset: Nifti['fields'] = [10, 20, 30].map((value, i) => [268 + 4 * i, 'Float32', value]);
  const file = (fields: Nifti['fields'] = []): Bytes =>
    nifti(
      { dim: [2, 3, 4], fields: [...sform, ...qoffset, ...fields] },
      new Uint8Array(24).map((_, i) => i),
    );
  const bySform = [1, 0, 0, 5, 0, 2, 0, 6, 0, 0, 3, 7];
  const byQform = [2, 0, 0, 10, 0, 3, 0, 20, 0, 0, 4, 30];
  const bySpacing = [-2, 0, 0, 1, 0, 3, 0, -3, 0, 0, 4, -6];

  const codes: [sformCode: number, qformCode: number, affine: number[]][] = [
    [-1, 0, bySpacing],
    [-1, 1, byQform],
    [0, -2, bySpacing],
    [-1, -1, bySpacing],
    [1, -1, bySform],
    [7, 1, byQform],
    [5, 0, bySform],
  ];
  for (const [sformCode, qformCode, affine] of codes) {
    it(`sform_code ${sformCode}, qform_code ${qformCode}`, async () => {
      const { grid } = await decode(
        file([
          [254, 'Int16', sformCode],
          [252, 'Int16', qformCode],
        ]),
        'a.nii',
      );
      expect(grid.indexToWorld.slice(0, 12)).to.deep.equal(affine);
    });
  }

  it('an sform of zeros, which nibabel gives as it is and nobody can show, gives way to the qform, and that to the spacing', async () => {
    const zeros: Nifti['fields'] = Array.from({ length: 12 }, (_, i) => [280 + 4 * i, 'Float32', 0]);
    const codes = (qformCode: number): Nifti['fields'] => [
      [254, 'Int16', 1],
      [252, 'Int16', qformCode],
    ];
    expect((await decode(file([...zeros, ...codes(1)!]), 'a.nii')).grid.indexToWorld.slice(0, 12)).to.deep.equal(
      byQform,
    );
    expect((await decode(file([...zeros, ...codes(0)!]), 'a.nii')).grid.indexToWorld.slice(0, 12)).to.deep.equal(
      bySpacing,
    );
  });

  it('scl_inter that is no number is refused with a slope, and ignored without', async () => {
    for (const inter of [NaN, Infinity, -Infinity]) {
      const error = await expectError(
        decode(
          file([
            [112, 'Float32', 2],
            [116, 'Float32', inter],
          ]),
          'a.nii',
        ),
      );
      expect(error.message).to.contain(`scl_slope 2 with scl_inter ${inter}`);
    }
    for (const slope of [0, NaN, Infinity])
      expect(
        await decode(
          file([
            [112, 'Float32', slope],
            [116, 'Float32', NaN],
          ]),
          'a.nii',
        ),
      ).to.include({ slope: 1, intercept: 0 });
  });

  it('micrometres and metres become millimetres, which nibabel leaves to its caller', async () => {
    const { grid } = await decode(
      file([
        [254, 'Int16', 1],
        [123, 'Uint8', 3],
      ]),
      'a.nii',
    );
    grid.spacing.forEach((length, axis) => expect(length).to.be.closeTo((axis + 1) / 1000, 1e-12));
    expect(
      (
        await decode(
          file([
            [254, 'Int16', 1],
            [123, 'Uint8', 1],
          ]),
          'a.nii',
        )
      ).grid.spacing,
    ).to.deep.equal([1000, 2000, 3000]);
  });

  it('cal_min and cal_max are the window, where they are one', async () => {
    const windowOf = async (low: number, high: number): Promise<unknown> =>
      (
        await decode(
          file([
            [128, 'Float32', low],
            [124, 'Float32', high],
          ]),
          'a.nii',
        )
      ).window;
    expect(await windowOf(3, 20)).to.deep.equal([3, 20]);
    for (const [low, high] of [
      [0, 0],
      [20, 3],
      [NaN, 3],
      [0, Infinity],
    ])
      expect(await windowOf(low, high)).to.equal(undefined);
  });

  it('the fixtures are as before', async () => {
    expect((await decodeBytes(await fetchFixture('nifti/v2-be-i8.nii'), 'a.nii')).format).to.equal('NIfTI-2');
  });
});
