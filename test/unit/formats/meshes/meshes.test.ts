// Surfaces from files: STL, OBJ, PLY, GIfTI and glTF, against trimesh and nibabel, and what is refused of bad ones.
import { expect } from '@esm-bundle/chai';
import { makeNormals } from '../../../../src/formats/meshes/make-normals.ts';
import { maxPartVertices, splitMesh } from '../../../../src/formats/meshes/split-mesh.ts';
import { readXml } from '../../../../src/formats/base/read-xml.ts';
import { dot } from '../../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { fetchFixture } from '../../../helpers/decode.ts';
import { ballPly, describeSurface, refusalOf, surfaceOf, trianglesOf } from '../../../helpers/meshes.ts';

interface Expected {
  readonly triangles: number;
  readonly area: number;
  readonly volume: number;
  readonly center: Vector3;
  readonly bounds: readonly [Vector3, Vector3];
}

const expected = async (): Promise<Record<string, Expected>> =>
  (
    JSON.parse(new TextDecoder().decode(await fetchFixture('mesh-fixtures.json'))) as {
      meshes: Record<string, Expected>;
    }
  ).meshes;
const close = (found: number, wanted: number): void =>
  void expect(Math.abs(found - wanted), `${found} for ${wanted}`).to.be.at.most(2e-6 * Math.max(1, Math.abs(wanted)));

