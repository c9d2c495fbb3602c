import { expect } from '@esm-bundle/chai';
import { frameViewpoint } from '../../../../src/optics/rays/viewpoint-frame.ts';
import { pan, rotate, zoom, zoomAt, zoomFrom } from '../../../../src/viewer/camera/camera-moves.ts';
import { CameraRig } from '../../../../src/viewer/camera/camera-rig.ts';
import { defaultLimits } from '../../../../src/viewer/model/camera-attributes.ts';
import type { Vector3 } from '../../../../src/volume/matrix.ts';
import { length, normalize, subtract } from '../../../../src/volume/matrix.ts';

const degrees = Math.PI / 180;
const subject = { center: [10, -20, 30] as Vector3, radius: 100 };

function place(
  attributes: Parameters<CameraRig['setAttributes']>[0] = {},
  changes: Partial<Parameters<CameraRig['setSubject']>[0]> = {},
): CameraRig {
  const rig = new CameraRig();
  rig.setAttributes(attributes);
  rig.setSubject({ ...subject, ...changes });
  return rig;
}

/** Half the angle under which the framed part of the subject is seen. */
function angleOf({ camera }: CameraRig, radius = subject.radius): number {
  return Math.asin((0.68 * radius) / length(subtract(camera.eye, camera.target)));
}

function expectNear(got: Vector3, expected: Vector3, tolerance = 1e-9): void {
  got.forEach((x, axis) => expect(x).to.be.closeTo(expected[axis], tolerance));
}

/** Frames until it has arrived. */
function arrive(rig: CameraRig): number {
  let frames = 0;
  for (; rig.moving && frames < 1000; frames++) rig.advance(16, false);
  return frames;
}

