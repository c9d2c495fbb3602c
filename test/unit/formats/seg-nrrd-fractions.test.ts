// Segmentations of 3D Slicer whose voxels hold how much of them is of a segment.
import { expect } from '@esm-bundle/chai';
import { decodeBytes, valuesOf } from '../../helpers/decode.ts';

describe('segmentations of 3D Slicer', () => {
  // vtkSegmentationCore of 3D Slicer 5: signed bytes from -108 to 108, and 0 is the surface.
  it('of fractions have the label where at least half of a voxel is of the segment, and say so', async () => {
    const header = (type: string, ...more: readonly string[]): Uint8Array<ArrayBuffer> =>
      new TextEncoder().encode(
        [
          'NRRD0004',
          `type: ${type}`,
          'endian: little',
          'encoding: raw',
          'space: left-posterior-superior',
          ...more,
          '',
          '',
        ].join('\n'),
      );
    const file = (head: Uint8Array, numbers: Int8Array | Float32Array): Uint8Array<ArrayBuffer> =>
      Uint8Array.from([...head, ...new Uint8Array(numbers.buffer)]);
    const two = header(
      'signed char',
      'dimension: 4',
      'sizes: 2 4 1 1',
      'kinds: list domain domain domain',
      'space directions: none (1,0,0) (0,1,0) (0,0,1)',
      'Segmentation_MasterRepresentation:=Fractional labelmap',
      'Segment0_Name:=A',
      'Segment1_Name:=B',
    );
    const volume = await decodeBytes(file(two, Int8Array.of(-108, -108, 108, -108, 5, 0, -3, -90)), 'two.seg.nrrd');
    expect(valuesOf(volume)).to.deep.equal([0, 1, 2, 0]);
    expect(volume.named?.map(({ id, name }) => [id, name])).to.deep.equal([
      [1, 'A'],
      [2, 'B'],
    ]);
    expect(volume.left![0]).to.equal(
      'fractions of segments: a voxel has the label where at least half of it is of the segment (values from -108 to 108)',
    );
    const one = header(
      'float',
      'dimension: 3',
      'sizes: 4 1 1',
      'space directions: (1,0,0) (0,1,0) (0,0,1)',
      'Segmentation_SourceRepresentation:=Fractional labelmap',
      'Segment0_Name:=A',
      'Segment0_LabelValue:=7',
      'Segment0_Layer:=0',
    );
    const single = await decodeBytes(file(one, Float32Array.of(0, 0.4, 0.5, 1)), 'one.seg.nrrd');
    expect(valuesOf(single).map((index) => single.ids![index])).to.deep.equal([0, 0, 7, 7]);
    expect([single.isDiscrete, single.format]).to.deep.equal([true, 'NRRD']);
  });
});
