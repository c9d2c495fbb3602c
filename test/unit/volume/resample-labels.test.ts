import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../src/core/errors.ts';
import { placeLabels } from '../../../src/viewer/attachments/place-labels.ts';
import { labelsIn } from '../../../src/viewer/loading/label-files.ts';
import { axialIndexToWorld, cartesianGrid } from '../../../src/volume/grid.ts';
import type { CartesianGrid } from '../../../src/volume/grid.ts';
import type { LabelMap } from '../../../src/volume/labels.ts';
import type { Vector3 } from '../../../src/volume/matrix.ts';
import { reduceVolume } from '../../../src/volume/reduce.ts';
import { findLabels } from '../../../src/volume/resample-labels.ts';
import type { Samples } from '../../../src/volume/samples.ts';
import type { Volume } from '../../../src/volume/volume.ts';

// nibabel 5.4.2 with SciPy 1.17.1: resample_from_to((labels, from), ((9, 8, 6), to), order=0, mode='grid-constant', cval=0). No voxel's centre
// is nearer than 0.001 of a voxel to the middle between two labels, so there is no tie.
const from = [
  -2.006206627164, -0.492370111963, -0.152648084404, 6.1, -0.620592433989, 1.591698718093, 0.493469758545, -4.2, 0.0,
  -0.337737862352, 2.548173102387, -5.3, 0.0, 0.0, 0.0, 1.0,
];
const to = [1.3, 0.0, 0.0, -7.7, 0.0, -1.9, 0.0, 5.1, 0.0, 0.0, 2.2, -4.9, 0.0, 0.0, 0.0, 1.0];
const given = Uint8Array.of(
  35,
  35,
  0,
  21,
  28,
  21,
  28,
  14,
  7,
  0,
  28,
  14,
  7,
  28,
  35,
  35,
  21,
  35,
  21,
  0,
  35,
  14,
  14,
  7,
  21,
  28,
  0,
  21,
  7,
  35,
  0,
  0,
  28,
  28,
  0,
  21,
  21,
  35,
  35,
  7,
  7,
  7,
  28,
  35,
  7,
  14,
  28,
  7,
  28,
  7,
  7,
  7,
  35,
  7,
  7,
  21,
  0,
  7,
  7,
  28,
  14,
  21,
  14,
  28,
  21,
  28,
  21,
  7,
  14,
  21,
  28,
  28,
  14,
  14,
  35,
  14,
  28,
  21,
  14,
  14,
  35,
  21,
  28,
  28,
  28,
  7,
  0,
  21,
  0,
  7,
  21,
  0,
  21,
  7,
  14,
  7,
  14,
  28,
  35,
  7,
  7,
  0,
  14,
  14,
  28,
  14,
  35,
  0,
  14,
  0,
  14,
  14,
  0,
  28,
  0,
  14,
  28,
  14,
  28,
  35,
  7,
  0,
  14,
  14,
  35,
  0,
  28,
  14,
  28,
  0,
  35,
  7,
  21,
  14,
  21,
  28,
  0,
  28,
  21,
  0,
  28,
  35,
  7,
  35,
  0,
  35,
  7,
  7,
  14,
  21,
  14,
  35,
  0,
  35,
  35,
  14,
  14,
  35,
  14,
  21,
  28,
  35,
  0,
  28,
  0,
  35,
  14,
  35,
  7,
  14,
  28,
  35,
  21,
  28,
  35,
  21,
  35,
  14,
  35,
  7,
  7,
  35,
  14,
  0,
  0,
  21,
  0,
  35,
  35,
  35,
  28,
  14,
  35,
  14,
  21,
  7,
  0,
  35,
  35,
  21,
  0,
  7,
  0,
  0,
  28,
  21,
  28,
  7,
  35,
  21,
);
const expected = [
  0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 35, 14, 14, 14, 14, 28, 28, 21, 21, 14, 14, 14, 28, 28, 28, 14, 14, 35, 21, 21,
  28, 28, 14, 21, 14, 14, 28, 21, 35, 21, 21, 7, 35, 35, 0, 0, 14, 28, 28, 0, 0, 0, 28, 7, 21, 28, 28, 21, 0, 0, 0, 28,
  28, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 35, 0, 0, 0, 14, 14, 0, 0, 7, 28, 0, 35, 14, 28, 14, 14, 0, 28, 21, 28,
  14, 14, 7, 21, 21, 28, 7, 7, 21, 14, 14, 14, 14, 28, 7, 7, 7, 14, 14, 7, 7, 7, 35, 35, 7, 7, 0, 21, 7, 7, 28, 28, 14,
  0, 0, 0, 28, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 35, 0, 0, 35, 0, 0, 28, 0, 28, 28, 35, 35, 28, 28, 14, 14,
  0, 35, 35, 28, 14, 14, 0, 14, 14, 7, 7, 7, 14, 14, 14, 14, 14, 0, 7, 7, 21, 28, 28, 14, 14, 7, 14, 21, 0, 0, 0, 21, 7,
  7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 35, 0, 14, 35, 0, 0, 28, 14, 14, 14, 35, 21, 14,
  14, 35, 14, 21, 14, 14, 28, 0, 0, 35, 14, 35, 7, 7, 35, 7, 35, 35, 0, 0, 0, 28, 28, 21, 0, 0, 21, 21, 28, 0, 0, 28,
  28, 0, 21, 7, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 21, 28, 28, 0, 35, 35, 7, 28, 21, 35, 35,
  35, 35, 0, 7, 0, 0, 35, 35, 14, 28, 28, 7, 21, 21, 14, 21, 21, 0, 0, 35, 35, 35, 35, 0, 7, 35, 14, 14, 14, 35, 35, 7,
  7, 21, 35, 35, 28, 0, 0, 35, 28, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
  0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 14, 0, 0, 0, 0, 21, 35,
  35, 0, 0, 0, 35, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
];

