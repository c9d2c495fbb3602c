import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../src/core/errors.ts';
import { loadVolume } from '../../../src/worker/load.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { roomyLimits, valuesOf } from '../../helpers/decode.ts';
import { fetchSharedData } from '../../helpers/shared-data.ts';

// Files with which other viewers failed, and what nibabel 5 and SimpleITK 2 say of them (gen.py and expected.json beside them). They are no part of the project:
// where they are absent, the tests say so.

/** Of SimpleITK; places are LPS. */
interface ItkAnswer {
  readonly size: readonly number[];
  readonly spacing: readonly number[];
  readonly origin_lps: readonly number[];
  readonly direction: readonly number[];
  readonly v: number;
  readonly min?: number;
  readonly max?: number;
}

interface NibabelAnswer {
  readonly shape: readonly number[];
  readonly affine: readonly (readonly number[])[];
  readonly v: number;
  readonly min: number;
  readonly max: number;
}

type Answers<T> = Readonly<Record<string, T | string>>;

const load = (path: string): Promise<Volume> =>
  loadVolume(
    { url: `/shared-data/reports/${path}`, limits: roomyLimits },
    { signal: new AbortController().signal, onProgress: () => undefined },
  );

async function answersOf<T>(context: Mocha.Context, folder: string): Promise<T> {
  return JSON.parse(new TextDecoder().decode(await fetchSharedData(context, `reports/${folder}/expected.json`))) as T;
}

function valueAt(
  {
    grid: {
      dimensions: [nx, ny],
    },
    samples,
    slope,
    intercept,
  }: Volume,
  [i, j, k]: readonly number[],
): number {
  return slope * samples[i + nx * (j + ny * k)] + intercept;
}

function compareWithItk(
  volume: Volume,
  { size, spacing, origin_lps: origin, direction, min, max }: ItkAnswer,
  name: string,
): void {
  const axes = size.length;
  expect(volume.grid.dimensions.slice(0, axes), name).to.deep.equal(size);
  const { indexToWorld } = volume.grid;
  for (let row = 0; row < axes; row++) {
    const sign = row < 2 ? -1 : 1;
    for (let column = 0; column < axes; column++)
      expect(indexToWorld[row * 4 + column], `${name}: ${row} ${column}`).to.be.closeTo(
        sign * direction[row * axes + column] * spacing[column],
        1e-6,
      );
    expect(indexToWorld[row * 4 + 3], `${name}: origin ${row}`).to.be.closeTo(sign * origin[row], 1e-3);
  }
  if (min !== undefined) expect(volume.range, name).to.deep.equal([min, max]);
}

