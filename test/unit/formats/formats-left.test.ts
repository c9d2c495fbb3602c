import { expect } from '@esm-bundle/chai';
import { zlibSync } from 'fflate';
import { describeVolume } from '../../../src/viewer/model/volume-info.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { decodeBytes, fetchFixture } from '../../helpers/decode.ts';
import { surfaceOf } from '../../helpers/meshes.ts';
import { niftiBytes } from '../../helpers/nifti-bytes.ts';
import { pngBytes, pngHeader } from '../../helpers/png-bytes.ts';
import type { PngChunk } from '../../helpers/png-bytes.ts';
import { syntheticVolume } from '../../helpers/synthetic.ts';

const encode = (text: string): Uint8Array<ArrayBuffer> => new TextEncoder().encode(text);

function join(head: Uint8Array, bytes: number): Uint8Array<ArrayBuffer> {
  const all = new Uint8Array(head.length + bytes);
  all.set(head);
  return all;
}

const nrrd = (lines: readonly string[]): Promise<Volume> =>
  decodeBytes(
    join(
      encode(['NRRD0004', 'type: uint8', 'dimension: 3', 'sizes: 4 3 2', 'encoding: raw', ...lines, '', ''].join('\n')),
      24,
    ),
    'x.nrrd',
  );

const metaImage = (lines: readonly string[]): Promise<Volume> =>
  decodeBytes(
    join(
      encode(
        [
          'ObjectType = Image',
          'NDims = 3',
          'DimSize = 4 3 2',
          ...lines,
          'ElementType = MET_UCHAR',
          'ElementDataFile = LOCAL',
          '',
        ].join('\n'),
      ),
      24,
    ),
    'x.mha',
  );

/** A NIfTI file of as many voxels, with further axes. */
function nifti(axes: readonly number[]): Promise<Volume> {
  const one = niftiBytes(syntheticVolume({ dimensions: [4, 3, 2] }));
  const bytes = join(one, 24 * (axes.reduce((product, n) => product * n, 1) - 1));
  const view = new DataView(bytes.buffer);
  view.setInt16(40, 3 + axes.length, true);
  axes.forEach((n, i) => view.setInt16(48 + 2 * i, n, true));
  return decodeBytes(bytes, 'x.nii');
}

describe('what of a file is not shown', () => {
  const leftOf = async (volume: Promise<Volume>): Promise<readonly string[] | undefined> =>
    describeVolume(await volume).left;

  it('is nothing in most files', async () => {
    for (const volume of [nifti([]), nrrd([]), metaImage([])]) expect(await leftOf(volume)).to.equal(undefined);
    expect(await leftOf(nifti([1, 1]))).to.equal(undefined);
    expect(
      await leftOf(
        metaImage([
          'ElementToIntensityFunctionSlope = 1',
          'ElementToIntensityFunctionOffset = 0',
          'DistanceUnits = mm',
        ]),
      ),
    ).to.equal(undefined);
  });

  it('are further volumes, and further numbers of a voxel', async () => {
    expect(await leftOf(nifti([5]))).to.deep.equal(['volumes 2 to 5 of the file']);
    expect(await leftOf(nifti([2]))).to.deep.equal(['volume 2 of the file']);
    expect(await leftOf(nifti([1, 3]))).to.deep.equal(['numbers 2 to 3 of each voxel']);
    expect(await leftOf(nifti([2, 3]))).to.deep.equal(['volume 2 of the file', 'numbers 2 to 3 of each voxel']);
    expect(await leftOf(nifti([1, 2]))).to.deep.equal(['number 2 of each voxel']);
    for (const path of ['nrrd/list-first.nrrd', 'nrrd/list-last.nrrd', 'metaimage/series.mha']) {
      expect(await leftOf(decodeBytes(await fetchFixture(path), path)), path).to.deep.equal(['volume 2 of the file']);
    }
  });

  it('are the phases of complex numbers', async () => {
    expect(await leftOf(decodeBytes(await fetchFixture('nifti/v1-le-c8.nii'), 'x.nii'))).to.deep.equal([
      'the phase of complex numbers, whose magnitudes are shown',
    ]);
  });

  it('is what a header says of values and lengths, and no reader applies', async () => {
    // SimpleITK 2.5.7 gives for all three what it gives without these lines: values from 0 to 23 of such a file of 0 to 23, and the spacing as written. The old range it keeps as text.
    expect(
      (await leftOf(
        metaImage(['ElementToIntensityFunctionSlope = 0.5', 'ElementToIntensityFunctionOffset = -100']),
      ))![0],
    ).to.match(/stored, and not times 0.5 plus -100/);
    expect((await leftOf(metaImage(['DistanceUnits = um'])))![0]).to.match(/"um": lengths are taken for millimetres/);
    expect((await leftOf(nrrd(['old min: -1024', 'old max: 3071'])))![0]).to.match(/not from -1024 to 3071/);
  });
});

