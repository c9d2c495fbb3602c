import { VolumeViewError } from '../../core/errors.ts';
import { framingDistance, orbitCamera } from '../../optics/rays/camera.ts';
import type { Camera, Orbit } from '../../optics/rays/camera.ts';
import type { FramedView } from '../../optics/rays/frame-places.ts';
import type { ViewpointFrame } from '../../optics/rays/viewpoint-frame.ts';
import { add, length, scale, subtract } from '../../volume/matrix.ts';
import type { Vector3 } from '../../volume/matrix.ts';
import { defaultLimits } from '../model/camera-attributes.ts';
import type { CameraAttributes, CameraLimits } from '../model/camera-attributes.ts';
import type { Radius } from '../model/parse-attributes.ts';

/** The object that the camera looks at. */
export interface Subject {
  readonly center: Vector3;
  /** Radius of the sphere that contains the volume, world length. */
  readonly radius: number;
  /** Whether it is weather over a map: then north is ahead, and the picture shows more of the ground. */
  readonly isWeather?: boolean;
  /** Whether it is shown in place of a volume that is still loading, which has the same place and the same framing. */
  readonly isCoarse?: boolean;
  /** Frames the visible part of the volume, where there is one; called once. */
  readonly findFraming?: () => Framing | null;
}

/**
 * The position of a camera with a given direction that has all visible parts in its picture; null where nothing is visible.
 * @param target - null where the function may choose it
 */
export interface Framing {
  (view: FramedView, target: Vector3 | null): { target: Vector3; radius: number } | null;
  /** The direction, where the usual one does not suit the subject. */
  readonly usual?: Pick<Orbit, 'theta' | 'phi'>;
}

const degree = Math.PI / 180;

/** From the patient's front left, a little from above: three faces of a volume are visible. */
const defaults = { theta: 30 * degree, phi: 75 * degree, fieldOfView: 30 * degree };

/** From the south, and from higher up. */
const weatherDefaults = { theta: 200 * degree, phi: 62 * degree };

/**
 * Share of the bounding sphere that a radius of 100 % fits into the picture. It depends only on the volume's box, so that an
 * author's percentages do not change with the visible part.
 */
const framedShare = 0.68;

/** The smallest distance, in radii of the subject. */
const nearest = 0.02;

/** The largest distance, as a multiple of the distance that just shows the subject: at this distance it is still clearly visible. */
const farthest = 4;

/** The camera stops when it is nearer to its goal than this share of the picture. */
const atRest = 2e-4;

/** Time in which the camera covers 63 % of its distance from the pointer, ms. */
const lag = 60;

/** The position of a camera, and its target. */
export interface Pose extends Orbit {
  /** World coordinates. */
  readonly target: Vector3;
  /** Vertical, radians. */
  readonly fieldOfView: number;
}

/**
 * Where the camera is and where it is going. It turns in the frame of the world (z up), or in that of the author's viewpoint, so
 * that turning starts from the author's choice.
 */
export class CameraRig {
  #attributes: CameraAttributes = {};
  #limits = defaultLimits;
  #subject: Subject = { center: [0, 0, 0], radius: 1 };
  /**
   * Computed from the visible part when the subject came: other colours and scans do not change the view. Undefined where the
   * visible part is not known.
   */
  #framing: Framing | null | undefined;
  #aspect = 1;
  #frame: readonly [Vector3, Vector3, Vector3] = worldFrame;
  #goal: Pose = { theta: 0, phi: 0, radius: 1, target: [0, 0, 0], fieldOfView: defaults.fieldOfView };
  #pose: Pose = this.#goal;
  /** The pose where it was placed. */
  #home: Pose = this.#goal;
  #touched = false;
  #placing = false;
  #lag = lag;
  /** Speed of automatic rotation, radians a millisecond. */
  spin = 0;
  /** The angle of the automatic rotation so far, in addition to its pose, radians. */
  #spun = 0;

