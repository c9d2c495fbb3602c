import { expect } from '@esm-bundle/chai';
import { frameViewpoint } from '../../src/optics/viewpoint-frame.ts';
import { rotate, zoom } from '../../src/viewer/camera-moves.ts';
import { CameraRig } from '../../src/viewer/camera-rig.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { length, normalize, subtract } from '../../src/volume/matrix.ts';

const degrees = Math.PI / 180;
const subject = { center: [10, -20, 30] as Vector3, radius: 100 };

function place(attributes: Parameters<CameraRig['setAttributes']>[0] = {}, changes: Partial<Parameters<CameraRig['setSubject']>[0]> = {}): CameraRig {
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

  it('looks from the patient\'s front left and above, at the weather from the south and higher up', () => {
    const [body, weather] = [{}, { isWeather: true }].map((changes) => {
      const { camera } = place({}, changes);
      return normalize(subtract(camera.eye, camera.target));
    });
    expect(body[2]).to.be.closeTo(Math.cos(75 * degrees), 1e-9);
    expect(weather[2]).to.be.closeTo(Math.cos(62 * degrees), 1e-9);
    expect(weather[1], 'north is ahead').to.be.below(-0.5);
    expect(Math.sign(body[1])).to.equal(-Math.sign(weather[1]));
  });

  it('frames what stood in for a volume anew when that is there; not where a person has turned it', () => {
    const framed = (radius: number): Pick<Parameters<CameraRig['setSubject']>[0], 'findFraming'> => ({ findFraming: () => () => ({ target: subject.center, radius }) });
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

  it('obeys attributes: angles, a radius in world units or in parts of the framing, a target', () => {
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

  it('zooms between a fiftieth of the subject\'s radius and twenty of them', () => {
    const rig = place({ radius: { world: 100 } });
    zoom(rig, 0.5);
    arrive(rig);
    expect(rig.orbit.radius).to.be.closeTo(50, 1e-9);
    zoom(rig, 1e-6);
    arrive(rig);
    expect(rig.orbit.radius).to.be.closeTo(2, 1e-9);
    zoom(rig, 1e9);
    arrive(rig);
    expect(rig.orbit.radius).to.be.closeTo(2000, 1e-9);
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

  it('keeps a person\'s view for a volume in the same place, and gives it up for another one', () => {
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

  it('begins at an author\'s viewpoint, and turns around its centre of rotation, else around what it looks at', () => {
    const camera = { eye: [10, -220, 30] as Vector3, target: [10, -219, 30] as Vector3, up: [0, 0, 1] as Vector3, fieldOfView: 0.7 };
    for (const [centerOfRotation, target] of [[[10, -100, 30], [10, -100, 30]], [null, subject.center]] as [Vector3 | null, Vector3][]) {
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

  it('comes to rest whatever it is told, and looks from somewhere', () => {
    const rig = place();
    for (const [theta, phi] of [[NaN, 0], [0, Infinity], [1e308, -1e308], [0.1, 0.1]]) rotate(rig, theta, phi);
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

  it('tells that attributes are no place to look from, and stays where it was', () => {
    const rig = place();
    const { eye } = rig.camera;
    for (const attributes of [{ theta: Infinity }, { radius: { world: Infinity } }, { radius: { fraction: 1e308 } }, { target: [0, NaN, 0] as Vector3 }, { fieldOfView: 1e-320 }]) {
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
    const camera = { eye: [0, 0, 30] as Vector3, target: [0, 0, 29] as Vector3, up: [0, 1, 0] as Vector3, fieldOfView: 0.7 };
    for (const centerOfRotation of [[0, 0, 30], [0, -50, 30]] as Vector3[]) {
      const rig = place();
      rig.setViewpoint((shown) => frameViewpoint(camera, centerOfRotation, shown));
      expect([...rig.camera.eye, ...rig.camera.up].every(Number.isFinite)).to.equal(true);
    }
  });
});
