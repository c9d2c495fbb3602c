// Surfaces of glTF files: axes and units, how triangles follow one another, colours, and what is refused. test/unit/formats/meshes/meshes.test.ts has what trimesh reads in two.
import { expect } from '@esm-bundle/chai';
import { noteOnPlace } from '../../../../src/viewer/attachments/note-on-place.ts';
import { cartesianGrid } from '../../../../src/volume/grid.ts';
import { add, scaleAndTranslate, subtract } from '../../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { fetchFixture } from '../../../helpers/decode.ts';
import { refusalOf, surfaceOf, trianglesOf } from '../../../helpers/meshes.ts';

type Part = Record<string, unknown>;

const base64 = (numbers: ArrayBufferView<ArrayBuffer>): string =>
  btoa(String.fromCharCode(...new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength)));
const square = Float32Array.of(0, 0, 0, 1, 0, 0, 1, 2, 0, 0, 2, 0);

/** A glTF of one mesh; what is said replaces what is usual. */
function gltfOf(primitive: Part = {}, more: Part = {}, data: Float32Array<ArrayBuffer> = square): string {
  const corners = Uint16Array.of(0, 1, 2, 0, 2, 3);
  return JSON.stringify({
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1, ...primitive }] }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 4, type: 'VEC3' },
      { bufferView: 1, componentType: 5123, count: 6, type: 'SCALAR' },
      { bufferView: 0, byteOffset: 12, componentType: 5126, count: 3, type: 'VEC3' },
    ],
    bufferViews: [
      { buffer: 0, byteLength: data.byteLength },
      { buffer: 1, byteLength: 12 },
    ],
    buffers: [data, corners].map((numbers) => ({
      byteLength: numbers.byteLength,
      uri: `data:application/octet-stream;base64,${base64(numbers)}`,
    })),
    asset: { version: '2.0' },
    ...more,
  });
}

const trianglesIn = async (text: string): Promise<unknown> => trianglesOf(await surfaceOf(text, { space: 'ras' }));

