import { expect } from '@esm-bundle/chai';
import { loadVolume } from '../../../src/worker/load.ts';
import { invertAffine, multiply, transformPoint } from '../../../src/volume/matrix.ts';
import type { Volume } from '../../../src/volume/volume.ts';
import { roomyLimits } from '../../helpers/decode.ts';

const load = (name: string): Promise<Volume> =>
  loadVolume(
    { url: `/demos/data/${name}`, limits: roomyLimits },
    { signal: new AbortController().signal, onProgress: () => undefined },
  );

describe("the demos' data", () => {
  it('show the same head from NIfTI and from the mosaic: the same values at the same positions', async () => {
    const [file, mosaic] = await Promise.all([load('mni152-t1.nii.gz'), load('mni152-t1.json')]);
    expect(mosaic.grid.dimensions).to.deep.equal(file.grid.dimensions);
    const toFile = multiply(invertAffine(file.grid.indexToWorld)!, mosaic.grid.indexToWorld);
    const [nx, ny, nz] = mosaic.grid.dimensions;
    let differing = 0;
    for (let k = 0; k < nz; k++)
      for (let j = 0; j < ny; j++)
        for (let i = 0; i < nx; i++) {
          // Straight axes of 1 mm: every voxel of the one lies on a voxel of the other.
          const [x, y, z] = transformPoint(toFile, [i, j, k]);
          if (mosaic.samples[(k * ny + j) * nx + i] !== file.samples[(z * ny + y) * nx + x]) differing++;
        }
    expect(differing).to.equal(0);
    expect(mosaic.range).to.deep.equal(file.range);
  });

  it('hold a torso in Hounsfield units', async () => {
    const volume = await load('ct-phantom.json');
    expect(volume.unit).to.equal('HU');
    expect(volume.range[0]).to.equal(-1000);
    expect(volume.range[1]).to.be.within(700, 1000);
    expect(volume.grid.spacing).to.deep.equal([3, 3, 3]);
    expect(volume.samples).to.be.instanceOf(Uint16Array);
  });

  it('hold a storm in dBZ', async () => {
    const volume = await load('storm-synthetic.json');
    expect(volume).to.include({ unit: 'dBZ', transferFunction: 'radar-dbz' });
    expect(volume.range[0]).to.equal(-32);
    expect(volume.range[1]).to.be.within(55, 70);
    expect(volume.grid.spacing).to.deep.equal([1000, 1000, 400]);
  });
});
