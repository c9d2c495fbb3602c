// What touches nothing of a scan is hidden: for rays, picks, and all that reads values.
import { expect } from '@esm-bundle/chai';
import { VolumeViewError } from '../../../../src/core/errors.ts';
import type { Cleaning } from '../../../../src/formats/base/clean-volume.ts';
import type { DecodedCartesianVolume } from '../../../../src/formats/base/decoded-volume.ts';
import { finishVolume } from '../../../../src/formats/finish-volume.ts';
import { loadVolume } from '../../../../src/worker/load.ts';
import { castRay } from '../../../../src/optics/rays/cast-ray.ts';
import { pickRay } from '../../../../src/optics/pick-ray.ts';
import { rayThrough, setUpRays } from '../../../../src/optics/rays/rays.ts';
import { stagesOf } from '../../../../src/optics/reference.ts';
import { resolveTransferFunction } from '../../../../src/optics/transfer/resolve-transfer-function.ts';
import { describeVolume } from '../../../../src/viewer/model/volume-info.ts';
import { axialIndexToWorld, cartesianGrid } from '../../../../src/volume/grid.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { expectError, roomyLimits, valuesOf } from '../../../helpers/decode.ts';
import { niftiBytes } from '../../../helpers/nifti-bytes.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

const dimensions: Vector3 = [40, 40, 16];
const [nx, ny, nz] = dimensions;

/** HU of a head: a ball of bone with a soft middle and blurred edges; of a rest beside it, at x > 32; and of a speck. */
function headAt(i: number, j: number, k: number): number {
  const distance = Math.hypot(i - 15, j - 20, 2 * (k - 8));
  const head = distance < 8 ? 40 : Math.max(-1000, 700 - 400 * Math.max(0, distance - 10));
  const rest = i > 32 && j > 14 && j < 23 ? Math.max(-1000, 260 - 500 * Math.abs(i - 35)) : -1000;
  return i === 2 && j === 2 && k === 3 ? 900 : Math.max(head, rest);
}

const isRest = (voxel: number): boolean => voxel % nx > 30 || voxel === 2 + nx * (2 + ny * 3);

function decode(
  kind: 'uint16' | 'float32',
  more: Partial<DecodedCartesianVolume> = {},
  slope = 1,
): DecodedCartesianVolume {
  const values = Float64Array.from({ length: nx * ny * nz }, (_, voxel) =>
    Math.round(headAt(voxel % nx, Math.floor(voxel / nx) % ny, Math.floor(voxel / (nx * ny)))),
  );
  const intercept = kind === 'float32' ? 0 : slope > 0 ? -1024 : 3071;
  const samples =
    kind === 'float32'
      ? Float32Array.from(values, (value) => value / slope)
      : Uint16Array.from(values, (value) => (value - intercept) / slope);
  return {
    grid: cartesianGrid(dimensions, axialIndexToWorld(dimensions, [1, 1, 1])),
    samples,
    slope,
    intercept,
    unit: 'HU',
    format: 'NIfTI-1',
    ...more,
  };
}

const finish = (decoded: DecodedCartesianVolume, clean?: Cleaning): Promise<Volume> =>
  finishVolume(decoded, roomyLimits, undefined, clean);

