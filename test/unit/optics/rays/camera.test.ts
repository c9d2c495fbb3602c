import { expect } from '@esm-bundle/chai';
import { framingDistance, orbitCamera, projectionMatrix, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import type { Camera } from '../../../../src/optics/rays/camera.ts';
import { cross, dot, transformDirection, transformPoint } from '../../../../src/volume/matrix.ts';
import type { Matrix4, Vector3 } from '../../../../src/volume/matrix.ts';
import { randomNumbers } from '../../../helpers/synthetic.ts';

const quarter = Math.PI / 2;

function expectNear(got: readonly number[], expected: readonly number[], tolerance = 1e-12): void {
  got.forEach((x, i) =>
    expect(x, `${got.join(' ')} is not ${expected.join(' ')}`).to.be.closeTo(expected[i], tolerance),
  );
}

describe('a camera', () => {
  it('has a rigid view matrix that puts its eye at the origin and its target ahead', () => {
    const random = randomNumbers(6);
    for (let n = 0; n < 50; n++) {
      const target: Vector3 = [random() * 20 - 10, random() * 20, random()];
      const camera = orbitCamera({ theta: random() * 9 - 4, phi: random() * Math.PI, radius: 5 }, target, 1);
      const m = viewMatrix(camera);
      const rows = [0, 4, 8].map((r) => m.slice(r, r + 3) as unknown as Vector3);
      rows.forEach((a, i) => rows.forEach((b, j) => expect(dot(a, b)).to.be.closeTo(i === j ? 1 : 0, 1e-12)));
      expectNear(cross(rows[0], rows[1]), rows[2]);
      expectNear(transformPoint(m, camera.eye), [0, 0, 0], 1e-11);
      expectNear(transformPoint(m, target), [0, 0, -5], 1e-11);
    }
  });

  it("orbits as <model-viewer> does, z up: the front is +y, theta counts to the viewer's right", () => {
    const stand = (theta: number, phi: number): Camera => orbitCamera({ theta, phi, radius: 2 }, [0, 0, 0], 1);
    expectNear(stand(0, quarter).eye, [0, 2, 0]);
    expectNear(stand(quarter, quarter).eye, [-2, 0, 0]);
    expectNear(stand(Math.PI, quarter).eye, [0, -2, 0]);
    expectNear(stand(0, 0).eye, [0, 0, 2]);
    const front = viewMatrix(stand(0, quarter));
    expectNear(transformDirection(front, [0, 0, 1]), [0, 1, 0]); // z is up in the picture,
    expectNear(transformDirection(front, [-1, 0, 0]), [1, 0, 0]); // -x (columns of a mosaic) runs to the right,
    expectNear(transformDirection(front, [0, -1, 0]), [0, 0, -1]); // and -y away.
    // A little to the right of the front, what was in the middle of the front face moves to the left.
    expect(transformPoint(viewMatrix(stand(0.1, quarter)), [0, 1, 0])[0]).to.be.below(0);
  });

  it('does not flip at the poles', () => {
    for (const theta of [0, 1, -2]) {
      for (const pole of [0, Math.PI]) {
        const at = viewMatrix(orbitCamera({ theta, phi: pole, radius: 3 }, [0, 0, 0], 1));
        const inward = pole === 0 ? 1e-6 : -1e-6;
        expectNear(at, viewMatrix(orbitCamera({ theta, phi: pole + inward, radius: 3 }, [0, 0, 0], 1)), 1e-5);
      }
    }
  });
});

describe('a projection', () => {
  const project = (m: Matrix4, [x, y, z]: Vector3): number[] => {
    const w = m[12] * x + m[13] * y + m[14] * z + m[15];
    return [0, 4, 8].map((r) => (m[r] * x + m[r + 1] * y + m[r + 2] * z + m[r + 3]) / w);
  };

  it('maps the edges of the field of view and the clipping planes to -1..1', () => {
    const m = projectionMatrix(1.2, 2, 0.1, 50);
    const top = Math.tan(0.6) * 7;
    expectNear(project(m, [2 * top, top, -7]).slice(0, 2), [1, 1]);
    expect(project(m, [0, 0, -0.1])[2]).to.be.closeTo(-1, 1e-12);
    expect(project(m, [0, 0, -50])[2]).to.be.closeTo(1, 1e-12);
  });

  it('frames a sphere so that it touches the narrower side', () => {
    for (const aspect of [0.5, 1, 3]) {
      const distance = framingDistance(2, 0.8, aspect);
      const halfHeight = Math.tan(0.4);
      const half = Math.atan(Math.min(halfHeight, halfHeight * aspect));
      expect(Math.asin(2 / distance)).to.be.closeTo(half, 1e-12);
    }
  });
});
