// The light that reaches the cells of a volume from all sides.
import { expect } from '@esm-bundle/chai';
import { ambientAt, ambientShade, margin, measureAmbientLight } from '../../../../src/optics/rays/ambient-light.ts';
import type { AmbientLight } from '../../../../src/optics/rays/ambient-light.ts';
import { uncut } from '../../../../src/optics/rays/cut-fade.ts';
import type { CutFaces } from '../../../../src/optics/rays/cut-fade.ts';
import type { Premultiplied, TransferFunction } from '../../../../src/optics/transfer/transfer-function.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';
import type { SyntheticOptions } from '../../../helpers/synthetic.ts';

const solid: TransferFunction = [
  { value: 0.5, color: [1, 1, 1], opacity: 0 },
  { value: 0.6, color: [1, 1, 1], opacity: 0.99 },
];

function measure(data: SyntheticOptions, cuts: CutFaces = uncut, transferFunction = solid): AmbientLight {
  const volume = syntheticVolume(data);
  return measureAmbientLight({ volume, transferFunction, referenceLength: 1, opacityFactor: 1, cuts });
}

const cube: Vector3 = [64, 64, 64];

/** A block with a flat top at z = 0.5 in which there is a shaft, an eighth wide, down to z = 0.2. */
const shaft = (x: number, y: number, z: number): number =>
  z < 0.5 && !(z > 0.2 && Math.abs(x - 0.5) < 1 / 16 && Math.abs(y - 0.5) < 1 / 16) ? 1 : 0;

describe('ambient light', () => {
  it('is whole where nothing shows, and where values have no data', () => {
    expect(new Set(measure({ dimensions: [9, 8, 7], field: () => 0 }).light)).to.deep.equal(new Set([255]));
    const nothing = measure({ dimensions: [9, 8, 7], kind: 'float32', field: () => NaN });
    expect(new Set(nothing.light)).to.deep.equal(new Set([255]));
  });

  it('is whole above a plane, and falls with the depth of a shaft in it', () => {
    const ambient = ambientAt(measure({ dimensions: cube, field: shaft }));
    // 1.5 cells in front of a surface, as shading looks it up. 9 of 26 directions of a plane are hidden, a little less with distance: 0.68 is open.
    expect(ambient([0.2, 0.3, 0.5 + 1.5 / 64])).to.be.above(0.98);
    const down = [0.48, 0.4, 0.3, 0.23].map((z) => ambient([0.5, 0.5, z]));
    for (let i = 1; i < down.length; i++) expect(down[i], `level ${i}`).to.be.below(down[i - 1]);
    expect(down[3]).to.be.within(0.1, 0.4);
    expect(ambient([0.2, 0.3, 0.25]), 'in the block').to.be.closeTo(0.1, 0.02);
  });

  it('does not depend on the side from which cells are gathered', () => {
    const size = 12 + 2 * margin;
    const ball = measure({
      dimensions: [12, 12, 12],
      field: (x, y, z) => (Math.hypot(x - 0.5, y - 0.5, z - 0.5) < 0.3 ? 1 : 0),
    });
    expect(ball.dimensions).to.deep.equal([size, size, size]);
    const at = (i: number, j: number, k: number): number => ball.light[i + size * (j + size * k)];
    for (let k = 0; k < size; k++)
      for (let j = 0; j < size; j++)
        for (let i = 0; i < size; i++) {
          // The middle of an even number of cells lies between two.
          const others = [at(size - 1 - i, j, k), at(i, size - 1 - j, k), at(i, j, size - 1 - k), at(k, i, j)];
          for (const other of others) expect(other).to.be.closeTo(at(i, j, k), 1);
        }
    expect(Math.min(...ball.light)).to.be.below(60);
  });

  it('reaches what a cut lays open, and matter in front of a region hides nothing', () => {
    const inside: Vector3 = [0.5, 0.5, 0.5 + 1.5 / 64];
    const whole = ambientAt(measure({ dimensions: cube, field: () => 1 }));
    const half = ambientAt(
      measure({ dimensions: cube, field: () => 1 }, { ...uncut, halfSpaces: [{ normal: [0, 0, -1], offset: -0.5 }] }),
    );
    expect(whole(inside)).to.be.below(0.15);
    expect(half(inside)).to.be.above(0.95);
    expect(half([0.5, 0.5, 0.2])).to.be.closeTo(whole([0.5, 0.5, 0.2]), 0.1);
  });

  it('has at most 64 cells along an edge, of about the same length in the world, and no more than there are voxels', () => {
    const shape = (data: SyntheticOptions): readonly number[] =>
      measure({ ...data, field: () => 0 }).dimensions.map((n) => n - 2 * margin);
    expect(shape({ dimensions: [128, 64, 32] })).to.deep.equal([64, 32, 16]);
    expect(shape({ dimensions: [128, 128, 8], spacing: [1, 1, 16] })).to.deep.equal([64, 64, 8]);
    expect(shape({ dimensions: [1, 1, 1] })).to.deep.equal([1, 1, 1]);
    expect(measure({ dimensions: [128, 64, 32], spacing: [2, 2, 2] }).ahead).to.be.closeTo(1.5 * 4, 1e-12);
  });

  it('is less the denser a volume is drawn', () => {
    const volume = syntheticVolume({ dimensions: [32, 32, 32], field: shaft });
    const light = (opacityFactor: number): number => {
      const thin = [solid[0], { ...solid[1], opacity: 0.01 }];
      const rest = { volume, referenceLength: 1, transferFunction: thin, cuts: uncut };
      return ambientAt(measureAmbientLight({ ...rest, opacityFactor }))([0.5, 0.5, 0.25]);
    };
    expect(light(20)).to.be.above(light(60) + 0.01);
    expect(light(60)).to.be.above(light(600) + 0.01);
  });

  it('darkens a piece by the light in front of its middle, its opacity stays, and a face of the volume keeps its colour', () => {
    const { grid } = syntheticVolume({ dimensions: cube, field: shaft });
    const map = measure({ dimensions: cube, field: shaft });
    const shade = ambientShade(map, grid, uncut);
    const along = (a: Vector3, b: Vector3): Premultiplied => {
      const [front, back] = [a, b].map((point) => ({ value: 1, valid: true, point }));
      return shade({ front, back, begin: 0, span: 0.1 }, [0.5, 0.25, 0, 0.5], {
        origin: [0.5, 0.5, 2],
        direction: [0, 0, -1],
      } as never);
    };
    const light = ambientAt(map)([0.5, 0.5, 0.25 + 1.5 / 64]);
    expect(light).to.be.within(0.1, 0.6);
    expect(along([0.5, 0.5, 0.26], [0.5, 0.5, 0.24])).to.deep.equal([0.5 * light, 0.25 * light, 0, 0.5]);
    expect(along([0, 0.5, 0.26], [0, 0.5, 0.24])).to.deep.equal([0.5, 0.25, 0, 0.5]);
  });
});