describe('files of surfaces', () => {
  it('are what trimesh and nibabel read in them', async () => {
    const all = await expected();
    expect(Object.keys(all)).to.have.length(11);
    for (const [name, wanted] of Object.entries(all)) {
      const found = describeSurface(await surfaceOf(await fetchFixture(`meshes/${name}`), { name, space: 'ras' }));
      expect(found.triangles, name).to.equal(wanted.triangles);
      close(found.area, wanted.area);
      close(found.volume, wanted.volume);
      found.center.forEach((x, axis) => close(x, wanted.center[axis]));
      found.bounds.forEach((corner, i) => corner.forEach((x, axis) => close(x, wanted.bounds[i][axis])));
    }
  });

  it('keep colours and normals, which are made where there are none', async () => {
    const colored = await surfaceOf(await fetchFixture('meshes/little.ply'));
    const text = await surfaceOf(await fetchFixture('meshes/text.ply'));
    expect(colored.parts[0].colors![0] * 255).to.be.closeTo(Math.round(colored.parts[0].colors![0] * 255), 1e-4);
    expect([...text.parts[0].colors!].slice(0, 30)).to.deep.equal([...colored.parts[0].colors!].slice(0, 30));
    const ball = await surfaceOf(ballPly([3, -4, 5], 10, 24));
    const [{ positions, normals }] = ball.parts;
    for (let i = 0; i < positions.length; i += 3) {
      const out =
        dot(
          [positions[i] - 3, positions[i + 1] + 4, positions[i + 2] - 5],
          [normals[i], normals[i + 1], normals[i + 2]],
        ) / 10;
      expect(out).to.be.above(0.999);
    }
    // What is no share of light would be white, or no number.
    for (const [color, isOne] of [
      ['0 0.5 1', true],
      ['0 128 255', false],
      ['-0.5 0 0', false],
    ] as const) {
      const [part] = (
        await surfaceOf(`v 0 0 0 ${color}\nv 1 0 0 ${color}\nv 0 1 0 ${color}\nf 1 2 3\n`, { name: 'a.obj' })
      ).parts;
      expect(part.colors !== null, color).to.equal(isOne);
    }
    // Edges of a box stay edges: three normals in each corner, along the axes.
    const [box] = (await surfaceOf(await fetchFixture('meshes/big.ply'))).parts;
    expect(box.positions.length / 3).to.equal(24);
    for (let i = 0; i < box.normals.length; i += 3)
      expect(Math.max(...box.normals.subarray(i, i + 3).map(Math.abs))).to.equal(1);
  });

  it('of PLY may have colours by older names, and those of faces are said', async () => {
    const ply = (vertex: string, colors: string, face: string, own: string): string =>
      `ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n${vertex}element face 1\nproperty list uchar int vertex_index\n${face}end_header\n${[0, 1, 2].map((i) => `${i} ${i * i} 0${colors}\n`).join('')}3 0 1 2${own}\n`;
    const names = (before: string): string =>
      ['red', 'green', 'blue'].map((name) => `property uchar ${before}${name}\n`).join('');
    // vtkPLYReader (VTK 9.7.2) reads diffuse_red as red, too.
    for (const before of ['', 'diffuse_']) {
      const { parts, notes } = await surfaceOf(ply(names(before), ' 255 51 0', '', ''));
      expect([...parts[0].colors!.subarray(0, 3)]).to.deep.equal([1, Math.fround(0.2), 0]);
      expect(notes).to.deep.equal([]);
    }
    const { parts, notes } = await surfaceOf(ply('', '', names(''), ' 255 51 0'));
    expect([parts[0].colors, notes]).to.deep.equal([null, ['not shown: colours of faces']]);
  });

  it('say which way their axes run, and an attribute says it better', async () => {
    const stl = (title: string): string =>
      `solid ${title}\nfacet normal 0 0 1\nouter loop\nvertex 1 2 3\nvertex 2 2 3\nvertex 1 4 3.5e0\nendloop\nendfacet\nendsolid\n`;
    const firstOf = async (text: string, space: 'ras' | 'lps' | null = null): Promise<number[]> =>
      trianglesOf(await surfaceOf(text, { space }))[0][0] as unknown as number[];
    expect(await firstOf(stl('plain'))).to.deep.equal([1, 2, 3]);
    expect(await firstOf(stl('3D Slicer output. SPACE=LPS'))).to.deep.equal([-1, -2, 3]);
    expect(await firstOf(stl('3D Slicer output. SPACE=LPS'), 'ras')).to.deep.equal([1, 2, 3]);
    expect(await firstOf(stl('plain'), 'lps')).to.deep.equal([-1, -2, 3]);
  });

  it('of OBJ may have polygons, numbers from the end, lines that go on, and colours', async () => {
    const text =
      '# SPACE=RAS\nmtllib a.mtl\no thing\nv 0 0 0 1 0 0\nv 2 0 0 0 1 0\nv 2 2 0 0 0 1\nv 0 2 0 .5 .5 .5\nvt 0 0\nvn 0 0 2\nusemtl m\nf -4//1 -3//1 \\\n  -2//1 -1//1 # a square\ns off\nl 1 2\n';
    const surface = await surfaceOf(text, { name: 'a.obj' });
    expect(trianglesOf(surface)).to.deep.equal([
      [
        [0, 0, 0],
        [2, 0, 0],
        [2, 2, 0],
      ],
      [
        [0, 0, 0],
        [2, 2, 0],
        [0, 2, 0],
      ],
    ]);
    expect([...surface.parts[0].normals]).to.deep.equal([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]);
    expect([...surface.parts[0].colors!.subarray(0, 6)]).to.deep.equal([1, 0, 0, 0, 1, 0]);
    expect(await refusalOf('v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 4\n')).to.match(
      /^format\/corrupt: .*got "4" in a face in line 4.* of which there are 3/,
    );
    expect(await refusalOf('v 0 0 0\nv 1 0\nf 1 2 1\n')).to.match(/^format\/corrupt: .*line 2/);
  });

  it('are refused before there is room for a thousand million triangles', async () => {
    const stl = new Uint8Array(84 + 50);
    new DataView(stl.buffer).setUint32(80, 1e9, true);
    const ply = (vertices: number, faces: number): string =>
      `ply\nformat binary_little_endian 1.0\nelement vertex ${vertices}\nproperty float x\nproperty float y\nproperty float z\nelement face ${faces}\nproperty list uchar int vertex_indices\nend_header\n`;
    const gii = (await fetchFixture('meshes/text.surf.gii').then((bytes) => new TextDecoder().decode(bytes))).replace(
      /Dim0="80"/,
      'Dim0="1000000000"',
    );
    expect(await refusalOf(stl, 'a.stl')).to.match(
      /^format\/too-large: the STL has 1,000,000,000 triangles or more; expected at most 5,000,000/,
    );
    expect(await refusalOf(ply(8, 1e9))).to.match(/^format\/too-large/);
    expect(await refusalOf(ply(1e12, 8))).to.match(/^format\/too-large/);
    expect(await refusalOf(gii)).to.match(/^format\/too-large: .*1,000,000,000 triangles/);
    // As many as may be, and not there.
    expect(await refusalOf(ply(15e6, 5e6))).to.match(/^format\/corrupt: .*ends early/);
  });

  it('are refused where they are damaged, are no surface, or of another kind', async () => {
    const stl = (vertex: string): string =>
      `solid a\nfacet normal 0 0 1\nouter loop\nvertex ${vertex}\nvertex 2 2 3\nvertex 1 4 3\nendloop\nendfacet\n`;
    expect(await refusalOf(stl('nan 2 3'))).to.match(/^format\/corrupt: .*line 4/);
    expect(await refusalOf(stl('1e30 2 3'))).to.match(/^format\/corrupt: .*finite/);
    expect(await refusalOf(stl('2 2 3'))).to.match(/^format\/unsupported: .*no triangles/);
    const big = await fetchFixture('meshes/little.ply');
    new DataView(big.buffer, big.byteOffset + big.length - 80 * 13).setInt32(1, 42, true);
    expect(await refusalOf(big)).to.match(
      /^format\/corrupt: the PLY has a triangle with the vertex 42; expected numbers from 0 to 41/,
    );
    const nan = await fetchFixture('meshes/binary.stl');
    new DataView(nan.buffer, nan.byteOffset).setFloat32(84 + 12, Number.NaN, true);
    expect(await refusalOf(nan)).to.match(/^format\/corrupt: .*vertex, number 0, at NaN/);
    expect(
      await refusalOf(
        'ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n',
      ),
    ).to.match(/cloud of points/);
    for (const header of ['format', 'format ascii 1.0\nelement'])
      expect(
        await refusalOf(
          `ply\n${header}\nelement vertex 3\nproperty float x\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n`,
        ),
        header,
      ).to.match(/^format\/corrupt: the PLY has /);
    expect(await refusalOf('<VTKFile type="PolyData">')).to.match(
      /^format\/unknown: some\.mesh is a VTK file in XML; expected a surface of triangles: STL, OBJ, PLY, VTK \(legacy\), GIfTI/,
    );
    expect(await refusalOf('<!doctype html><p>Not found')).to.match(/^format\/unknown: some\.mesh is a web page/);
    expect(await refusalOf('hello')).to.match(/^format\/unknown/);
    expect(await refusalOf('')).to.match(/^format\/unknown/);
    expect(await refusalOf('<?xml version="1.0"?><svg></svg>')).to.match(
      /^format\/unknown: the file is an XML of "svg"/,
    );
    const gii = new TextDecoder().decode(await fetchFixture('meshes/base64.surf.gii'));
    expect(await refusalOf(gii.replace(/Base64Binary/g, 'ExternalFileBinary'))).to.match(
      /^format\/unsupported: .*ExternalFileBinary/,
    );
    expect(await refusalOf(gii.replace('NIFTI_INTENT_TRIANGLE', 'NIFTI_INTENT_SHAPE'))).to.match(
      /^format\/unsupported: .*none of triangles/,
    );
    expect(await refusalOf(gii.replace(/Dim0="42"/, 'Dim0="43"'))).to.match(/^format\/corrupt: .*fewer numbers/);
  });

  it('cut short or changed anywhere are read or refused in words', async () => {
    let state = 7;
    const random = (below: number): number =>
      Math.floor(((state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32) * below);
    for (const name of Object.keys(await expected())) {
      const bytes = await fetchFixture(`meshes/${name}`);
      const outcomes = new Set<string>();
      for (let i = 0; i < 60; i++) {
        const damaged = i % 2 ? bytes.slice(0, random(bytes.length)) : bytes.slice();
        if (i % 2 === 0) for (let change = 0; change < 3; change++) damaged[random(damaged.length)] = random(256);
        const found = await refusalOf(damaged, name);
        expect(found).to.match(/^(\d+ triangles|format\/(corrupt|unknown|unsupported|too-large): .{20,})/s);
        expect(found).not.to.contain('internal');
        outcomes.add(found.split(':')[0]);
      }
      expect(outcomes.size, name).to.be.above(1);
    }
  });

  it('of many vertices are cut into parts that short indices reach', () => {
    const side = 257;
    const positions = Float32Array.from(
      { length: 3 * side * side },
      (_, i) => [Math.floor(i / 3) % side, Math.floor(i / 3 / side), 0][i % 3],
    );
    const squares = Array.from(
      { length: (side - 1) ** 2 },
      (_, i) => Math.floor(i / (side - 1)) * side + (i % (side - 1)),
    );
    const indices = Uint32Array.from(
      squares.flatMap((at) => [at, at + 1, at + side, at + 1, at + side + 1, at + side]),
    );
    const mesh = makeNormals({ positions, normals: null, indices, colors: null, space: null, format: 'test' });
    const parts = splitMesh(mesh);
    expect(parts).to.have.length(2);
    for (const part of parts) {
      expect(part.positions.length / 3).to.be.at.most(maxPartVertices);
      expect([...part.normals.subarray(0, 3)]).to.deep.equal([0, 0, 1]);
    }
    const found = trianglesOf({ parts });
    const wanted = Array.from({ length: indices.length / 3 }, (_, i) =>
      [...indices.subarray(3 * i, 3 * i + 3)].map((at) => [at % side, Math.floor(at / side), 0]),
    );
    expect(JSON.stringify(found)).to.equal(JSON.stringify(wanted));
  });

  it('of XML are read without entities of their own', () => {
    const reported: string[] = [];
    readXml(
      '<?xml version="1.0"?><!DOCTYPE a [<!ENTITY e "ha">]><a b="1 &lt; 2" c=\'&#65;&#x42;\'><!-- <no> -->x &amp; &e;<d/><![CDATA[<&amp;]]></a>',
      {
        open: (name, attributes) => reported.push(`<${name} ${[...attributes].join(' ')}`),
        close: (name) => reported.push(`/${name}`),
        text: (text) => reported.push(text),
      },
    );
    expect(reported).to.deep.equal(['<a b,1 < 2 c,AB', 'x & &e;', '<d ', '/d', '<&amp;', '/a']);
    for (const bad of ['<a', '<a><b></a>', '<a>', '<a b=c></a>', '<a><![CDATA[', '<'.repeat(9), '<a>'.repeat(200)]) {
      expect(() => readXml(bad, { open: () => {}, close: () => {}, text: () => {} }), bad.slice(0, 20)).to.throw(
        SyntaxError,
      );
    }
  });
});