  /** The camera at this moment. */
  get camera(): Camera {
    return this.cameraAt({ ...this.#pose, ...this.orbit });
  }

  /** The camera of a pose. */
  cameraAt({ target, fieldOfView: angle, ...orbit }: Pose): Camera {
    const { eye, up, fieldOfView } = orbitCamera(orbit, [0, 0, 0], angle);
    const place = (v: Vector3): Vector3 =>
      add(scale(this.#frame[0], v[0]), add(scale(this.#frame[1], v[1]), scale(this.#frame[2], v[2])));
    return { eye: add(target, place(eye)), target, up: place(up), fieldOfView };
  }

  get orbit(): Orbit {
    const { theta, phi, radius } = this.#pose;
    return { theta: theta + this.#spun, phi, radius };
  }

  get subject(): Subject {
    return this.#subject;
  }

  /** The pose to which the camera is going. */
  get goal(): Pose {
    return this.#spun ? { ...this.#goal, theta: this.#goal.theta + this.#spun } : this.#goal;
  }

  /** The pose where it was placed, to which it can return. */
  get home(): Pose {
    return this.#home;
  }

  /** Whether the camera is still on its way. */
  get moving(): boolean {
    return this.#pose !== this.#goal;
  }

  /** Whether a person moved it since it was placed. */
  get touched(): boolean {
    return this.#touched;
  }

  /** Whether it has rotated automatically since it was placed. */
  get spun(): boolean {
    return this.#spun !== 0;
  }

  /** Whether it is moving to where attributes place it. */
  get placing(): boolean {
    return this.#placing && this.moving;
  }

  /**
   * Place the camera by attributes. Earlier movements by a person are dropped.
   * @param atOnce - whether it moves there at once, not smoothly
   * @throws {VolumeViewError} `attribute/invalid` where the place is not possible; the camera then stays
   */
  setAttributes(attributes: CameraAttributes, atOnce = true): void {
    const before = this.#attributes;
    this.#attributes = attributes;
    this.reset();
    this.#placing = true;
    if (atOnce) this.jump();
    if (this.cameraAt(this.#goal).eye.every(isFinite)) return;
    this.#attributes = before;
    this.resetAtOnce();
    throw new VolumeViewError(
      'attribute/invalid',
      'camera-orbit, camera-target or field-of-view got a number that is too large or too small.',
    );
  }

  /** Apply other limits from now on. A camera that nobody moved goes to where it was placed, as far as the limits allow. */
  setLimits(limits: CameraLimits): void {
    this.#limits = limits;
    this.#keepSpun();
    if (this.#touched) this.aim(this.goal, true);
    else if (this.#frame === worldFrame) this.resetAtOnce();
  }

  /** Whether it chooses a distance that suits the visible part. */
  get framesItself(): boolean {
    return !this.#attributes.radius;
  }

  /** A new volume is seen from where the author placed the camera; if it is in the same place as the old one, the view stays. */
  setSubject(subject: Subject): void {
    const { center, radius, isCoarse } = this.#subject;
    if (![subject.radius, ...subject.center].every(isFinite)) return;
    const isNear = (a: number, b: number): boolean => Math.abs(a - b) <= 1e-9 * radius; // The bounds of a coarse volume are rounded differently.
    const isSame = isNear(radius, subject.radius) && center.every((c, axis) => isNear(c, subject.center[axis]));
    const isStillHeld = !isCoarse || subject.isCoarse;
    if (isSame && isStillHeld && (this.#framing !== undefined || !subject.findFraming)) return;
    this.#subject = subject;
    this.#framing = subject.findFraming?.();
    if (!isSame || !this.#touched) this.resetAtOnce();
  }

  /** Set the picture's width / height. While nobody has moved the camera, the subject stays framed. */
  setAspect(aspect: number): void {
    if (aspect === this.#aspect) return;
    this.#aspect = aspect;
    if (!this.#touched && this.#frame === worldFrame) this.resetAtOnce();
  }

  /** Turn around the author's viewpoint instead of the attributes' orbit. */
  setViewpoint(around: (subject: Subject) => ViewpointFrame): void {
    const { frame, target, fieldOfView, radius } = around(this.#subject);
    this.#frame = frame;
    this.#goal = { theta: 0, phi: Math.PI / 2, radius, target, fieldOfView };
    this.#home = this.#goal;
    this.jump();
    this.#spun = 0;
    this.#touched = false;
  }

  /** Go back to where the author placed the camera. */
  reset(): void {
    this.#send();
    this.#place();
  }

  #place(): void {
    const { theta, phi, radius, target, fieldOfView } = this.#attributes;
    const usual = this.#framing?.usual ?? (this.#subject.isWeather ? weatherDefaults : defaults);
    this.#frame = worldFrame;
    this.#touched = false;
    const [angle, aspect] = [fieldOfView ?? defaults.fieldOfView, this.#aspect];
    // Rounding would lose the turns of a larger angle.
    const orbit = {
      theta: (theta ?? usual.theta) % (2 * Math.PI),
      phi: Math.min(Math.PI, Math.max(0, phi ?? usual.phi)),
    };
    // If the author gives a distance, the view does not depend on the visible part.
    const framed = radius ? null : this.#framing?.({ ...orbit, fieldOfView: angle, aspect }, target ?? null);
    this.#home = {
      ...orbit,
      radius: framed ? Math.max(framed.radius, nearest * this.#subject.radius) : this.#lengthOf(radius, angle, 1),
      target: framed?.target ?? target ?? this.#subject.center,
      fieldOfView: angle,
    };
    this.#goal = this.#home = this.within(this.#home);
    this.#takeShortWay();
  }

  /** The next movement starts from what a person did, and from the automatic rotation so far. */
  #send(): void {
    this.#placing = false;
    this.#lag = this.#limits.decay;
    this.#keepSpun();
  }

  #keepSpun(): void {
    if (!this.#spun) return;
    const by = this.#spun;
    this.#spun = 0;
    const isThere = !this.moving;
    this.#goal = { ...this.#goal, theta: this.#goal.theta + by };
    this.#pose = isThere ? this.#goal : { ...this.#pose, theta: this.#pose.theta + by };
  }

  /** Never turn the camera by more than half a turn, unless limits are in the way. */
  #takeShortWay(): void {
    const { min, max } = this.#limits;
    const turns = Math.round((this.#goal.theta - this.#pose.theta) / (2 * Math.PI));
    if (turns && isFinite(turns) && min.theta === undefined && max.theta === undefined)
      this.#pose = { ...this.#pose, theta: this.#pose.theta + 2 * Math.PI * turns };
  }

  /** @param usual - used where there is no radius, as a multiple of the distance that just shows the subject */
  #lengthOf(radius: Radius | undefined, fieldOfView: number, usual: number): number {
    if (radius && 'world' in radius) return radius.world;
    return framingDistance(this.#subject.radius * framedShare, fieldOfView, this.#aspect) * (radius?.fraction ?? usual);
  }

  /** A pose within the limits. Angles around an author's viewpoint are not limited, except by the poles. */
  within(pose: Pose): Pose {
    const { min, max } = this.#limits;
    const [minOrbit, maxOrbit] = this.#frame === worldFrame ? [min, max] : [{}, {}];
    const { radius } = this.#home;
    const low = min.radius
      ? this.#lengthOf(min.radius, pose.fieldOfView, 0)
      : Math.min(nearest * this.#subject.radius, radius);
    const high = max.radius
      ? this.#lengthOf(max.radius, pose.fieldOfView, 0)
      : Math.max(this.#lengthOf(undefined, pose.fieldOfView, farthest), radius);
    return {
      ...pose,
      theta: clamp(pose.theta, minOrbit.theta ?? -Infinity, maxOrbit.theta ?? Infinity),
      phi: clamp(pose.phi, Math.max(0, minOrbit.phi ?? 0), Math.min(Math.PI, maxOrbit.phi ?? Math.PI)),
      radius: clamp(pose.radius, low, high),
    };
  }

  /** Move at once to where the author placed the camera. */
  resetAtOnce(): void {
    this.#place();
    this.jump();
  }

  /** Move at once to the goal. */
  jump(): void {
    this.#pose = this.#goal;
  }

  /** Turn to a side of the world, by the shorter way, radians. */
  turnTo(theta: number, phi: number): void {
    this.#touched = true;
    this.#frame = worldFrame;
    this.#send();
    const round = 2 * Math.PI;
    const near = theta - round * Math.round((theta - this.#goal.theta) / round);
    const { theta: maxOrbit } = this.within({ ...this.#goal, theta: near });
    // The limits may allow only another turn.
    const one = near === maxOrbit ? near : near + Math.sign(maxOrbit - near) * round;
    this.#goal = this.within({
      ...this.#goal,
      theta: this.within({ ...this.#goal, theta: one }).theta === one ? one : near,
      phi,
    });
  }

  /** Go to a pose. @param touched - whether a person moved the camera there */
  aim(goal: Pose, touched: boolean): void {
    if (touched) this.#keepSpun();
    this.#placing = false;
    this.#lag = lag;
    this.#goal = this.within(this.#spun ? { ...goal, theta: goal.theta - this.#spun } : goal);
    this.#touched = touched;
  }

  /** Follow the goal for this time, in milliseconds. */
  advance(ms: number, immediately: boolean): void {
    if (this.spin) this.#goAround(ms);
    if (!this.moving) return;
    const share = immediately ? 1 : 1 - Math.exp(-ms / this.#lag);
    const [from, to] = [this.#pose, this.#goal];
    const next: Pose = {
      theta: approach(from.theta, to.theta, share),
      phi: approach(from.phi, to.phi, share),
      radius: approach(from.radius, to.radius, share),
      target: add(scale(from.target, 1 - share), scale(to.target, share)),
      fieldOfView: approach(from.fieldOfView, to.fieldOfView, share),
    };
    const left =
      Math.abs(next.theta - to.theta) +
      Math.abs(next.phi - to.phi) +
      Math.abs(next.radius / to.radius - 1) +
      length(subtract(next.target, to.target)) / to.radius +
      Math.abs(next.fieldOfView / to.fieldOfView - 1);
    this.#pose = left >= atRest ? next : to; // Also where the distance is not a number.
  }

  /** Rotate automatically; between limits the camera goes back and forth. */
  #goAround(ms: number): void {
    const next = this.#spun + this.spin * ms;
    const theta = this.#pose.theta + next;
    if (this.within({ ...this.#pose, theta }).theta === theta) this.#spun = next;
    else this.spin = -this.spin;
  }
}

const worldFrame: readonly [Vector3, Vector3, Vector3] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

function clamp(value: number, low: number, high: number): number {
  return Math.min(high, Math.max(low, value));
}

function approach(from: number, to: number, share: number): number {
  return from + (to - from) * share;
}