describe('files with which other viewers failed', () => {
  it('01: an NRRD file with spacings alone, as pynrrd and SimpleITK read it', async function () {
    for (const [name, answer] of Object.entries(
      await answersOf<Record<string, ItkAnswer>>(this, '01-nrrd-spacings-only'),
    )) {
      const volume = await load(`01-nrrd-spacings-only/${name}`);
      compareWithItk(volume, answer, name);
      expect(valueAt(volume, [3, 4, 5]), name).to.equal(answer.v);
      expect(
        valuesOf(volume).reduce((sum, x) => sum + x, 0),
        name,
      ).to.equal((answer as unknown as { sum: number }).sum);
    }
  });

  it('02: a flat NRRD file in text', async function () {
    const answer = await answersOf<{ sizes: number[]; v_1_2: number; v_2_8: number }>(this, '02-nrrd-2d-ascii');
    const volume = await load('02-nrrd-2d-ascii/flat.nrrd');
    expect(volume.grid.dimensions).to.deep.equal([...answer.sizes, 1]);
    expect([valueAt(volume, [1, 2, 0]), valueAt(volume, [2, 8, 0])]).to.deep.equal([answer.v_1_2, answer.v_2_8]);
  });

  it('03: MetaImage files, as SimpleITK reads them', async function () {
    const answers = await answersOf<Answers<ItkAnswer>>(this, '03-metaimage-variants');
    for (const [name, answer] of Object.entries(answers)) {
      if (typeof answer === 'string') continue;
      const volume = await load(`03-metaimage-variants/${name}`);
      // Packed data that do not say their length are wrong in SimpleITK itself: it has other values.
      const isOff = name === 'nosize.mha';
      compareWithItk(volume, isOff ? { ...answer, min: -50, max: 733 } : answer, name);
      expect(valueAt(volume, answer.size.length === 3 ? [4, 3, 2] : [4, 3, 0]), name).to.equal(isOff ? 255 : answer.v);
    }
    expect((await load('03-metaimage-variants/intensity.mha')).left).to.have.length(1);
  });

  it('04: vectors and lists that come first', async function () {
    const answer = await answersOf<{ list_first_value_ijk_123: number }>(this, '04-nrrd-vector-first-big-endian');
    const volume = await load('04-nrrd-vector-first-big-endian/list.nrrd');
    expect(valueAt(volume, [1, 2, 3])).to.be.closeTo(answer.list_first_value_ijk_123, 1e-6);
    expect(volume.left).to.have.length(1);
    const refused = await load('04-nrrd-vector-first-big-endian/vector.nrrd').catch((error: unknown) => error);
    expect(refused).to.be.instanceOf(VolumeViewError).with.property('code', 'format/unsupported');
  });

  it('05: NIfTI headers and gzip files of all kinds, as nibabel reads them', async function () {
    const answers = await answersOf<Answers<NibabelAnswer>>(this, '05-nifti-headers');
    let compared = 0;
    for (const [name, answer] of Object.entries(answers)) {
      if (name === 'rgb24.nii') {
        // The three numbers of each of its voxels are the same, so it is gray: as nibabel 5.4.2 reads it.
        const volume = await load(`05-nifti-headers/${name}`);
        expect(volume.range).to.deep.equal([100, 246]);
        expect(valueAt(volume, [1, 2, 3])).to.equal(134);
        expect([volume.left, volume.channels]).to.deep.equal([undefined, undefined]);
        continue;
      }
      if (typeof answer === 'string') continue; // nibabel reads none of these.
      const volume = await load(`05-nifti-headers/${name}`);
      expect(volume.grid.dimensions.slice(0, answer.shape.length), name).to.deep.equal(answer.shape.slice(0, 3));
      answer.affine
        .flat()
        .forEach((entry, i) => expect(volume.grid.indexToWorld[i], `${name}: ${i}`).to.be.closeTo(entry, 1e-4));
      // nibabel takes an offset of 0 as it is, and the header for data.
      const isOff = name === 'vox-offset-0.nii';
      expect(volume.range, name).to.deep.equal(isOff ? [100, 246] : [answer.min, answer.max]);
      if (answer.shape.length === 3 && !isOff) expect(valueAt(volume, [3, 4, 5]), name).to.be.closeTo(answer.v, 1e-6);
      compared++;
    }
    expect(compared).to.be.at.least(17);
  });

  it('06, 07, 08 and 17: what has no answer of its own opens, with the values that gen.py wrote', async function () {
    await fetchSharedData(this, 'reports/README.md');
    const expected: readonly (readonly [string, readonly number[], readonly [number, number] | null])[] = [
      ['07-far-from-origin/near.mha', [], null],
      ['07-far-from-origin/utm.mha', [], null],
      ['07-far-from-origin/utm-fine.mha', [], null],
      ['07-far-from-origin/nano.mha', [], null],
      ['07-far-from-origin/microns.nii', [], null],
      ['06-nan-background/negative.nii.gz', [], null],
      ['06-nan-background/solid.nii.gz', [], null],
      ['06-nan-background/solid-zero.nii.gz', [], null],
      ['06-nan-background/tmap.nii.gz', [], null],
      ['08-gantry-tilt/tilt.nii.gz', [], null],
      ['17-thin-and-tiny/one-slice.nii.gz', [200, 200, 1], [20, 220]],
      ['17-thin-and-tiny/two-slices.nii.gz', [200, 200, 2], [20, 220]],
      ['17-thin-and-tiny/wires.nii.gz', [128, 128, 128], [0, 255]],
      ['17-thin-and-tiny/speck.nii.gz', [128, 128, 128], [0, 255]],
      ['17-thin-and-tiny/constant.nii.gz', [20, 20, 20], [7, 7]],
      ['17-thin-and-tiny/line.nii.gz', [1, 1, 40], [0, 234]],
      ['17-thin-and-tiny/model-100m.mha', [100, 100, 30], [0, 100]],
      ['17-thin-and-tiny/model-500m.mha', [100, 100, 30], [0, 100]],
    ];
    for (const [path, dimensions, range] of expected) {
      const volume = await load(path);
      expect(volume.range[1], path).to.be.at.least(volume.range[0]);
      if (range) expect(volume.range, path).to.deep.equal(range);
      if (range) expect(volume.grid.dimensions, path).to.deep.equal(dimensions);
      expect(volume.hasNoData, path).to.equal(
        /solid\.|tmap/.test(path) || (path.includes('negative') && volume.hasNoData),
      );
    }
  });
});
