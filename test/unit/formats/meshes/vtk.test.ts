// Legacy VTK files of surfaces, as vtkPolyDataWriter (VTK 9.7.2) writes them, and the triangles that vtkPolyDataReader and vtkTriangleFilter make.
import { expect } from '@esm-bundle/chai';
import { joinPieces } from '../../../../src/formats/base/join-pieces.ts';
import { readMesh } from '../../../../src/formats/meshes/read-mesh.ts';
import type { Mesh } from '../../../../src/formats/meshes/mesh.ts';
import { refusalOf, surfaceOf } from '../../../helpers/meshes.ts';

const places = [0, 0, 0, 10, 0, 0, 0, 20, 0, 0, 0, 30];

/** Text and big-endian numbers, one after the other. */
type Part = string | Float32Array | Int32Array | BigInt64Array;

function join(...parts: readonly Part[]): Uint8Array<ArrayBuffer> {
  const pieces = parts.map((part) => {
    if (typeof part === 'string') return new TextEncoder().encode(part);
    const view = new DataView(new ArrayBuffer(part.byteLength));
    part.forEach((number: number | bigint, i: number) => {
      if (part instanceof Float32Array) view.setFloat32(4 * i, number as number);
      else if (part instanceof Int32Array) view.setInt32(4 * i, number as number);
      else view.setBigInt64(8 * i, number as bigint);
    });
    return new Uint8Array(view.buffer);
  });
  return joinPieces(pieces);
}

const head = (version: string, form: string, title = 'vtk output'): string =>
  `# vtk DataFile Version ${version}\n${title}\n${form}\nDATASET POLYDATA\n`;
const points = `POINTS 4 float\n${places.join(' ')} \n\n`;
const longs = (...numbers: number[]): BigInt64Array => BigInt64Array.from(numbers, BigInt);

const text = `${head('4.2', 'ASCII')}${points}POLYGONS 2 9\n3 0 2 1 \n4 0 1 2 3 \n\n`;
const files: Readonly<Record<string, Uint8Array<ArrayBuffer>>> = {
  'of version 4.2 in text': join(text),
  'of version 5.1 in text': join(
    `${head('5.1', 'ASCII')}${points}POLYGONS 3 7\nOFFSETS vtktypeint64\n0 3 7 \nCONNECTIVITY vtktypeint64\n0 2 1 0 1 2 3 \n\n`,
  ),
  'of version 4.2 in numbers': join(
    head('4.2', 'BINARY'),
    'POINTS 4 float\n',
    Float32Array.from(places),
    '\nPOLYGONS 2 9\n',
    Int32Array.of(3, 0, 2, 1, 4, 0, 1, 2, 3),
    '\n',
  ),
  'of version 5.1 in numbers': join(
    head('5.1', 'BINARY'),
    'FIELD FieldData 1\nfd 1 2 float\n',
    Float32Array.of(1, 2),
    '\nMETADATA\nINFORMATION 0\n\nPOINTS 4 float\n',
    Float32Array.from(places),
    '\nPOLYGONS 3 7\nOFFSETS vtktypeint64\n',
    longs(0, 3, 7),
    '\nCONNECTIVITY vtktypeint64\n',
    longs(0, 2, 1, 0, 1, 2, 3),
    '\n',
  ),
};

const read = (bytes: Uint8Array<ArrayBuffer> | string): Promise<Mesh> =>
  readMesh(typeof bytes === 'string' ? new TextEncoder().encode(bytes) : bytes, 'a.vtk');

describe('surfaces of VTK', () => {
  for (const [name, bytes] of Object.entries(files)) {
    it(`are read: ${name}`, async () => {
      const { positions, indices, space, left } = await read(bytes);
      expect([...positions]).to.deep.equal(places);
      expect([...indices]).to.deep.equal([0, 2, 1, 0, 1, 2, 0, 2, 3]);
      expect([space, left]).to.deep.equal([null, undefined]);
    });

    it(`cut short are refused in words: ${name}`, async () => {
      for (let length = 30; length < bytes.length; length += 3)
        expect(await refusalOf(bytes.slice(0, length), 'a.vtk')).to.match(
          /^(3 triangles|format\/(corrupt: the VTK file|unsupported: the VTK file))/,
        );
    });
  }

  it('have strips as triangles that all look the same way', async () => {
    const { indices } = await read(`${head('3.0', 'ASCII')}${points}TRIANGLE_STRIPS 1 5\n4 0 1 2 3\n`);
    expect([...indices]).to.deep.equal([0, 1, 2, 2, 1, 3]);
  });

  it('of 3D Slicer say which way their axes run', async () => {
    const slicer = text.replace('vtk output', '3D Slicer output. SPACE=LPS');
    expect((await read(slicer)).space).to.equal('lps');
    const { low, high } = await surfaceOf(slicer, { name: 'a.vtk' });
    expect([low, high].map((corner) => corner.map((x) => x + 0))).to.deep.equal([
      [-10, -20, 0],
      [0, 0, 30],
    ]);
  });

  it('say what is not shown', async () => {
    const colors = 'POINT_DATA 4\nCOLOR_SCALARS c 3\n1 0 0 0 1 0 0 0 1 1 1 1\n';
    const { left } = await read(`${text}LINES 1 3\n2 0 1\n\n${colors}`);
    expect(left).to.deep.equal(['not shown: lines, colours']);
  });

  it('are refused where they are none, or lie', async () => {
    for (const [change, by, refusal] of [
      ['POLYDATA', 'UNSTRUCTURED_GRID', /^format\/unsupported: the VTK file is of the kind UNSTRUCTURED_GRID/],
      ['ASCII', 'HEX', /^format\/corrupt: the VTK file is "HEX"/],
      ['POINTS 4', 'POINTS 99999999999', /^format\/too-large/],
      ['POINTS 4', 'POINTS 4000000', /^format\/corrupt: the VTK file ends early/],
      ['POINTS 4 float', 'POINTS 4 string', /^format\/corrupt: .*"string"/],
      ['POINTS 4 float', 'POINTS 4 constructor', /^format\/corrupt: .*"constructor"/],
      ['POLYGONS 2 9', 'POLYGONS 3 9', /^format\/corrupt: .*fewer corners/],
      ['4 0 1 2 3', '4 0 1 2 x', /^format\/corrupt: .*no number/],
      ['4 0 1 2 3', '4 0 1 2 9', /^format\/corrupt: .*vertex 9/],
      ['4 0 1 2 3', '4 0 1 2 -1', /^format\/corrupt: .*corner -1/],
      ['POLYGONS', 'PLYGONS', /^format\/corrupt: .*"PLYGONS"/],
    ] as const)
      expect(await refusalOf(text.replace(change, by), 'a.vtk'), by).to.match(refusal);
  });
});