describe('a volume that is cleaned', () => {
  for (const [kind, slope] of [
    ['uint16', 1],
    ['uint16', -1],
    ['float32', 1],
    ['float32', -0.5],
  ] as const) {
    it(`has nothing above the value in what touches nothing, and the rest as it was: ${kind}, slope ${slope}`, async () => {
      const [whole, cleaned] = await Promise.all([
        finish(decode(kind, {}, slope)),
        finish(decode(kind, {}, slope), 'auto'),
      ]);
      const [before, after] = [valuesOf(whole), valuesOf(cleaned)];
      // 140 HU is where `ct-bone` begins to show, which a CT has by default.
      expect(Math.max(...before.filter((_, voxel) => isRest(voxel)))).to.equal(900);
      expect(Math.max(...after.filter((_, voxel) => isRest(voxel)))).to.equal(140);
      expect(after.filter((_, voxel) => !isRest(voxel))).to.deep.equal(before.filter((_, voxel) => !isRest(voxel)));
      expect(after.filter((value, voxel) => value !== before[voxel] && before[voxel] <= 140)).to.deep.equal([]);
      expect([whole.range[1], cleaned.range[1]]).to.deep.equal([900, 700]);
      expect(cleaned.window).to.deep.equal(whole.window);
      expect(cleaned.transferFunction).to.equal(whole.transferFunction);
      expect(cleaned.macrocells.high.length).to.equal(whole.macrocells.high.length);
    });
  }

  it('says in words what is hidden, and nothing where nothing is', async () => {
    const slab = 8 * 16; // Of the rest, one plane of voxels is above 140.
    expect(describeVolume(await finish(decode('uint16'), 'auto')).left).to.deep.equal([
      `clean hides 2 parts that touch nothing larger: ${slab + 1} voxels above 140`,
    ]);
    expect(describeVolume(await finish(decode('uint16'), 280)).left).to.deep.equal([
      'clean hides one part that touches nothing larger: 1 voxels above 280',
    ]);
    expect(describeVolume(await finish(decode('uint16'), 899.5)).left).to.equal(undefined);
    expect(describeVolume(await finish(decode('uint16'))).left).to.equal(undefined);
  });

  it('shows nothing of that to rays and picks, with no edge left, and the head as before', async () => {
    const [whole, cleaned] = await Promise.all([finish(decode('uint16')), finish(decode('uint16'), 'auto')]);
    const transferFunction = await resolveTransferFunction('ct-bone', [-1000, 1000]);
    // From above, parallel: 40 wide.
    const view = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -100, 0, 0, 0, 1];
    const setup = setUpRays(whole.grid, view, [0.05, 0, 0, 0, 0, 0.05, 0, 0, 0, 0, -0.001, 0, 0, 0, 0, 1])!;
    const stagesFor = (volume: Volume) =>
      stagesOf(
        {
          ...volume,
          grid: whole.grid,
          transferFunction,
          referenceLength: 1,
          opacityFactor: 1,
          lightFactor: 1,
          stepLength: 0.5,
        },
        setup,
      );
    const [before, after] = [stagesFor(whole), stagesFor(cleaned)];
    const appearance = { transferFunction, projection: null };
    let hidden = 0;
    for (let x = -0.975; x < 1; x += 0.05) {
      for (let y = -0.975; y < 1; y += 0.1) {
        const ray = rayThrough(setup, x, y);
        const [color, cleanColor] = [castRay(before, ray), castRay(after, ray)];
        const i = 20 * (1 - x) - 0.5; // The patient's left is at the right.
        if (i > 3 && i < 31) expect(cleanColor, `${x} ${y}`).to.deep.equal(color);
        else
          expect([...cleanColor, pickRay(after, ray, { at: 'jump', look: appearance })], `${x} ${y}`).to.deep.equal([
            0,
            0,
            0,
            0,
            null,
          ]);
        if (i > 31 && color[3] > 0.1) hidden++;
      }
    }
    expect(hidden).to.be.above(3);
  });

  it('is cleaned in the worker that reads it', async () => {
    const volume = syntheticVolume({
      dimensions: [12, 8, 8],
      kind: 'float32',
      field: (x) => (x < 0.5 ? 1 : x > 0.9 ? 0.8 : 0),
    });
    const url = URL.createObjectURL(new Blob([niftiBytes(volume)]));
    const loaded = await loadVolume(
      { url, settings: { clean: 0.5 }, limits: roomyLimits },
      { signal: new AbortController().signal, onProgress: () => undefined },
    );
    expect(loaded.left).to.equal(undefined); // 64 of 384 voxels: a part as large as a sixth stays.
    const less = await loadVolume(
      {
        url: URL.createObjectURL(
          new Blob([
            niftiBytes(
              syntheticVolume({
                dimensions: [12, 8, 8],
                kind: 'float32',
                field: (x, y) => (x < 0.5 ? 1 : x > 0.9 && y < 0.4 ? 0.8 : 0),
              }),
            ),
          ]),
        ),
        settings: { clean: 0.5 },
        limits: roomyLimits,
      },
      { signal: new AbortController().signal, onProgress: () => undefined },
    );
    expect(less.left).to.deep.equal(['clean hides one part that touches nothing larger: 24 voxels above 0.5']);
  });

  it('is reported where the value does not follow from the volume, and where there are no measured values', async () => {
    const refused = async (promise: Promise<unknown>, words: RegExp): Promise<void> => {
      const error = await expectError(promise);
      expect(error).to.be.instanceOf(VolumeViewError);
      expect(error.code).to.equal('attribute/invalid');
      expect(error.message).to.match(words);
    };
    await refused(
      finish(decode('uint16', { transferFunction: 'diverging', unit: '' }), 'auto'),
      /^clean got ""; expected the value from which on something is shown, like clean="150"/,
    );
    await refused(
      finish(
        decode('uint16', {
          isLabels: true,
          unit: '',
          samples: Uint16Array.from({ length: nx * ny * nz }, (_, i) => (i >> 8) % 3),
        }),
        1,
      ),
      /^clean got "1"; expected a volume of measured values: to hide a label/,
    );
  });
});
