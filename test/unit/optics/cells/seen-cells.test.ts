import { expect } from '@esm-bundle/chai';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import { contributionOf } from '../../../../src/optics/cells/empty-space-distance.ts';
import { parseTransferFunction } from '../../../../src/optics/transfer/parse-transfer-function.ts';
import { setUpRays } from '../../../../src/optics/rays/rays.ts';
import { renderReference } from '../../../../src/optics/reference.ts';
import { findSeenCells } from '../../../../src/optics/cells/seen-cells.ts';
import { boundSeenCells } from '../../../../src/optics/cells/bound-seen-cells.ts';
import { boundingSphere } from '../../../../src/volume/grid.ts';
import type { Matrix4, Vector3 } from '../../../../src/volume/matrix.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { randomNumbers, syntheticVolume } from '../../../helpers/synthetic.ts';

const transferFunction = parseTransferFunction('0.5 #fff 0, 1 #fff 100%', [0, 1]);
const size = 48;

describe('the cells in which something can be seen', () => {
  const random = randomNumbers(11);
  for (let scene = 0; scene < 8; scene++) {
    it(`bound all pixels that show something, and less than the picture: scene ${scene}`, () => {
      const spot = [0, 1, 2].map(() => 0.15 + 0.7 * random());
      const volume = syntheticVolume({
        dimensions: [40, 30, 50],
        field: (x, y, z) => Math.max(0, 1 - 8 * Math.hypot(x - spot[0], y - spot[1], z - spot[2])),
      });
      const cells = findSeenCells(volume.macrocells, [contributionOf(transferFunction)], volume);
      expect(cells.includes(1)).to.equal(true);
      expect(cells.includes(0)).to.equal(true);
      const { center, radius } = boundingSphere(volume.grid);
      const camera = orbitCamera(
        { theta: 6 * random(), phi: 0.2 + 2.7 * random(), radius: (2 + 2 * random()) * radius },
        center,
        0.6,
      );
      const [view, projection] = [
        viewMatrix(camera),
        projectionMatrix(camera.fieldOfView, 1, radius / 100, radius * 10),
      ];
      const bounds = boundSeenCells(volume, cells, { view, projection })!;
      const picture = renderReference(
        {
          ...volume,
          transferFunction,
          referenceLength: 0.01,
          opacityFactor: 1,
          lightFactor: 1,
          stepLength: radius / 40,
        },
        setUpRays(volume.grid, view, projection)!,
        size,
        size,
      );
      let shown = 0;
      for (let row = 0; row < size; row++) {
        for (let column = 0; column < size; column++) {
          if (picture[(row * size + column) * 4 + 3] === 0) continue;
          shown++;
          const [x, y] = [((column + 0.5) / size) * 2 - 1, 1 - ((row + 0.5) / size) * 2];
          expect(x).to.be.within(bounds[0], bounds[2]);
          expect(y).to.be.within(bounds[1], bounds[3]);
        }
      }
      expect(shown).to.be.above(0);
      expect((bounds[2] - bounds[0]) * (bounds[3] - bounds[1])).to.be.below(2.8);
    });
  }

  it('may be anywhere around an eye among them, and are nowhere where nothing is seen', () => {
    const volume = syntheticVolume({ dimensions: [20, 20, 20], field: () => 1 });
    const cells = findSeenCells(volume.macrocells, [contributionOf(transferFunction)], volume);
    const { center, radius } = boundingSphere(volume.grid);
    const camera = orbitCamera({ theta: 1, phi: 1, radius: 0.2 * radius }, center, 0.6);
    const view = { view: viewMatrix(camera), projection: projectionMatrix(0.6, 1, radius / 100, radius * 10) };
    expect(boundSeenCells(volume, cells, view)).to.deep.equal([-1, -1, 1, 1]);
    expect(boundSeenCells(volume, cells.fill(0), view)).to.equal(null);
  });

  describe('of which some are out of sight', () => {
    const edge = 80;
    /** Cubes of eight voxels, each of which is in some cells. @param places - by the first voxel */
    const cubes = (...places: readonly Vector3[]): { volume: Volume; cells: Uint8Array } => {
      const volume = syntheticVolume({
        dimensions: [edge, edge, edge],
        field: (...at) =>
          Number(
            places.some((place) =>
              at.every((x, axis) => Math.floor(x * edge) >= place[axis] && Math.floor(x * edge) < place[axis] + 2),
            ),
          ),
      });
      return { volume, cells: findSeenCells(volume.macrocells, [contributionOf(transferFunction)], volume) };
    };
    /** From a place of the world, in voxels around the middle, along the second axis of the grid, which runs to -y, or against it. */
    const appearance = (eye: Vector3, along: 1 | -1): { view: Matrix4; projection: Matrix4 } => ({
      view: viewMatrix({ eye, target: [eye[0], eye[1] - along, eye[2]], up: [0, 0, 1], fieldOfView: 0.6 }),
      projection: projectionMatrix(0.6, 1, 0.1, 1000),
    });

    it('leave out those behind the eye', () => {
      const { volume, cells } = cubes([43, 75, 43], [44, 4, 40]);
      const ahead = boundSeenCells(volume, cells, appearance([0, 0, 0], 1))!;
      const alone = cubes([43, 75, 43]);
      expect(ahead).to.deep.equal(boundSeenCells(alone.volume, alone.cells, appearance([0, 0, 0], 1)));
      expect((ahead[2] - ahead[0]) * (ahead[3] - ahead[1])).to.be.within(0.1, 3.9);
      expect(boundSeenCells(alone.volume, alone.cells, appearance([0, 0, 0], -1)), 'all of them behind').to.equal(null);
      expect(boundSeenCells(alone.volume, alone.cells, appearance([0, -90, 0], 1)), 'the volume behind').to.equal(null);
    });

    it('leave out those outside the picture, also where it is between them', () => {
      const { volume, cells } = cubes([2, 60, 40], [76, 60, 40]);
      expect(boundSeenCells(volume, cells, appearance([0, 0, 0], 1)), 'on both sides').to.equal(null);
      const far = boundSeenCells(volume, cells, appearance([0, 200, 0], 1))!;
      expect(far[0]).to.be.within(-0.7, -0.5);
      expect(far[2]).to.be.within(0.5, 0.7);
    });

    it('reach to the edge of the picture where the eye is next to them', () => {
      const { volume, cells } = cubes([40, 36, 40], [40, 40, 40]);
      expect(boundSeenCells(volume, cells, appearance([0, 0, 0], 1))).to.deep.equal([-1, -1, 1, 1]);
      expect(boundSeenCells(volume, cells, appearance([20, 0, 0], 1)), 'from their side').to.deep.equal(null);
      const attached = boundSeenCells(volume, cells, appearance([9, 14, 0], 1))!;
      expect(attached[0]).to.be.above(0.1);
      expect(attached[2]).to.equal(1);
    });
  });
});