describe('the camera rig', () => {
  it('frames its subject: the shorter side of the picture just holds most of it', () => {
    const rig = place();
    expectNear(rig.camera.target, subject.center);
    expect(angleOf(rig)).to.be.closeTo(rig.camera.fieldOfView / 2, 1e-9);
    rig.setAspect(2);
    expect(angleOf(rig), 'a wide picture').to.be.closeTo(rig.camera.fieldOfView / 2, 1e-9);
    rig.setAspect(0.5);
    const across = Math.atan(Math.tan(rig.camera.fieldOfView / 2) * 0.5);
    expect(angleOf(rig), 'a tall one').to.be.closeTo(across, 1e-9);
  });

  it("looks from the patient's front left and above, at the weather from the south and higher up", () => {
    const [body, weather] = [{}, { isWeather: true }].map((changes) => {
      const { camera } = place({}, changes);
      return normalize(subtract(camera.eye, camera.target));
    });
    expect(body[2]).to.be.closeTo(Math.cos(75 * degrees), 1e-9);
    expect(weather[2]).to.be.closeTo(Math.cos(62 * degrees), 1e-9);
    expect(weather[1], 'north is ahead').to.be.below(-0.5);
    expect(Math.sign(body[1])).to.equal(-Math.sign(weather[1]));
  });

  it('frames what stood in for a volume again when that is there; not where a person has turned it', () => {
    const framed = (radius: number): Pick<Parameters<CameraRig['setSubject']>[0], 'findFraming'> => ({
      findFraming: () => () => ({ target: subject.center, radius }),
    });
    const rig = place({}, { isCoarse: true, ...framed(150) });
    expect(rig.orbit.radius).to.equal(150);
    const rounded = { ...subject, center: subject.center.map((c) => c + 1e-12) as unknown as Vector3 };
    rig.setSubject({ ...rounded, ...framed(151) });
    expect(rig.orbit.radius, 'of the volume').to.equal(151);
    rig.setSubject({ ...subject, ...framed(152) });
    expect(rig.orbit.radius, 'of a volume after it, in the same place').to.equal(151);
    const turned = place({}, { isCoarse: true, ...framed(150) });
    rotate(turned, 0.3, 0);
    arrive(turned);
    const { eye } = turned.camera;
    turned.setSubject({ ...rounded, ...framed(151) });
    expectNear(turned.camera.eye, eye);
  });

  it('follows attributes: angles, a radius in world units or in parts of the framing, a target', () => {
    const orbit = { theta: 20 * degrees, phi: 50 * degrees };
    expect(place({ ...orbit, radius: { world: 77 } }).orbit).to.deep.equal({ ...orbit, radius: 77 });
    const [one, half] = [1, 0.5].map((fraction) => place({ radius: { fraction } }).orbit.radius);
    expect(half / one).to.be.closeTo(0.5, 1e-12);
    expectNear(place({ target: [1, 2, 3] }).camera.target, [1, 2, 3]);
    const narrow = place({ fieldOfView: 10 * degrees });
    expect(angleOf(narrow)).to.be.closeTo(5 * degrees, 1e-9);
  });

  it('turns by angles, not beyond the poles, and keeps its distance', () => {
    const rig = place({ theta: 0, phi: 90 * degrees, radius: { world: 50 } });
    rotate(rig, 30 * degrees, -40 * degrees);
    expect(rig.touched).to.equal(true);
    arrive(rig);
    expect(rig.orbit).to.deep.equal({ theta: 30 * degrees, phi: 50 * degrees, radius: 50 });
    expect(length(subtract(rig.camera.eye, rig.camera.target))).to.be.closeTo(50, 1e-9);
    rotate(rig, 0, -10);
    arrive(rig);
    expect(rig.orbit.phi).to.equal(0);
    rotate(rig, 0, 10);
    arrive(rig);
    expect(rig.orbit.phi).to.equal(Math.PI);
  });

  it("zooms between a fiftieth of the subject's radius and four times the distance that just shows it, or where the author placed it", () => {
    const rig = place({ radius: { world: 100 } });
    zoom(rig, 0.5);
    arrive(rig);
    expect(rig.orbit.radius).to.be.closeTo(50, 1e-9);
    zoom(rig, 1e-6);
    arrive(rig);
    expect(rig.orbit.radius).to.be.closeTo(2, 1e-9);
    zoom(rig, 1e9);
    arrive(rig);
    const framed = (0.68 * subject.radius) / Math.sin(rig.camera.fieldOfView / 2);
    expect(rig.orbit.radius).to.be.closeTo(4 * framed, 1e-9);
    const far = place({ radius: { world: 9 * framed } });
    zoom(far, 2);
    expect(far.goal.radius).to.equal(9 * framed);
    zoom(far, 0.5);
    expect(far.goal.radius).to.equal(4.5 * framed);
    zoom(far, 3);
    expect(far.goal.radius).to.equal(9 * framed);
  });

  it("is not lost by twelve clicks of the wheel at the picture's edge, each 100 pixels", () => {
    const rig = place();
    const framed = rig.orbit.radius;
    for (let i = 0; i < 12; i++) zoomFrom(rig, 2 ** (100 / 600), [1.2, -0.9]);
    arrive(rig);
    expect(rig.orbit.radius).to.be.closeTo(4 * framed, 1e-9);
    expectNear(rig.camera.target, subject.center);
  });

  it('comes back to what it looked at first, whatever the pointer is over on the way out', () => {
    const rig = place();
    const offset = (): number => length(subtract(rig.goal.target, rig.home.target));
    for (let i = 0; i < 6; i++) zoomFrom(rig, 0.8, [0.9, 0.5]);
    const aside = offset();
    expect(aside).to.be.above(0.4 * subject.radius);
    for (let i = 0; i < 6; i++) zoomFrom(rig, 1 / 0.8, [0.9, 0.5]);
    expect(offset(), 'over the same place').to.be.below(1e-9 * aside);
    for (let i = 0; i < 6; i++) zoomFrom(rig, 0.8, [0.9, 0.5]);
    for (let i = 0; i < 6; i++) {
      const before = offset();
      zoomFrom(rig, 1 / 0.8, [-0.9, -0.5]);
      expect(offset(), 'over the other side').to.be.below(before);
    }
    expect(offset()).to.be.below(0.3 * aside);
    for (let i = 0; i < 20; i++) zoomFrom(rig, 1 / 0.8, [-0.9, -0.5]);
    expect(offset()).to.be.below(0.01 * aside);
    // What a hand has moved, a key that zooms in and out again leaves there.
    const moved = place();
    pan(moved, [0.4, 0]);
    const { target } = moved.goal;
    for (const factor of [0.8, 1 / 0.8]) zoomFrom(moved, factor, [0, 0]);
    expectNear(moved.goal.target, target);
    // Fingers hold what lies between them.
    zoomAt(moved, 2, [0.5, 0.5]);
    zoomAt(moved, 0.5, [0.5, 0.5]);
    expectNear(moved.goal.target, target);
  });

  it('always has some of the subject in the picture, however it is moved', () => {
    const rig = place();
    for (let i = 0; i < 9; i++) pan(rig, [1.2, 0.8]);
    expect(length(subtract(rig.goal.target, subject.center))).to.be.closeTo(subject.radius, 1e-9);
    const target: Vector3 = [10, 380, 30];
    const aside = place({ target });
    pan(aside, [0.1, 0.1]);
    expect(length(subtract(aside.goal.target, subject.center)), 'an author may look farther aside').to.be.closeTo(
      400,
      1e-6,
    );
  });

  it("keeps within an author's limits: hands, attributes, sides; to and fro in them by itself", () => {
    const rig = place({ theta: 0, phi: 1, radius: { world: 200 } });
    rig.setLimits({
      ...defaultLimits,
      min: { theta: -1, phi: 0.5, radius: { fraction: 0.5 } },
      max: { theta: 1, phi: 1.2, radius: { world: 300 } },
    });
    rotate(rig, 2, -2);
    zoom(rig, 10);
    arrive(rig);
    expect(rig.orbit).to.deep.equal({ theta: 1, phi: 0.5, radius: 300 });
    rotate(rig, -9, 9);
    zoom(rig, 0.01);
    arrive(rig);
    const framed = (0.68 * subject.radius) / Math.sin(rig.camera.fieldOfView / 2);
    expect(rig.orbit.theta).to.equal(-1);
    expect(rig.orbit.phi).to.equal(1.2);
    expect(rig.orbit.radius).to.be.closeTo(framed / 2, 1e-9);
    rig.turnTo(Math.PI, 0);
    expect([rig.goal.theta, rig.goal.phi]).to.deep.equal([-1, 0.5]);
    rig.setAttributes({ theta: 3, phi: 3, radius: { world: 999 } });
    expect(rig.orbit).to.deep.equal({ theta: 1, phi: 1.2, radius: 300 });
    rig.spin = 0.01;
    const seen = Array.from({ length: 60 }, () => (rig.advance(10, false), rig.orbit.theta));
    expect(Math.max(...seen)).to.be.at.most(1);
    expect(Math.min(...seen)).to.be.within(-1, -0.8);
    rig.spin = 0;
    rig.setLimits(defaultLimits);
    expect(rig.orbit.theta).to.equal(3);
    rig.setLimits({ ...defaultLimits, min: { theta: 200 * degrees }, max: { theta: 340 * degrees } });
    rig.setAttributes({ theta: 210 * degrees });
    rig.turnTo(-90 * degrees, 1);
    expect(rig.goal.theta / degrees, 'the same side, counted from another turn').to.be.closeTo(270, 1e-9);
  });

  it('glides where attributes send it once there is a picture, as slowly as they say, the short way', () => {
    const rig = place({ theta: 0, phi: 1, radius: { world: 200 } });
    rig.setAttributes({ theta: 1, phi: 1, radius: { world: 100 }, fieldOfView: 0.3 }, false);
    expect([rig.orbit.theta, rig.placing, rig.touched]).to.deep.equal([0, true, false]);
    rig.advance(120, false);
    expect(rig.orbit.theta).to.be.closeTo(1 - Math.exp(-1), 1e-9);
    expect(rig.orbit.radius).to.be.closeTo(100 + 100 / Math.E, 1e-9);
    expect(rig.camera.fieldOfView).to.be.closeTo(0.3 + (Math.PI / 6 - 0.3) / Math.E, 1e-9);
    arrive(rig);
    expect([rig.orbit, rig.placing]).to.deep.equal([{ theta: 1, phi: 1, radius: 100 }, false]);
    rig.setLimits({ ...defaultLimits, decay: 0 });
    rig.setAttributes({ theta: 2 }, false);
    rig.advance(1, false);
    expect(rig.moving).to.equal(false);
    rotate(rig, 5.5 * Math.PI, 0); // Less than a turn is taken from each.
    rotate(rig, 5.5 * Math.PI, 0);
    arrive(rig);
    rig.setLimits(defaultLimits);
    rig.reset();
    rig.advance(1, false);
    expect(Math.abs(rig.orbit.theta - 2)).to.be.below(Math.PI + 1e-9);
    rig.setAttributes({ theta: 1 }, false);
    rotate(rig, 0.1, 0);
    expect(rig.placing, 'a hand takes over').to.equal(false);
    rig.jump();
    expect(rig.orbit.theta).to.be.closeTo(1.1, 1e-9);
  });

  it('goes around by itself, and a hand or the page goes on from where it is', () => {
    const rig = place({ theta: 0, phi: 1, radius: { world: 200 } });
    rig.spin = 0.001;
    rig.advance(500, false);
    expect([rig.orbit.theta, rig.spun, rig.touched, rig.moving]).to.deep.equal([0.5, true, false, false]);
    expectNear(rig.camera.eye, rig.cameraAt({ ...rig.home, theta: 0.5 }).eye);
    rig.setAspect(2);
    expect(rig.orbit.theta, 'in a picture of another shape too').to.equal(0.5);
    rotate(rig, 0.25, 0);
    rig.spin = 0;
    expect([rig.orbit.theta, rig.spun]).to.deep.equal([0.5, false]);
    arrive(rig);
    expect(rig.orbit.theta).to.be.closeTo(0.75, 1e-9);
    rig.spin = 0.001;
    rig.advance(500, false);
    rig.setAttributes({ theta: 0 }, false);
    expect(rig.orbit.theta).to.be.closeTo(1.25, 1e-9);
    rig.spin = 0;
    arrive(rig);
    expect(rig.orbit.theta).to.equal(0);
  });

  it('glides: 63 % of the way in 60 ms, however many frames that takes; with reduced motion it is there at once', () => {
    const [inOne, inSix, atOnce] = [[60], [10, 10, 10, 10, 10, 10], []].map((frames) => {
      const rig = place({ theta: 0, phi: 1, radius: { world: 50 } });
      rotate(rig, 1, 0);
      expect(rig.moving).to.equal(true);
      for (const ms of frames) rig.advance(ms, false);
      if (frames.length === 0) rig.advance(1, true);
      return rig;
    });
    expect(inOne.orbit.theta).to.be.closeTo(1 - Math.exp(-1), 1e-9);
    expect(inSix.orbit.theta).to.be.closeTo(inOne.orbit.theta, 1e-9);
    expect([atOnce.orbit.theta, atOnce.moving]).to.deep.equal([1, false]);
    expect(arrive(inOne), 'frames of 16 ms').to.be.within(10, 60);
    expect(inOne.orbit.theta).to.equal(1);
  });

  it('goes back to where the author placed it, and is untouched then', () => {
    const rig = place({ theta: 0.3, phi: 0.9, radius: { world: 60 } });
    const { eye } = rig.camera;
    rotate(rig, 2, 0.5);
    zoom(rig, 3);
    arrive(rig);
    rig.reset();
    expect([rig.touched, rig.moving]).to.deep.equal([false, true]);
    arrive(rig);
    expectNear(rig.camera.eye, eye);
  });

  it("keeps a person's view for a volume in the same place, and gives it up for another one", () => {
    const rig = place();
    rotate(rig, 1, 0);
    arrive(rig);
    const turned = rig.camera;
    rig.setSubject({ ...subject });
    expect(rig.camera).to.deep.equal(turned);
    rig.setAspect(1.7);
    expect(rig.camera, 'nor does another shape of the picture').to.deep.equal(turned);
    rig.setSubject({ ...subject, radius: 50 });
    expect(rig.touched).to.equal(false);
    expect(angleOf(rig, 50)).to.be.closeTo(rig.camera.fieldOfView / 2, 1e-9);
  });

  it("begins at an author's viewpoint, and turns around its centre of rotation, else around what it looks at", () => {
    const camera = {
      eye: [10, -220, 30] as Vector3,
      target: [10, -219, 30] as Vector3,
      up: [0, 0, 1] as Vector3,
      fieldOfView: 0.7,
    };
    for (const [centerOfRotation, target] of [
      [
        [10, -100, 30],
        [10, -100, 30],
      ],
      [null, subject.center],
    ] as [Vector3 | null, Vector3][]) {
      const rig = place();
      rig.setViewpoint((shown) => frameViewpoint(camera, centerOfRotation, shown));
      expectNear(rig.camera.eye, camera.eye);
      expectNear(rig.camera.target, target);
      expectNear(rig.camera.up, camera.up);
      expect(rig.camera.fieldOfView).to.equal(0.7);
      rotate(rig, Math.PI, 0);
      arrive(rig);
      expectNear(rig.camera.eye, [10, 2 * target[1] + 220, 30], 1e-6);
    }
  });

  it('comes to rest whatever it is given, and looks from somewhere', () => {
    const rig = place();
    for (const [theta, phi] of [
      [NaN, 0],
      [0, Infinity],
      [1e308, -1e308],
      [0.1, 0.1],
    ])
      rotate(rig, theta, phi);
    for (const factor of [NaN, 0, -1, Infinity, 1e-320, 1.1]) zoom(rig, factor);
    rig.setSubject({ center: [NaN, 0, 0], radius: 1 });
    rig.setSubject({ center: [0, 0, 0], radius: Infinity });
    rig.setSubject({ center: [1e308, 1e308, 0], radius: 1e308 });
    rotate(rig, 0.1, 0);
    expect(arrive(rig)).to.be.below(1000);
    rig.setSubject({ center: [0, 0, 0], radius: 0 });
    rotate(rig, 0.1, 0);
    zoom(rig, 2);
    expect(arrive(rig), 'a point').to.be.below(1000);
    expect([...rig.camera.eye, ...rig.camera.up].every(Number.isFinite)).to.equal(true);
  });

  it('says that attributes are no place to look from, and stays where it was', () => {
    const rig = place();
    const { eye } = rig.camera;
    for (const attributes of [
      { theta: Infinity },
      { radius: { world: Infinity } },
      { radius: { fraction: 1e308 } },
      { target: [0, NaN, 0] as Vector3 },
      { fieldOfView: 1e-320 },
    ]) {
      expect(() => rig.setAttributes(attributes), JSON.stringify(attributes)).to.throw(/too large or too small/);
      expect(rig.camera.eye).to.deep.equal(eye);
    }
    rig.setAttributes({ theta: 1e300 });
    const before = rig.camera.eye;
    rotate(rig, 0.1, 0);
    arrive(rig);
    expect(length(subtract(rig.camera.eye, before)), 'it can be turned').to.be.above(1);
  });

  it('turns around something where a viewpoint stands in its own centre, or right above it', () => {
    const camera = {
      eye: [0, 0, 30] as Vector3,
      target: [0, 0, 29] as Vector3,
      up: [0, 1, 0] as Vector3,
      fieldOfView: 0.7,
    };
    for (const centerOfRotation of [
      [0, 0, 30],
      [0, -50, 30],
    ] as Vector3[]) {
      const rig = place();
      rig.setViewpoint((shown) => frameViewpoint(camera, centerOfRotation, shown));
      expect([...rig.camera.eye, ...rig.camera.up].every(Number.isFinite)).to.equal(true);
    }
  });
});
