// FreeSurfer's surfaces. nibabel 5.4.2 (freesurfer.read_geometry) reads these places; those of the scanner are Norig * inverse(Torig) of them, the
// matrices that `mri_info --vox2ras` and `--vox2ras-tkr` print for the volume.
import { expect } from '@esm-bundle/chai';
import { readMesh } from '../../../../src/formats/meshes/read-mesh.ts';
import type { Mesh } from '../../../../src/formats/meshes/mesh.ts';
import { refusalOf, surfaceOf } from '../../../helpers/meshes.ts';

const places = [0, 0, 0, 10, 0, 0, 0, 20, 0, 0, 0, 30];
const corners = [0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2];

interface Volume {
  readonly axes?: string;
  readonly valid?: number;
  /** Numbers before the text. */
  readonly tags?: readonly number[];
}

const coronal = 'xras   = -1 0 0\nyras   = 0 0 -1\nzras   = 0 1 0\ncras   = 1.5 -2 3\n';
const tilted = 'xras   = -0.8 0.6 0\nyras   = 0 0 -1\nzras   = 0.6 0.8 0\ncras   = 1.5 -2 3\n';

function surfaceBytes(volume: Volume | null): Uint8Array<ArrayBuffer> {
  const head = new TextEncoder().encode('created by x on Mon\n\n');
  const { axes = coronal, valid = 1, tags = [20] } = volume ?? {};
  const text = volume
    ? `valid = ${valid}  # volume info valid\nfilename = orig.mgz\nvolume = 256 256 256\nvoxelsize = 1 1 1\n${axes}`
    : '';
  const own = volume ? tags : [];
  const start = 3 + head.length;
  const size = 8 + 4 * (places.length + corners.length + own.length);
  const bytes = new Uint8Array(start + size + text.length);
  const view = new DataView(bytes.buffer);
  bytes.set([255, 255, 254, ...head]);
  [places.length / 3, corners.length / 3].forEach((n, i) => view.setInt32(start + 4 * i, n));
  places.forEach((n, i) => view.setFloat32(start + 8 + 4 * i, n));
  [...corners, ...own].forEach((n, i) => view.setInt32(start + 8 + 4 * (places.length + i), n));
  bytes.set(new TextEncoder().encode(text), start + size);
  return bytes;
}

const read = (volume: Volume | null): Promise<Mesh> => readMesh(surfaceBytes(volume), 'lh.pial');

const moved = [1.5, -2, 3, 11.5, -2, 3, 1.5, 18, 3, 1.5, -2, 33];

describe('surfaces of FreeSurfer', () => {
  for (const [what, volume, expected] of [
    ['in a coronal volume', {}, moved],
    ['after the mark of the older form', { tags: [2, 0, 20] }, moved],
    ['in a tilted volume', { axes: tilted }, [1.5, -2, 3, 9.5, -8, 3, 13.5, 14, 3, 1.5, -2, 33]],
    ['that are those of the scanner already', { tags: [2, 1, 20] }, places],
    ['in a volume that is not valid', { valid: 0 }, places],
    ['in a volume without its middle', { axes: coronal.replace('cras', 'none') }, places],
    ['without a volume', null, places],
  ] as const)
    it(`have places of the scanner: ${what}`, async () => {
      const { positions, indices, format, left, space } = await read(volume);
      for (const [i, place] of positions.entries()) expect(place, String(i)).to.be.closeTo(expected[i], 1e-5);
      expect([...indices]).to.deep.equal(corners);
      expect([format, space]).to.deep.equal(['FreeSurfer surface', null]);
      const isKnown = expected !== places || what.includes('already');
      expect(left?.length ?? 0).to.equal(isKnown ? 0 : 1);
    });

  it('are drawn', async () => {
    const { triangles, low, high } = await surfaceOf(surfaceBytes({}), { name: 'lh.pial' });
    expect([triangles, low, high]).to.deep.equal([4, [1.5, -2, 3], [11.5, 18, 33]]);
  });

  it('that are damaged, or none, are refused in words', async () => {
    const whole = surfaceBytes({});
    for (let length = 3; length < whole.length; length += 7)
      expect(await refusalOf(whole.slice(0, length), 'lh.pial')).to.match(
        /^(4 triangles|format\/corrupt: the FreeSurfer)/,
      );
    const many = whole.slice();
    new DataView(many.buffer).setInt32(3 + 21, 2 ** 30);
    expect(await refusalOf(many, 'lh.pial')).to.match(/^format\/too-large: the FreeSurfer surface has 1,073,741,824/);
    new DataView(many.buffer).setInt32(3 + 21, -1);
    expect(await refusalOf(many, 'lh.pial')).to.match(/^format\/corrupt/);
    for (const mark of [253, 255])
      expect(await refusalOf(Uint8Array.of(255, 255, mark, 0, 0, 0, 9), 'lh.curv')).to.match(
        /^format\/unknown: lh\.curv is a FreeSurfer file without triangles/,
      );
  });
});
