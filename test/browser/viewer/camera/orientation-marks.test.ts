// Letters at the sides of a volume. Which letter each axis of the voxels runs to is nibabel's word: see test/fixtures/make-axis-codes.py.
import { expect } from '@esm-bundle/chai';
import { orbitCamera } from '../../../../src/optics/rays/camera.ts';
import { listSides, placeMarks } from '../../../../src/viewer/camera/orientation-marks.ts';
import type { OrientationMark } from '../../../../src/viewer/camera/orientation-marks.ts';
import { length, subtract, transformPoint } from '../../../../src/volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../../../src/volume/matrix.ts';
import { english } from '../../../../src/messages/english-controls.ts';
import { decodeBytes, fetchFixture } from '../../../helpers/decode.ts';

interface AxisCodes {
  readonly cases: readonly { readonly affine: Matrix4; readonly codes: string }[];
}

const { cases } = (await (
  await fetch(new URL('../../../fixtures/axis-codes.json', import.meta.url))
).json()) as AxisCodes;

const letterOf = ({ view }: OrientationMark): string => english.letter[view.name];

/** The sides that a camera sees in the middle, right and up. */
function lookFrom(
  theta: number,
  phi: number,
  target: Vector3 = [0, 0, 0],
): { marks: readonly OrientationMark[]; eye: Vector3 } {
  const camera = orbitCamera({ theta, phi, radius: 1e4 }, target, 0.5);
  return { marks: placeMarks(camera, listSides({ anatomical: true, unit: '' })), eye: camera.eye };
}

const max = (marks: readonly OrientationMark[], key: 'x' | 'y' | 'towards'): string =>
  letterOf(marks.reduce((best, mark) => (mark[key] > best[key] ? mark : best)));

describe('the orientation marker', () => {
  it("has the letters of a patient's sides, each towards who looks from there", () => {
    const sides = listSides({ anatomical: true, unit: '' });
    expect(sides.map(({ name }) => english.letter[name])).to.have.members(['R', 'L', 'A', 'P', 'S', 'I']);
    for (const { name, theta, phi } of sides)
      expect(max(lookFrom(theta, phi).marks, 'towards')).to.equal(english.letter[name]);
    // From the front a patient's left is on the right, and the head above.
    const front = lookFrom(0, Math.PI / 2).marks;
    expect([max(front, 'x'), max(front, 'y')]).to.deep.equal(['L', 'S']);
    for (const { x, y, towards } of lookFrom(0.7, 1.1).marks) expect(Math.hypot(x, y, towards)).to.be.closeTo(1, 1e-12);
  });

  cases.forEach(({ affine, codes }, number) => {
    it(`affine ${number}: whoever turns to the letters ${codes} has the ends of the axes i, j and k before them`, () => {
      const middles = [0, 1, 2].flatMap((axis) =>
        [0, 63].map((end) => {
          const index = [31.5, 31.5, 31.5].map((middle, i) => (i === axis ? end : middle)) as unknown as Vector3;
          return { axis, end, world: transformPoint(affine, index) };
        }),
      );
      const center = transformPoint(affine, [31.5, 31.5, 31.5]);
      const sides = listSides({ anatomical: true, unit: '' });
      for (const axis of [0, 1, 2]) {
        const { theta, phi } = sides.find(({ name }) => english.letter[name] === codes[axis])!;
        const { eye } = lookFrom(theta, phi, center);
        // Voxels have other lengths along other axes: what faces the eye is the end that lies most straight before it.
        const toEye = subtract(eye, center);
        const facing = middles.map(({ world, ...rest }) => {
          const arm = subtract(world, center);
          return {
            ...rest,
            share: arm.reduce((sum, one, i) => sum + one * toEye[i], 0) / (length(arm) * length(toEye)),
          };
        });
        const best = facing.reduce((found, one) => (one.share > found.share ? one : found));
        expect([best.axis, best.end]).to.deep.equal([axis, 63]);
      }
    });
  });

  it('has north, east, south and west of a radar, level, and none of a volume whose axes nobody names', () => {
    const sides = listSides({ moment: 'DBZH', unit: 'dBZ' });
    expect(sides.map(({ name }) => english.letter[name])).to.have.members(['N', 'E', 'S', 'W']);
    // From above with north up, east is on the right. World: x east, y north.
    const marks = placeMarks({ eye: [0, 0, 9], target: [0, 0, 0], up: [0, 1, 0], fieldOfView: 1 }, sides);
    expect([max(marks, 'x'), max(marks, 'y')]).to.deep.equal(['E', 'N']);
    for (const { towards } of marks) expect(towards).to.be.closeTo(0, 1e-12);
    expect(listSides({ unit: '' })).to.deep.equal([]);
    expect(listSides({ anatomical: false, unit: '' })).to.deep.equal([]);
    // Weather in a NIfTI file, whose affine is a patient's by its format.
    expect(listSides({ anatomical: true, unit: 'dBZ' })).to.deep.equal([]);
  });

  // NIfTI: nifti1.h, codes of 0 say "arbitrary coordinates". NRRD: its format definition, "3D-right-handed" and "scanner-xyz" are no patient's.
  // MetaImage: MetaIO leaves AnatomicalOrientation out, or writes "???", where it knows none.
  for (const [path, expected] of Object.entries({
    'nifti/v1-le-i2.nii': true,
    'nifti/v1-le-qform.nii': true,
    'nifti/v2-be-qform.nii': true,
    'nifti/neither.nii': false,
    'nrrd/space-ras.nrrd': true,
    'nrrd/space-lps.nrrd': true,
    'nrrd/space-left-anterior-superior.nrrd': true,
    'nrrd/list-first.nrrd': true,
    'nrrd/space-3d-right-handed.nrrd': false,
    'nrrd/space-scanner-xyz.nrrd': false,
    'nrrd/no-place.nrrd': false,
    'metaimage/by-itk.mha': true,
    'metaimage/f4-big.mha': true,
    'metaimage/no-place.mha': false,
  })) {
    it(`${path} ${expected ? 'says' : 'does not say'} that its axes are a patient's`, async () => {
      const { anatomical } = await decodeBytes(await fetchFixture(path), path);
      expect(anatomical).to.equal(expected);
    });
  }
});