describe('glTF', () => {
  it('is in metres with y up, and looks to +z; an attribute says it better', async () => {
    const [first] = trianglesOf(await surfaceOf(gltfOf()));
    // Its right is at -x: 1 m to the left, 2 m towards the head.
    expect(first).to.deep.equal([
      [-0, 0, 0],
      [-1000, 0, 0],
      [-1000, 0, 2000],
    ]);
    expect(trianglesOf(await surfaceOf(gltfOf(), { space: 'ras' }))[0]).to.deep.equal([
      [0, 0, 0],
      [1, 0, 0],
      [1, 2, 0],
    ]);
    expect(trianglesOf(await surfaceOf(gltfOf(), { space: 'lps' }))[0]).to.deep.equal([
      [-0, -0, 0],
      [-1, -0, 0],
      [-1, -2, 0],
    ]);
    // Seen from the front it has its front: the normal looks there.
    expect([...(await surfaceOf(gltfOf())).parts[0].normals.subarray(0, 3)]).to.deep.equal([-0, 1, 0]);
  });

  it('has triangles in lists, strips and fans, with or without a list of corners', async () => {
    const two = [
      [
        [0, 0, 0],
        [1, 0, 0],
        [1, 2, 0],
      ],
      [
        [0, 0, 0],
        [1, 2, 0],
        [0, 2, 0],
      ],
    ];
    expect(await trianglesIn(gltfOf())).to.deep.equal(two);
    expect(await trianglesIn(gltfOf({ mode: 6, indices: undefined }))).to.deep.equal(two);
    const strip = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 2, 0, 1, 2, 0);
    expect(await trianglesIn(gltfOf({ mode: 5, indices: undefined }, {}, strip))).to.deep.equal([
      [
        [0, 0, 0],
        [1, 0, 0],
        [0, 2, 0],
      ],
      [
        [1, 0, 0],
        [1, 2, 0],
        [0, 2, 0],
      ],
    ]);
    expect(await trianglesIn(gltfOf({ indices: undefined }))).to.deep.equal(two.slice(0, 1));
    // Points and lines beside them are left out.
    const lines = {
      meshes: [
        {
          primitives: [
            { attributes: { POSITION: 0 }, mode: 1 },
            { attributes: { POSITION: 0 }, indices: 1 },
          ],
        },
      ],
    };
    expect(await trianglesIn(gltfOf({}, lines))).to.deep.equal(two);
  });

  it('has nodes within nodes, and shows its scene alone', async () => {
    const nodes = [
      { translation: [10, 0, 0], children: [1] },
      { rotation: [0, 0, Math.SQRT1_2, Math.SQRT1_2], scale: [2, 1, 1], mesh: 0 },
      { mesh: 0, translation: [0, 0, 99] },
    ];
    const [[a, b, c]] = (await trianglesIn(
      gltfOf({}, { nodes, scenes: [{ nodes: [2] }, { nodes: [0] }], scene: 1 }),
    )) as number[][][];
    for (const [found, wanted] of [
      [a, [10, 0, 0]],
      [b, [10, 2, 0]],
      [c, [8, 2, 0]],
    ] as const)
      found.forEach((x, i) => expect(x).to.be.closeTo(wanted[i], 1e-5));
    // Without scenes: all that stands in no other.
    expect(await trianglesIn(gltfOf({}, { nodes, scenes: undefined }))).to.have.length(4);
  });

  it('has colours of vertices and of materials, as light: they become those of a screen', async () => {
    const colorOf = async (primitive: Part, more: Part = {}): Promise<readonly number[] | null> => {
      const { colors } = (await surfaceOf(gltfOf(primitive, more))).parts[0];
      return colors && [...colors.subarray(0, 3)].map((share) => Math.round(255 * share));
    };
    const materials = [{ pbrMetallicRoughness: { baseColorFactor: [1, 0.214, 0, 0.5] } }];
    expect(await colorOf({})).to.equal(null);
    expect(await colorOf({ material: 0 }, { materials: [{}] })).to.equal(null);
    // 0.2140 of the light is 127.5 of 255 in sRGB.
    expect(await colorOf({ material: 0 }, { materials })).to.deep.equal([255, 127, 0]);
    const attributes = { POSITION: 0, COLOR_0: 2 };
    expect(await colorOf({ attributes })).to.deep.equal([255, 0, 0]);
    expect(
      await colorOf(
        { attributes, material: 0 },
        { materials: [{ pbrMetallicRoughness: { baseColorFactor: [0.214, 1, 1, 1] } }] },
      ),
    ).to.deep.equal([127, 0, 0]);
  });

  it('may have numbers that stand apart, and in few bits', async () => {
    // Only two of four places are given; the others are 0.
    const sparse = {
      count: 2,
      indices: { bufferView: 2, componentType: 5121 },
      values: { bufferView: 0, byteOffset: 12 },
    };
    const parts = JSON.parse(gltfOf()) as { buffers: Part[]; bufferViews: Part[]; accessors: Part[] };
    parts.buffers.push({ byteLength: 2, uri: `data:;base64,${base64(Uint8Array.of(1, 2))}` });
    parts.bufferViews.push({ buffer: 2, byteLength: 2 });
    parts.accessors[0] = { componentType: 5126, count: 4, type: 'VEC3', sparse };
    expect(((await trianglesIn(JSON.stringify(parts))) as unknown[])[0]).to.deep.equal([
      [0, 0, 0],
      [1, 0, 0],
      [1, 2, 0],
    ]);
    const bytes = JSON.parse(
      gltfOf({}, { extensionsRequired: ['KHR_mesh_quantization', 'KHR_materials_unlit'] }),
    ) as typeof parts;
    bytes.buffers[0] = {
      byteLength: 16,
      uri: `data:;base64,${base64(Int8Array.of(0, 0, 0, 9, 127, 0, 0, 9, 127, -127, 0, 9, 0, -127, 0, 9))}`,
    };
    bytes.bufferViews[0] = { buffer: 0, byteLength: 16, byteStride: 4 };
    bytes.accessors[0] = { bufferView: 0, componentType: 5120, normalized: true, count: 4, type: 'VEC3' };
    expect(((await trianglesIn(JSON.stringify(bytes))) as unknown[])[0]).to.deep.equal([
      [0, 0, 0],
      [1, 0, 0],
      [1, -1, 0],
    ]);
  });

  it('is refused where it needs more than is here', async () => {
    const refused = (more: Part): Promise<string> => refusalOf(gltfOf({}, more));
    expect(await refused({ extensionsRequired: ['KHR_draco_mesh_compression'] })).to.match(
      /^format\/unsupported: the glTF is packed or extended by KHR_draco_mesh_compression; expected plain data/,
    );
    expect(await refused({ buffers: [{ byteLength: 48, uri: 'scene.bin' }] })).to.match(
      /^format\/unsupported: the glTF has its data in another file, "scene\.bin"; expected one file: write it as \.glb/,
    );
    expect(await refused({ asset: { version: '1.0' } })).to.match(/^format\/unsupported: the glTF is of version 1\.0/);
    expect(await refused({ meshes: [{ primitives: [{ attributes: { POSITION: 0 }, mode: 0 }] }] })).to.match(
      /^format\/unsupported: the glTF has no triangles/,
    );
  });

  it('is refused before there is room for what it says that it has', async () => {
    const many = (count: number): Part => ({ accessors: [{ componentType: 5126, count, type: 'VEC3' }] });
    expect(await refusalOf(gltfOf({ indices: undefined }, many(1e9)))).to.match(
      /^format\/too-large: the glTF has 333,333,333 triangles/,
    );
    // One mesh of four vertices, as often as nodes say.
    const nodes = [
      { children: Array.from({ length: 5000 }, (_, i) => i + 1) },
      ...Array.from({ length: 5000 }, () => ({ mesh: 0 })),
    ];
    expect(await refusalOf(gltfOf({ indices: undefined }, { nodes, ...many(3_003) }))).to.match(
      /^format\/too-large: .* triangles or more/,
    );
    expect(await refusalOf(gltfOf({}, { nodes: Array.from({ length: 100_002 }, () => ({})), scenes: [] }))).to.match(
      /^format\/too-large: the glTF has more than 100,000 nodes/,
    );
    const normals = {
      accessors: [
        ...(JSON.parse(gltfOf()) as { accessors: Part[] }).accessors,
        { componentType: 5126, count: 2 ** 40, type: 'VEC3' },
      ],
    };
    expect(await refusalOf(gltfOf({ attributes: { POSITION: 0, NORMAL: 3 } }, normals))).to.match(
      /^format\/too-large: the glTF has 1,099,511,627,776 vertices/,
    );
    // A million animations' worth of numbers that no triangle needs is never read.
    expect(
      await trianglesIn(
        gltfOf(
          {},
          {
            accessors: [
              ...(JSON.parse(gltfOf()) as { accessors: Part[] }).accessors,
              { componentType: 5126, count: 2 ** 40, type: 'MAT4' },
            ],
          },
        ),
      ),
    ).to.have.length(2);
  });

  it('is refused where it is damaged', async () => {
    const damaged = /^format\/corrupt: the glTF /;
    for (const more of [
      { nodes: [{ mesh: 0, children: [0] }] },
      { nodes: [{ mesh: 7 }] },
      { nodes: 'all' },
      { nodes: [{ children: [-1] }] },
      { nodes: [{ matrix: [1, 2] }] },
      { nodes: [{ scale: [1, null, 1] }] },
      { accessors: [] },
      { bufferViews: [] },
      { buffers: [] },
      { meshes: [null] },
      {
        bufferViews: [
          { buffer: 0, byteLength: 48, byteOffset: 1000 },
          { buffer: 1, byteLength: 12 },
        ],
      },
      { accessors: [{ bufferView: 0, componentType: 5126, count: -4, type: 'VEC3' }] },
      {
        accessors: [
          { bufferView: 0, componentType: 1, count: 4, type: 'VEC3' },
          { bufferView: 1, componentType: 5123, count: 6, type: 'SCALAR' },
        ],
      },
      {
        buffers: [
          { byteLength: 48, uri: 'data:;base64,AAAA' },
          { byteLength: 12, uri: 'data:;base64,AAAA' },
        ],
      },
    ])
      expect(await refusalOf(gltfOf({}, more)), JSON.stringify(more)).to.match(damaged);
    const glb = await fetchFixture('meshes/scene.glb');
    for (const length of [4, 12, 20, 400, glb.length - 100])
      expect(await refusalOf(glb.slice(0, length)), String(length)).to.match(damaged);
    expect(await refusalOf('{"asset":{"version":"2.0"}')).to.match(damaged);
    expect(await refusalOf('{"asset":7}')).to.match(/^format\/unsupported/);
    expect(await refusalOf('{"layers":[]}')).to.match(/^format\/unknown/);
  });
});

describe('the place of a surface', () => {
  const grid = cartesianGrid([10, 10, 10], scaleAndTranslate([2, 2, 2], [100, 0, 0]));
  const ball = (middle: Vector3, radius: number): { low: Vector3; high: Vector3 } => ({
    low: subtract(middle, [radius, radius, radius]),
    high: add(middle, [radius, radius, radius]),
  });

  it('is reported where it is not the volume’s', () => {
    expect(noteOnPlace(ball([110, 10, 10], 5), grid)).to.equal(null);
    expect(noteOnPlace(ball([110, 10, 10], 150), grid)).to.equal(null);
    expect(noteOnPlace(ball([99, -1, -1], 0.5), grid)).to.equal(null);
    expect(noteOnPlace(ball([-110, 10, 10], 5), grid)).to.match(
      /^the surface spans -115 to -105, 5 to 15, 5 to 15 and the volume 99 to 119, -1 to 19, -1 to 19, .*space="lps"/,
    );
    expect(noteOnPlace(ball([110, 10, 10], 5000), grid)).to.match(/^the surface spans -4890 to 5110/);
  });
});
