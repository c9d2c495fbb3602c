// From where a volume of one slice is looked at.
import { expect } from '@esm-bundle/chai';
import { orbitCamera, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import { cartesianGrid } from '../../../../src/volume/grid.ts';
import { normalize } from '../../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import type { Volume } from '../../../../src/volume/volume.ts';
import { CameraRig } from '../../../../src/viewer/camera/camera-rig.ts';
import { faceSlice } from '../../../../src/viewer/camera/face-slice.ts';

/** @param axes - world directions (right, front, head) of the three axes, 1 mm a voxel */
const gridOf = (dimensions: Vector3, [i, j, k]: readonly Vector3[]): Volume['grid'] =>
  cartesianGrid(dimensions, [0, 1, 2].flatMap((row) => [i[row], j[row], k[row], 0]).concat([0, 0, 0, 1]));

/** Where a direction of the world goes on the screen: right, up, towards the eye. */
function onScreen(volume: Pick<Volume, 'grid' | 'radar'>, direction: Vector3): number[] {
  const m = viewMatrix(orbitCamera({ ...faceSlice(volume)!, radius: 1 }, [0, 0, 0], 0.5));
  return [0, 1, 2].map(
    (row) => m[4 * row] * direction[0] + m[4 * row + 1] * direction[1] + m[4 * row + 2] * direction[2],
  );
}

const near = (got: readonly number[], expected: readonly number[]): void =>
  got.forEach((x, n) => expect(x).to.be.closeTo(expected[n], 1e-9));

const [left, back, feet]: Vector3[] = [
  [-1, 0, 0],
  [0, -1, 0],
  [0, 0, -1],
];

describe('a volume of one slice', () => {
  // Rows of a picture in DICOM: to the patient's left, the back or the feet.
  const planes: Record<string, readonly [columns: Vector3, rows: Vector3]> = {
    'an axial one': [left, back],
    'a coronal one': [left, feet],
    'a sagittal one': [back, feet],
  };
  for (const [name, [columns, rows]] of Object.entries(planes))
    it(`is seen as a picture, its columns to the right and its rows down: ${name}`, () => {
      for (const turned of [1, -1]) {
        const across: Vector3 = [
          columns[1] * rows[2] - columns[2] * rows[1],
          columns[2] * rows[0] - columns[0] * rows[2],
          columns[0] * rows[1] - columns[1] * rows[0],
        ];
        const grid = gridOf([30, 20, 1], [columns, rows, across.map((n) => turned * n) as unknown as Vector3]);
        near(onScreen({ grid }, columns), [1, 0, 0]);
        near(onScreen({ grid }, rows), [0, -1, 0]);
      }
    });

  it('may be one along any axis of the file, and be turned', () => {
    const grid = gridOf([1, 30, 20], [left, back, feet]);
    near(onScreen({ grid }, back), [1, 0, 0]);
    near(onScreen({ grid }, feet), [0, -1, 0]);
    const normal = normalize([0.3, 0.9, 0.2]);
    const columns = normalize([-0.9, 0.3, 0]);
    const rows: Vector3 = [
      columns[1] * normal[2] - columns[2] * normal[1],
      columns[2] * normal[0] - columns[0] * normal[2],
      columns[0] * normal[1] - columns[1] * normal[0],
    ];
    near(onScreen({ grid: gridOf([30, 20, 1], [columns, rows, normal]) }, normal), [0, 0, 1]);
  });

  it('that is nearly level is not turned upside down', () => {
    for (const tilt of [0.05, -0.05, 0.6, -0.6])
      near(
        onScreen(
          {
            grid: gridOf(
              [30, 20, 1],
              [left, [0, -Math.cos(tilt), Math.sin(tilt)], [0, Math.sin(tilt), Math.cos(tilt)]],
            ),
          },
          left,
        ),
        [1, 0, 0],
      );
  });

  it('of a radar is seen from above, the north up', () => {
    const grid = gridOf(
      [30, 20, 1],
      [
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
      ],
    );
    const volume = { grid, radar: {} as Volume['radar'] };
    near(onScreen(volume, [0, 1, 0]), [0, 1, 0]);
    near(onScreen(volume, [1, 0, 0]), [1, 0, 0]);
  });

  it('is none where there are more slices, or no picture', () => {
    for (const dimensions of [
      [30, 20, 2],
      [30, 1, 1],
      [1, 1, 1],
    ] as const)
      expect(faceSlice({ grid: gridOf(dimensions, [left, back, feet]) })).to.equal(undefined);
  });

  it('turns the camera, except where the author says a direction', () => {
    const subject = (usual?: { theta: number; phi: number }) => ({
      center: [0, 0, 0] as const,
      radius: 10,
      findFraming: () => Object.assign(() => ({ target: [0, 0, 0] as Vector3, radius: 30 }), { usual }),
    });
    const rig = new CameraRig();
    rig.setSubject(subject({ theta: 0, phi: Math.PI }));
    near(rig.camera.eye, [0, 0, -30]);
    rig.setAttributes({ theta: 0, phi: Math.PI / 2 });
    near(rig.camera.eye, [0, 30, 0]);
    const usual = new CameraRig();
    usual.setSubject(subject());
    expect(usual.camera.eye[2]).to.be.above(5);
  });
});
