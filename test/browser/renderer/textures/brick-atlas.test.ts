// The atlas of bricks grows and shrinks with its bricks, and stays as large as it is where the GPU has no memory for more.
import { expect } from '@esm-bundle/chai';
import { shapeAtlas } from '../../../../src/bricks/brick-layout.ts';
import { bytesOfCell } from '../../../../src/bricks/page-table.ts';
import { uploadBricks } from '../../../../src/renderer/ray/modules/bricks.ts';
import { finishUpload } from '../../../../src/renderer/textures/fill-texture.ts';
import { describe as describeDevice } from '../../../../src/renderer/probes/probe-device.ts';
import { listBricks } from '../../../../src/bricks/pyramid.ts';
import { cutIntoBricks, readBrick } from '../../../helpers/bricks.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';

/** Of the level that is always there, which has half the voxels along each axis. */
const atlas = shapeAtlas([96, 96, 80], 7000);
const { slotsOfLayer, width, height, depth } = atlas;
const layerBytes = slotsOfLayer * 36 ** 3;

function makeAtlas() {
  const gl = document.createElement('canvas').getContext('webgl2')!;
  const { pyramid, volume } = cutIntoBricks(syntheticVolume({ dimensions: [192, 192, 160] }), 2, () => false);
  const { finer } = volume;
  finer.atlas = atlas;
  const field = finishUpload(uploadBricks(gl, volume, describeDevice(gl)));
  const atlasBytes = (): number => {
    field.inputs();
    return field.bytes - width * height * depth - bytesOfCell * 6 * 6 * 5;
  };
  const all = listBricks(pyramid, 0);
  return { gl, finer, field, all, atlasBytes, add: (n: number) => finer.add(all[n], readBrick(pyramid, all[n])) };
}

describe('the atlas of bricks', () => {
  it('grows with its bricks as far as its capacity, and shrinks with that', () => {
    const { gl, finer, field, all, atlasBytes, add } = makeAtlas();
    expect(all.length).to.equal(180);
    finer.fit(2 * slotsOfLayer);
    for (let n = 0; n < slotsOfLayer; n++) add(n);
    expect(atlasBytes()).to.equal(layerBytes);
    add(slotsOfLayer);
    expect(atlasBytes()).to.equal(2 * layerBytes);
    for (const brick of [...finer.bricks].slice(0, 20)) finer.remove(brick);
    finer.fit(slotsOfLayer);
    expect(atlasBytes()).to.equal(layerBytes);
    expect(finer.count).to.equal(slotsOfLayer - 19);
    expect(gl.getError()).to.equal(gl.NO_ERROR);
    field.dispose();
  });

  it('gives memory back at once, and has its bricks again with the next picture', () => {
    const { gl, finer, field, atlasBytes, add } = makeAtlas();
    finer.fit(4 * slotsOfLayer);
    for (let n = 0; n <= slotsOfLayer; n++) add(n);
    expect(atlasBytes()).to.equal(4 * layerBytes);
    const [first] = finer.bricks;
    finer.remove(first);
    field.inputs();
    const bytes = field.bytes;
    finer.fit(slotsOfLayer);
    expect(bytes - field.bytes).to.equal(3 * layerBytes);
    expect(finer.bytesOnGpu).to.equal(field.bytes);
    let writes = 0;
    const native = gl.texSubImage3D.bind(gl);
    gl.texSubImage3D = (...args: unknown[]) => {
      if (args[5] === 36 && args[6] === 36 && args[7] === 36) writes++;
      (native as (...all: unknown[]) => void)(...args);
    };
    field.inputs();
    expect(writes).to.equal(slotsOfLayer);
    field.inputs();
    expect(writes, 'once').to.equal(slotsOfLayer);
    // Also where no brick had to go.
    finer.fit(2 * slotsOfLayer);
    add(slotsOfLayer + 1);
    for (const brick of [...finer.bricks].slice(-20)) finer.remove(brick);
    field.inputs();
    writes = 0;
    finer.fit(slotsOfLayer);
    field.inputs();
    expect(writes).to.equal(finer.count);
    field.dispose();
    finer.fit(1);
    expect(gl.getError()).to.equal(gl.NO_ERROR);
  });

  it('stays where there is no memory for more, and the last bricks go', () => {
    const { gl, finer, field, all, atlasBytes, add } = makeAtlas();
    for (let n = 0; n < slotsOfLayer; n++) add(n);
    expect(atlasBytes()).to.equal(layerBytes);
    const native = gl.getError.bind(gl);
    let refuses = 1;
    gl.getError = () => (refuses-- > 0 ? gl.OUT_OF_MEMORY : native());
    for (let n = slotsOfLayer; n < all.length; n++) add(n);
    expect(atlasBytes()).to.equal(layerBytes);
    expect([finer.count, finer.maxSlots]).to.deep.equal([slotsOfLayer, slotsOfLayer]);
    expect(finer.get(all[0]) && !finer.get(all[all.length - 1])).to.equal(true);
    field.dispose();
  });
});