const volume = (grid: CartesianGrid, samples: Samples, more: Partial<Volume> = {}): Volume =>
  ({ grid, samples, slope: 1, intercept: 0, format: 'NIfTI-1', ...more }) as Volume;
const signal = new AbortController().signal;
const place = (labels: Volume, scan: Volume): Promise<LabelMap> =>
  placeLabels({ ...labelsIn(labels, 'atlas.nii'), format: labels.format }, scan, 'atlas.nii', signal);
const idsOf = ({ numbers, ids }: LabelMap): number[] => Array.from(numbers, (number) => ids[number]);
const straight = (dimensions: Vector3, offset = 0): CartesianGrid =>
  cartesianGrid(dimensions, [1, 0, 0, offset, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);

async function errorOf(work: Promise<unknown>): Promise<VolumeViewError> {
  const error = await work.then(
    () => null,
    (thrown: unknown) => thrown,
  );
  expect(error).to.be.instanceOf(VolumeViewError);
  return error as VolumeViewError;
}

describe('labels on another grid', () => {
  it('are those of the nearest voxel, as SciPy has them, and 0 outside', async () => {
    const map = await place(
      volume(cartesianGrid([7, 6, 5], from), given),
      volume(cartesianGrid([9, 8, 6], to), new Uint8Array(432)),
    );
    expect(map.dimensions).to.deep.equal([9, 8, 6]);
    expect(map.ids).to.deep.equal([0, 7, 14, 21, 28, 35]);
    expect(idsOf(map)).to.deep.equal(expected);
  });

  it('stay in their voxels on the same grid, whatever stored them: negative ids and a slope too', async () => {
    const grid = cartesianGrid([7, 6, 5], from);
    const scan = volume(grid, new Uint8Array(210));
    expect(idsOf(await place(volume(grid, given), scan))).to.deep.equal([...given]);
    const shifted = await place(volume(grid, given, { slope: 2, intercept: -14 }), scan);
    expect(shifted.ids, 'what has no label is the first').to.deep.equal([0, -14, 14, 28, 42, 56]);
    expect(idsOf(shifted)).to.deep.equal(Array.from(given, (value) => 2 * value - 14));
    const floats = await place(
      volume(
        grid,
        Float32Array.from(given, (value) => (value === 35 ? NaN : value * 1000)),
      ),
      scan,
    );
    expect(idsOf(floats)).to.deep.equal(Array.from(given, (value) => (value === 35 ? 0 : value * 1000)));
  });

  it('go by numbers of 16 bits where there are many', async () => {
    const many = Uint16Array.from({ length: 1000 }, (_, i) => i * 3);
    const map = await place(volume(straight([10, 10, 10]), many), volume(straight([10, 10, 10]), new Uint8Array(1000)));
    expect(map.numbers).to.be.instanceOf(Uint16Array);
    expect(idsOf(map)).to.deep.equal([...many]);
  });

  it('of a volume that was made smaller are those that most of each voxel has; from another grid those at its centre', async () => {
    // Of three voxels in a row two are 3, but not the middle one.
    const labels = Uint8Array.from({ length: 9 * 9 * 9 }, (_, i) => [3, 5, 3, 5, 5, 3, 3, 0, 0][i % 9]);
    const whole = straight([9, 9, 9]);
    const { dimensions, indexToWorld, samples } = reduceVolume({ ...whole, samples: labels }, [3, 3, 3]);
    const small = volume(cartesianGrid(dimensions, indexToWorld), samples, {
      reduced: { from: [9, 9, 9], to: [3, 3, 3] },
    });
    const rows = (row: readonly number[]): number[] => Array.from({ length: 27 }, (_, i) => row[i % 3]);
    expect(idsOf(await place(volume(whole, labels), small))).to.deep.equal(rows([3, 5, 0]));
    // An image has no place: its grid is that of the file.
    expect(
      idsOf(
        await place(
          volume(cartesianGrid([9, 9, 9], axialIndexToWorld([9, 9, 9], [1, 1, 1])), labels, { format: 'PNG mosaic' }),
          small,
        ),
      ),
    ).to.deep.equal(rows([3, 5, 0]));
    expect(idsOf(await place(volume(straight([9, 9, 9], 0.1), labels), small))).to.deep.equal(rows([5, 5, 0]));
  });

  it('are refused in words where nothing relates them to the volume', async () => {
    const labels = volume(straight([3, 3, 3]), new Uint8Array(27).fill(1));
    const far = await errorOf(place(labels, volume(straight([3, 3, 3], 100), new Uint8Array(27))));
    expect(far.code).to.equal('format/unsupported');
    expect(far.message).to.contain('no place in common');
    const image = volume(cartesianGrid([4, 3, 3], axialIndexToWorld([4, 3, 3], [1, 1, 1])), new Uint8Array(36), {
      format: 'PNG mosaic',
    });
    expect((await errorOf(place(labels, image))).message).to.match(
      /3 x 3 x 3 voxels and the volume on one of 4 x 3 x 3/,
    );
    const radar = { ...image, grid: { ...image.grid, kind: 'polar' } } as unknown as Volume;
    expect((await errorOf(place(labels, radar))).message).to.contain('radar');
  });
});

describe('what is no label', () => {
  it('is reported with the value that shows it', () => {
    expect(() => labelsIn(volume(straight([2, 1, 1]), Float32Array.of(1, 2.5)), 'scan.nii')).to.throw(
      VolumeViewError,
      /scan.nii has no labels: it got the value 2.5/,
    );
    expect(() =>
      labelsIn(
        volume(
          straight([70_000, 1, 1]),
          Float32Array.from({ length: 70_000 }, (_, i) => i),
        ),
        'scan.nii',
      ),
    ).to.throw(/more than 65,536/);
    expect(() =>
      labelsIn(
        volume(straight([1, 1, 1]), Uint8Array.of(1), { reduced: { from: [2, 1, 1], to: [1, 1, 1] } }),
        'huge.nii',
      ),
    ).to.throw(/too large/);
  });

  it('is not what a slope has left a little off', () => {
    const found = findLabels({ samples: Float32Array.of(0, 1, 2), slope: 1.0000001, intercept: 0 });
    expect('ids' in found && found.ids).to.deep.equal([0, 1, 2]);
  });
});