describe('what of images and surfaces is not shown', () => {
  const png = async (
    colorType: number,
    pixels: readonly number[],
    between: readonly PngChunk[] = [],
    depth = 8,
  ): Promise<readonly string[] | undefined> => {
    const width = 2;
    const rows = [pixels.slice(0, pixels.length / 2), pixels.slice(pixels.length / 2)];
    const packed = zlibSync(Uint8Array.from(rows.flatMap((row) => [0, ...row])));
    const bytes = pngBytes([pngHeader(width, rows.length, { colorType, depth }), ...between, ['IDAT', packed]]);
    return describeVolume(await decodeBytes(bytes, 'x.png', { mosaic: { columns: 1, rows: 1 } })).notices;
  };
  const colours = 'the colours of the image: their brightness is shown (luma, Rec. ITU-R BT.709)';
  const transparent = 'where the image is transparent: its pixels are shown as if they were not';

  it('are colours and transparency, and nothing of gray that is stored as colours', async () => {
    expect(await png(0, [0, 1, 2, 3])).to.equal(undefined);
    expect(await png(2, [0, 0, 0, 9, 9, 9, 80, 80, 80, 255, 255, 255])).to.equal(undefined);
    expect(await png(2, [0, 0, 0, 9, 9, 9, 80, 80, 80, 255, 0, 0])).to.deep.equal([colours]);
    expect(await png(4, [0, 255, 9, 255, 80, 255, 90, 0])).to.deep.equal([transparent]);
    expect(await png(6, [0, 0, 0, 255, 9, 9, 9, 255, 80, 80, 80, 255, 0, 0, 99, 0])).to.deep.equal([
      colours,
      transparent,
    ]);
    expect(
      await png(4, [0, 0, 255, 255, 9, 0, 255, 255, 80, 7, 255, 255, 90, 0, 127, 255], [], 16),
      '16 bits',
    ).to.deep.equal([transparent]);
    expect(
      await png(3, [0, 1, 0, 1], [['PLTE', Uint8Array.of(0, 0, 0, 255, 255, 255)]]),
      'a palette of grays',
    ).to.equal(undefined);
    expect(await png(3, [0, 1, 0, 1], [['PLTE', Uint8Array.of(0, 0, 0, 0, 0, 255)]])).to.deep.equal([colours]);
  });

  it('are materials, pictures, lines and points in addition to the triangles', async () => {
    const triangle = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';
    expect((await surfaceOf(triangle, { name: 'x.obj' })).notes).to.deep.equal([]);
    expect(
      (await surfaceOf(`mtllib x.mtl\n${triangle}usemtl red\nl 1 2\np 3\n`, { name: 'x.obj' })).notes,
    ).to.deep.equal(['its materials, lines, points are not shown']);
    const ply = (more: string, edges: string): string =>
      `ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n${more}end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n${edges}`;
    expect((await surfaceOf(ply('', ''))).notes).to.deep.equal([]);
    expect(
      (await surfaceOf(ply('element edge 1\nproperty int vertex1\nproperty int vertex2\n', '0 1\n'))).notes,
    ).to.deep.equal(['not shown: 1 edges']);
    const places = btoa(String.fromCharCode(...new Uint8Array(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0).buffer)));
    const gltf = (more: object, primitives: readonly object[] = []): string =>
      JSON.stringify({
        asset: { version: '2.0' },
        buffers: [{ byteLength: 36, uri: `data:application/octet-stream;base64,${places}` }],
        bufferViews: [{ buffer: 0, byteLength: 36 }],
        accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' }],
        meshes: [{ primitives: [{ attributes: { POSITION: 0 } }, ...primitives] }],
        nodes: [{ mesh: 0 }],
        ...more,
      });
    expect((await surfaceOf(gltf({}))).notes).to.deep.equal([]);
    const textured = { materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }], animations: [{}] };
    expect((await surfaceOf(gltf(textured, [{ attributes: { POSITION: 0 }, mode: 1 }]))).notes).to.deep.equal([
      'not shown: its pictures (textures), its points and lines, its animations',
    ]);
  });
});

describe("the range of an NRRD file's axes", () => {
  // Of SimpleITK 2.5, in LPS: x and y have the other sign in RAS. It takes samples that do not say for cells, as Teem does.
  for (const [name, lines, origin] of [
    ['cells, where nothing is said', ['spacings: 1 2 3', 'axis mins: 10 20 30'], [10.5, 21, 31.5]],
    ['cells', ['spacings: 1 2 3', 'axis mins: 10 20 30', 'centers: cell cell cell'], [10.5, 21, 31.5]],
    ['nodes', ['spacings: 1 2 3', 'axis mins: 10 20 30', 'centers: node node node'], [10, 20, 30]],
    [
      'unknown',
      ['spacings: 1 2 3', 'axismins: 10 20 30', 'axis maxs: 14 26 36', 'centers: ??? ??? ???'],
      [10.5, 21, 31.5],
    ],
    ['backwards', ['spacings: -1 2 3', 'axis mins: 10 20 30'], [9.5, 21, 31.5]],
  ] as const) {
    it(`says where the first voxel lies: ${name}`, async () => {
      const { indexToWorld } = (await nrrd(lines)).grid;
      expect([3, 7, 11].map((at) => indexToWorld[at])).to.deep.equal([-origin[0], -origin[1], origin[2]]);
    });
  }

  it('says the spacing where nothing else does, so that the range holds what it says', async () => {
    // SimpleITK takes the spacing for 1 here, and the origin by this one.
    for (const [maxs, centers] of [
      ['14 26 36', 'cell cell cell'],
      ['13 24 33', 'node node node'],
    ]) {
      const { spacing, indexToWorld } = (
        await nrrd(['axis mins: 10 20 30', `axis maxs: ${maxs}`, `centers: ${centers}`])
      ).grid;
      expect(spacing).to.deep.equal([1, 2, 3]);
      expect(indexToWorld[11]).to.equal(centers.startsWith('cell') ? 31.5 : 30);
    }
  });

  it('gives way to a space origin and directions, and is nothing where it is no number', async () => {
    const { indexToWorld } = (
      await nrrd([
        'space: RAS',
        'space directions: (1,0,0) (0,1,0) (0,0,1)',
        'space origin: (1,2,3)',
        'axis mins: 10 20 30',
      ])
    ).grid;
    expect([3, 7, 11].map((at) => indexToWorld[at])).to.deep.equal([1, 2, 3]);
    expect((await nrrd(['spacings: 1 2 3', 'axis mins: nan nan nan'])).grid.indexToWorld[11]).to.equal(0);
  });
});
