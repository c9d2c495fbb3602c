// Where notes stand in panes of slices, against the affine by which the pane's pixels are computed.
import { expect } from '@esm-bundle/chai';
import { Crosshair } from '../../../../src/panes/crosshair.ts';
import { pixelsOf } from '../../../../src/panes/pane-frame.ts';
import { SlicedVolume } from '../../../../src/panes/slice-field.ts';
import { SlicePane } from '../../../../src/panes/slice-pane.ts';
import type { SliceType } from '../../../../src/panes/slice-plane.ts';
import { toPlane } from '../../../../src/panes/slice-plane.ts';
import { placeInPane, placeNames } from '../../../../src/viewer/notes/place-in-pane.ts';
import { cartesianGrid } from '../../../../src/volume/grid.ts';
import { add, scale, transformPoint } from '../../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { obliqueAffine, randomNumbers, syntheticVolume } from '../../../helpers/synthetic.ts';

const dimensions = [20, 24, 16] as const;
const grid = cartesianGrid(dimensions, obliqueAffine(randomNumbers(8), [2, 3, 4], [-30, 12, 5]));
const volume = { ...syntheticVolume({ dimensions, spacing: [2, 3, 4] }), grid } as Volume;
const size = { width: 300, height: 220 };

function paneOf(type: SliceType, thickness = 0, normal: Vector3 = [1, 2, 0.5]): SlicePane {
  const pane = new SlicePane(new Crosshair(), () => {});
  pane.setVolume(new SlicedVolume(volume, grid));
  pane.setSize(size, 2);
  pane.setLook({
    type,
    normal,
    thickness,
    projection: 'average',
    window: [0, 1],
    windowFunction: 'linear-exact',
    isNearest: false,
    colors: null,
  });
  return pane;
}

describe('a note in a pane', () => {
  for (const type of ['axial', 'coronal', 'sagittal', 'oblique'] as const)
    for (const zoom of [1, 2.5])
      it(`is on the pixel that shows its place: ${type}, zoom ${zoom}`, () => {
        const pane = paneOf(type);
        pane.crosshair.moveTo(transformPoint(grid.indexToWorld, [9, 12, 8]));
        pane.zoom(zoom, [180, 90]);
        pane.pan([13, -7]);
        const { d } = toPlane(pane.plane, pane.place);
        // The picture has twice as many pixels as CSS has.
        const [columns, rows] = [2 * size.width, 2 * size.height];
        const pixels = pixelsOf(pane.plane, pane.frame!, size, { d, columns, rows });
        let count = 0;
        for (const [column, row] of [
          [0, 0],
          [599, 439],
          [301, 77],
          [44, 402],
        ]) {
          const world = add(pixels.first, add(scale(pixels.across, column), scale(pixels.down, row)));
          const place = placeInPane(pane, world)!;
          expect(place.isOn).to.equal(true);
          expect(Math.abs(2 * place.point[0] - (column + 0.5))).to.be.below(1e-6);
          expect(Math.abs(2 * place.point[1] - (row + 0.5))).to.be.below(1e-6);
          count++;
        }
        expect(count).to.equal(4);
      });

  it('is in the slice up to half of its thickness, that of a voxel where it has none, and near it up to three', () => {
    for (const type of ['axial', 'oblique'] as const)
      for (const thickness of [0, 9]) {
        const pane = paneOf(type, thickness);
        const own = Math.max(thickness, pane.sliced!.stepAlong(pane.plane.normal));
        const at = (share: number): boolean | null => {
          const place = placeInPane(pane, add(pane.place, scale(pane.plane.normal, share * own)));
          return place && place.isOn;
        };
        expect([0, 0.49, -0.49, 0.51, -0.51, 2.9, -2.9, 3.1, -3.1].map(at)).to.deep.equal([
          true,
          true,
          true,
          false,
          false,
          false,
          false,
          null,
          null,
        ]);
      }
  });

  it('is not shown outside of the picture', () => {
    const pane = paneOf('axial');
    pane.zoom(4, [150, 110]);
    expect(placeInPane(pane, add(pane.place, [200, 0, 0]))).to.equal(null);
    expect(placeInPane(pane, pane.place)!.isOn).to.equal(true);
  });
});

describe('names in a pane', () => {
  it('cover no pin and no other name, and stay in the pane', () => {
    const random = randomNumbers(4);
    let named = 0;
    for (let n = 0; n < 300; n++) {
      const pins = Array.from({ length: 1 + Math.floor(20 * random()) }, () => ({
        point: [size.width * random(), size.height * random()] as const,
        width: 20 + 100 * random(),
      }));
      const lefts = placeNames(pins, size, 20);
      const boxes = lefts.flatMap((left, i) =>
        left === null ? [] : [{ left, right: left + pins[i].width, y: pins[i].point[1] }],
      );
      named += boxes.length;
      boxes.forEach(({ left, right, y }, i) => {
        expect(left).to.be.at.least(0);
        expect(right).to.be.at.most(size.width);
        expect(pins.some(({ point: [px, py] }) => px > left && px < right && Math.abs(py - y) < 10)).to.equal(false);
        for (const other of boxes.slice(0, i))
          expect(other.left < right && left < other.right && Math.abs(other.y - y) < 20).to.equal(false);
      });
    }
    expect(named).to.be.above(300);
  });

  it('stand right of the pin, left of it at the right edge', () => {
    const at = (x: number): number | null => placeNames([{ point: [x, 100], width: 60 }], size, 20)[0];
    expect([at(100), at(280), at(3)]).to.deep.equal([110, 210, 13]);
  });
});
