// Structure sets of DICOM (RTSTRUCT): contours become labels.
import { expect } from '@esm-bundle/chai';
import { invertAffine, transformPoint } from '../../../../src/volume/matrix.ts';
import { ctSlice, dicomBytes } from '../../../helpers/dicom-bytes.ts';
import type { DicomFields } from '../../../helpers/dicom-bytes.ts';
import { circle, keyhole, regions, structureSetFields } from '../../../helpers/dicom-contours.ts';
import type { MadeRegion, Point } from '../../../helpers/dicom-contours.ts';
import { decodeFields, decodeSeries } from '../../../helpers/dicom-series.ts';
import type { Scan } from '../../../helpers/dicom-series.ts';
import { expectError } from '../../../helpers/decode.ts';

const read = (made: readonly MadeRegion[], fields: DicomFields = {}): Promise<Scan> =>
  decodeFields([{ ...structureSetFields(made), ...fields }]);

async function refuse(fields: DicomFields, code: string, words: RegExp): Promise<void> {
  const error = await expectError(decodeFields([fields]));
  expect(error.code, error.message).to.equal(code);
  expect(error.message).to.match(words);
}

/** Of a label: its voxels in each plane, and the mean of their places. */
function measure({ grid: { dimensions, indexToWorld }, ids, samples }: Scan, id: number): [number[], number[]] {
  const [nx, ny, nz] = dimensions;
  const counts = Array.from({ length: nz }, () => 0);
  const sum = [0, 0, 0];
  samples.forEach((stored, at) => {
    if ((ids?.[stored] ?? stored) !== id) return;
    const [i, j, k] = [at % nx, Math.floor(at / nx) % ny, Math.floor(at / (nx * ny))];
    counts[k]++;
    for (const [axis, index] of [i, j, k].entries()) sum[axis] += index;
  });
  const total = counts.reduce((all, one) => all + one, 0);
  const [i, j, k] = sum.map((one) => one / total);
  return [counts, [...transformPoint(indexToWorld, [i, j, k])]];
}

const near = (got: readonly number[], expected: readonly number[], by: number): void =>
  got.forEach((one, i) => expect(one, `axis ${i}`).to.be.closeTo(expected[i], by));

const square = (half: number, z: number, x = 0): Point[] => [
  [x - half, -half, z],
  [x + half, -half, z],
  [x + half, half, z],
  [x - half, half, z],
];
const one = (contours: MadeRegion['contours'], number = 1): MadeRegion => ({ number, name: 'One', contours });

