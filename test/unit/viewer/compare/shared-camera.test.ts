import { expect } from '@esm-bundle/chai';
import { orbitCamera, orbitOf } from '../../../../src/optics/rays/camera.ts';
import type { Camera } from '../../../../src/optics/rays/camera.ts';
import { SharedCamera } from '../../../../src/viewer/compare/shared-camera.ts';
import type { FollowingView } from '../../../../src/viewer/compare/shared-camera.ts';
import { matchScan } from '../../../../src/viewer/compare/match-scan.ts';
import { add } from '../../../../src/volume/matrix.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';

const at = (theta: number, radius = 90, target: Vector3 = [0, 0, 0]): Camera =>
  orbitCamera({ theta, phi: 1.2, radius }, target, 0.5);

/** A view without a picture: its camera comes no nearer than `nearest`. */
class Seat implements FollowingView {
  camera: Camera | null = null;
  follows = 0;

  constructor(
    readonly origin: Vector3 = [0, 0, 0],
    readonly nearest = 0,
  ) {}

  follow(camera: Camera): void {
    this.follows++;
    const orbit = orbitOf(camera);
    this.camera = orbitCamera(
      { ...orbit, radius: Math.max(this.nearest, orbit.radius) },
      camera.target,
      camera.fieldOfView,
    );
  }
}

function start(...seats: [Seat, Seat]): { seats: [Seat, Seat]; shared: SharedCamera; draw: () => void } {
  const shared = new SharedCamera(seats);
  /** Pictures of both, as long as one of them is sent somewhere; an echo would go on for ever. */
  const draw = (): void => {
    for (let i = 0, before = -1; before !== seats[0].follows + seats[1].follows; i++) {
      before = seats[0].follows + seats[1].follows;
      shared.update(0);
      shared.update(1);
      if (i > 5) throw new Error('an echo');
    }
  };
  return { seats, shared, draw };
}

const near = (got: Camera | null, expected: Camera): void => {
  for (const name of ['eye', 'target', 'up'] as const)
    got![name].forEach((x, axis) => expect(x, `${name} ${axis}`).to.be.closeTo(expected[name][axis], 1e-9));
  expect(got!.fieldOfView).to.equal(expected.fieldOfView);
};

describe('the camera of two views', () => {
  it('is that of the first one, whichever comes first', () => {
    for (const order of [
      [0, 1],
      [1, 0],
    ]) {
      const { seats, draw } = start(new Seat(), new Seat());
      for (const index of order) {
        seats[index].camera = at(index);
        draw();
      }
      near(seats[0].camera, at(0));
      near(seats[1].camera, at(0));
    }
  });

  it('is that of the view that somebody moves, and it is not echoed', () => {
    const { seats, draw } = start(new Seat(), new Seat());
    seats[0].camera = at(0);
    seats[1].camera = at(1);
    draw();
    for (const [index, theta] of [
      [1, 2],
      [0, -1],
      [0, -2],
      [1, 3],
    ] as const) {
      // prettier-ignore
      seats[index].camera = at(theta, 50, [1, 2, 3]);
      const before = seats[0].follows + seats[1].follows;
      draw();
      expect(seats[0].follows + seats[1].follows).to.equal(before + 1);
      near(seats[1 - index].camera, at(theta, 50, [1, 2, 3]));
    }
  });

  it('stays where a hand put it, when the first view comes later', () => {
    const { seats, draw } = start(new Seat(), new Seat());
    seats[1].camera = at(1);
    draw();
    seats[1].camera = at(2);
    draw();
    seats[0].camera = at(0);
    draw();
    near(seats[0].camera, at(2));
    near(seats[1].camera, at(2));
  });

  it('of one whose limits stop it does not pull the other one back', () => {
    const { seats, draw } = start(new Seat(), new Seat([0, 0, 0], 60));
    seats[0].camera = at(0);
    seats[1].camera = at(0);
    draw();
    seats[0].camera = at(0, 20);
    draw();
    near(seats[0].camera, at(0, 20));
    near(seats[1].camera, at(0, 60));
    seats[1].camera = at(1, 70);
    draw();
    near(seats[0].camera, at(1, 70));
  });

  it('is at one place of the world, where each view has an origin of its own', () => {
    const origin: Vector3 = [1000, -500, 0];
    const { seats, draw } = start(new Seat(), new Seat(origin));
    seats[0].camera = at(0, 90, [1, 1, 1]);
    draw();
    seats[1].camera = at(1);
    draw();
    near(seats[1].camera, at(0, 90, [-999, 501, 1]));
    seats[1].camera = at(2, 40, [5, 5, 5]);
    draw();
    near(seats[0].camera, at(2, 40, add([5, 5, 5], origin)));
  });

  it('of an empty view is not asked for', () => {
    const { seats, draw } = start(new Seat(), new Seat());
    seats[0].camera = at(0);
    draw();
    expect(seats.map(({ follows }) => follows)).to.deep.equal([0, 0]);
    expect(seats[1].camera).to.equal(null);
  });
});

describe('the scan of the other view', () => {
  const times = ['2018-12-20T06:00:00Z', '2018-12-20T06:10:00Z', '2018-12-20T06:20:00Z'];

  it('is the nearest in time', () => {
    expect(matchScan('2018-12-20T06:14:00Z', 9, times)).to.equal(1);
    expect(matchScan('2018-12-20T06:16:00Z', 0, times)).to.equal(2);
    expect(matchScan('2010-01-01T00:00:00Z', 2, times)).to.equal(0);
  });

  it('has the same number, where times are not known', () => {
    expect(matchScan(null, 1, times)).to.equal(1);
    expect(matchScan('2018-12-20T06:14:00Z', 2, [null, null, null])).to.equal(2);
    expect(matchScan('x', 9, times)).to.equal(2);
  });
});