describe('structure sets of DICOM', () => {
  // scikit-image 0.26.0, measure.points_in_poly of the middles of the voxels, each contour turning what is inside; read with pydicom 3.0.2.
  it('cover the voxels whose middles lie inside, with holes, also those of one line, as scikit-image finds them', async () => {
    const volume = await read(regions);
    expect(volume.grid.dimensions).to.deep.equal([192, 192, 5]);
    near([...volume.grid.spacing], [0.3125, 0.3125, 2.5], 1e-9);
    expect(volume).to.include({ format: 'DICOM, RTSTRUCT', isDiscrete: true, anatomical: true });
    const expected: readonly (readonly [id: number, counts: number[], middle: number[]])[] = [
      [1, [27496, 22781, 24133, 22781, 28848], [-5.1095, 10.2211, -4.9464]],
      [2, [0, 4715, 4715, 4715, 0], [-8.9972, 7.9849, -5]],
      [7, [1352, 1352, 0, 1352, 0], [12.3438, 10.1562, -6.6667]],
    ];
    for (const [id, counts, middle] of expected) {
      const [got, place] = measure(volume, id);
      expect(got, String(id)).to.deep.equal(counts);
      near(place, middle, 1e-4);
    }
  });

  // dcmrtstruct2nii 5, of the same file with a CT of 80 x 80 x 5 voxels of 1 x 1 x 2.5 mm from (-34.63, -49.77, -10) on: 14,095, 384 and 1,383.
  // It rounds contours to pixels in another way: of the voxels at their edges 60, 0 and 21 differ.
  it('cover as much of a CT as dcmrtstruct2nii finds', async () => {
    const { grid, ids, samples } = await read(regions);
    const worldToIndex = invertAffine(grid.indexToWorld)!;
    const counts = new Map<number, number>();
    for (let at = 0; at < 80 * 80 * 5; at++) {
      const [i, j, k] = [at % 80, Math.floor(at / 80) % 80, Math.floor(at / 6400)];
      const place = transformPoint(worldToIndex, [34.63 - i, 49.77 - j, 2.5 * k - 10]).map(Math.round);
      if (place.some((index, axis) => index < 0 || index >= grid.dimensions[axis])) continue;
      const stored = samples[(place[2] * grid.dimensions[1] + place[1]) * grid.dimensions[0] + place[0]];
      const id = ids?.[stored] ?? stored;
      counts.set(id, (counts.get(id) ?? 0) + 1);
    }
    const body = [1, 2, 7].reduce((sum, id) => sum + counts.get(id)!, 0);
    expect(Math.abs(body - 14_095)).to.be.below(60);
    expect(counts.get(7)).to.equal(384);
    expect(Math.abs(counts.get(2)! - 1383)).to.be.below(21);
  });

  it('bring names and colours, and say which regions have gaps, and which hide others', async () => {
    const { named, left } = await read(regions);
    expect(named).to.deep.equal([
      { id: 1, name: 'Body', color: [0, 1, 0] },
      { id: 2, name: 'Tube', color: [1, 0, 0.2] },
      { id: 7, name: 'Keyhole', color: null },
    ]);
    expect(left).to.deep.equal([
      'region 7 has no contour in 1 of the 4 planes from its first to its last one, and no label there',
      '14,145 of the 144,240 voxels of region 1 are hidden by region 2, which overlaps it',
      '4,056 of the 144,240 voxels of region 1 are hidden by region 7, which overlaps it',
    ]);
  });

  it('show the smaller region where they overlap, whatever their numbers', async () => {
    const [small, large] = [one([square(2, 0), square(2, 3)], 1), one([square(8, 0), square(8, 3)], 9)];
    for (const made of [
      [small, large],
      [large, small],
    ]) {
      const [counts] = measure(await read(made), 1);
      expect(counts[0]).to.be.above(0);
      expect(counts[1]).to.equal(counts[0]);
    }
  });

  it('lie in any orientation: a tilted cylinder has its volume at its place', async () => {
    const [u, v, n] = [
      [0.8, 0.6, 0],
      [-0.36, 0.48, 0.8],
      [0.48, -0.64, 0.6],
    ];
    const tilt = ([x, y, z]: Point): Point => [0, 1, 2].map((i) => x * u[i] + y * v[i] + z * n[i]) as unknown as Point;
    const planes = [0, 3, 6, 9, 12].map((z) => circle([40, 20, z], 10, 64).map(tilt));
    const volume = await read([one(planes)]);
    expect(volume.grid.dimensions[2]).to.equal(5);
    const [counts, middle] = measure(volume, 1);
    const [dx, dy, dz] = volume.grid.spacing;
    expect(dz).to.be.closeTo(3, 1e-2);
    // Of a polygon of 64 corners.
    const area = 32 * 100 * Math.sin((2 * Math.PI) / 64);
    for (const count of counts) expect((count * dx * dy) / area).to.be.closeTo(1, 5e-3);
    const [x, y, z] = tilt([40, 20, 6]);
    near(middle, [-x, -y, z], 0.05);
    const sagittal = await read([one([1, 3, 5].map((x) => circle([0, 0, x], 5).map(([a, b, c]): Point => [c, a, b])))]);
    near(measure(sagittal, 1)[1], [-3, 0, 0], 1e-9);
  });

  it('of one plane are as thick as it says; contours next to the planes, points and open lines are left out, in words', async () => {
    const [flat] = structureSetFields([one([square(4, 1)])]).ROIContourSequence as readonly DicomFields[];
    const [contour] = flat.ContourSequence as readonly DicomFields[];
    const fields = (...contours: readonly DicomFields[]): DicomFields => ({
      ...structureSetFields([one([])]),
      ROIContourSequence: [{ ...flat, ContourSequence: contours }],
    });
    const volume = await decodeFields([
      fields(
        { ...contour, ContourSlabThickness: [4] },
        { ...contour, ContourGeometricType: 'POINT' },
        { ...contour, ContourData: [0, 0, 1, 1, 1, 1] },
        { ...contour, ContourData: [0, 0, 0, 1, 0, 1, 1, 0, 3] },
      ),
    ]);
    expect(volume.grid.spacing[2]).to.be.closeTo(4, 1e-9);
    expect(volume.left).to.deep.equal([
      '2 contours of points or open lines, around nothing',
      '1 contour not flat, or of another orientation than the largest one',
    ]);
    await refuse(
      fields({ ...contour, ContourGeometricType: 'OPEN_PLANAR' }),
      'format/unsupported',
      /no closed contours/,
    );
  });

  it('take numbers of their order where those of the file are none for labels', async () => {
    const { named, left } = await read([one([square(2, 0)], 0), { ...one([square(3, 0, 9)], 5), name: 'Two' }]);
    expect(named!.map(({ id, name }) => [id, name])).to.deep.equal([
      [1, 'One'],
      [2, 'Two'],
    ]);
    expect(left![0]).to.match(/^the numbers of the regions/);
  });

  it('are of even planes, where their distances differ, and say so', async () => {
    const { grid, left } = await read([one([0, 3, 7.6, 10].map((z) => square(5, z)))]);
    expect(grid.dimensions[2]).to.equal(5);
    expect(left).to.include(
      'the slices are not evenly spaced: each of 5 even ones has the labels of the nearest slice',
    );
  });

  it('that say too much are refused in words', async () => {
    const fields = structureSetFields(regions);
    const contoursOf = (...data: readonly (readonly number[] | string)[]): DicomFields => ({
      ...fields,
      ROIContourSequence: [{ ReferencedROINumber: [1], ContourSequence: data.map((ContourData) => ({ ContourData })) }],
    });
    await refuse(
      contoursOf([0, 0, 0, 1, 0, 0, 1, 1]),
      'format/corrupt',
      /8 numbers in contour 1 of region 1; expected three/,
    );
    await refuse(
      contoursOf('0\\0\\0\\1\\x\\0\\1\\1\\0'),
      'format/corrupt',
      /in contour 1 of region 1 that is no number/,
    );
    await refuse(contoursOf([0, 0, 0, 1e9, 0, 0, 1, 1, 0]), 'format/corrupt', /farther away than 100,000 mm/);
    await refuse(
      contoursOf([0, 0, 0, 1, 0, 0, 1, 1, 0], [0, 0, 1, 1, 0, 1, 1, 1, 1], [0, 0, 9e4, 1, 0, 9e4, 1, 1, 9e4]),
      'format/corrupt',
      /the DICOM structure set has 3 slices over 90,000 mm/,
    );
    await refuse(
      structureSetFields(Array.from({ length: 4097 }, (_, i) => one([], i + 1))),
      'format/unsupported',
      /has 4,097 regions; expected at most 4,096/,
    );
    await refuse({ ...fields, ROIContourSequence: [] }, 'format/unsupported', /has no closed contours/);
  });

  it('that are cut anywhere, or have bytes changed, are labels or an error in words', async () => {
    const bytes = dicomBytes(
      structureSetFields(regions.map((region) => ({ ...region, contours: region.contours.slice(0, 2) }))),
    );
    for (let end = 132; end < bytes.length; end += 397) {
      const cut = bytes.slice(0, end);
      await decodeSeries([cut]).catch((error: { code?: string }) => expect(error.code).to.match(/^format\//));
      const changed = bytes.slice();
      changed[end] = end & 255;
      await decodeSeries([changed]).catch((error: { code?: string }) => expect(error.code).to.match(/^format\//));
    }
  });

  it('among the files of a scan are left out, in words, and show none of their texts but names of regions', async () => {
    const secret = 'Geheim^Erna';
    const planted: DicomFields = { PatientName: secret, SeriesDescription: secret, StudyInstanceUID: '1.2.77.4711' };
    const beside = await decodeFields([ctSlice(0), { ...structureSetFields(regions), ...planted }, ctSlice(5)]);
    expect(beside.left).to.deep.equal([
      '1 file of 3: file 2 of 3 has contours (RTSTRUCT): they are shown over their scan by <volume-labels src="…">, in the <volume-view> of the scan, one file alone, on a DICOMweb server by the address of its instance',
    ]);
    const alone = await read(regions, planted);
    expect(JSON.stringify({ ...alone, samples: null, macrocells: null })).not.to.match(/geheim|erna|4711/i);
  });

  it('may have a bridge in any direction: what it crosses twice is as it was', async () => {
    const turned = keyhole([0, 0, 0], 10, 3).map(([x, y, z]): Point => [0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y, z]);
    const volume = await read([one([turned, turned.map(([x, y]): Point => [x, y, 2])])]);
    const [dx, dy] = volume.grid.spacing;
    for (const count of measure(volume, 1)[0]) expect(count * dx * dy).to.be.closeTo(400 - 36, 2);
  });
});
