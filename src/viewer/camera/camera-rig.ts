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

/** What the camera looks at. */
export interface Subject {
  readonly center: Vector3;
  /** Of the sphere that holds the volume, world length. */
  readonly radius: number;
  /** Whether it is the weather over a map: then north is ahead and there is more of the ground to be seen. */
  readonly isWeather?: boolean;
  /** Whether it stands in for a volume that follows, in the same place, and is framed as that one is. */
  readonly isCoarse?: boolean;
  /** Frames what is seen of it, where something is; asked for once. */
  readonly findFraming?: () => Framing | null;
}

/** Where a camera of a direction stands that has all in its picture that is to be seen; null where nothing is. @param target - null where it may be chosen */
export type Framing = (view: FramedView, target: Vector3 | null) => { target: Vector3; radius: number } | null;

/** From the patient's front left, a little from above: three faces of a volume are seen. */
const defaults = { theta: Math.PI / 6, phi: (75 * Math.PI) / 180, fieldOfView: Math.PI / 6 };

/** From the south, and from higher up. */
const weatherDefaults = { ...defaults, theta: Math.PI + Math.PI / 9, phi: (62 * Math.PI) / 180 };

/**
 * Share of the bounding sphere that a radius of 100 % fits into the picture. It depends on nothing but the volume's box, so that
 * an author's per cents hold whatever is seen of it.
 */
const framedShare = 0.68;

/** Closest that anybody gets, in radii of the subject. */
const nearest = 0.02;

/** Farthest that anybody gets, in distances that just show the subject: it is still seen well. */
const farthest = 4;

/** The camera comes to rest where it stays within this part of the picture. */
const atRest = 2e-4;

/** Time in which the camera makes up for 63 % of what it lags behind the hand, ms. */
const lag = 60;

/** Where a camera stands, and what it looks at. */
export interface Pose extends Orbit {
  /** World coordinates. */
  readonly target: Vector3;
  /** Vertical, radians. */
  readonly fieldOfView: number;
}

/**
 * Where the camera is and where it wants to be. The frame in which it turns is the world's (z up), or that of the
 * author's viewpoint, so that turning begins from what the author chose.
 */
export class CameraRig {
  #attributes: CameraAttributes = {};
  #limits = defaultLimits;
  #subject: Subject = { center: [0, 0, 0], radius: 1 };
  /** By what was seen of it when it came: other colours and scans leave the view as it is. Undefined where that is not known. */
  #framing: Framing | null | undefined;
  #aspect = 1;
  #frame: readonly [Vector3, Vector3, Vector3] = worldFrame;
  #goal: Pose = { theta: 0, phi: 0, radius: 1, target: [0, 0, 0], fieldOfView: defaults.fieldOfView };
  #pose: Pose = this.#goal;
  /** Where it was placed. */
  #home: Pose = this.#goal;
  #touched = false;
  #placing = false;
  #lag = lag;
  /** Radians in a millisecond by which the camera goes around by itself. */
  spin = 0;
  /** How far it has gone around by itself, on top of its pose, radians. */
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

  /** Where it wants to be. */
  get goal(): Pose {
    return this.#spun ? { ...this.#goal, theta: this.#goal.theta + this.#spun } : this.#goal;
  }

  /** Where it was placed, and goes back to. */
  get home(): Pose {
    return this.#home;
  }

  /** Whether the camera has not yet arrived. */
  get moving(): boolean {
    return this.#pose !== this.#goal;
  }

  /** Whether a person moved it since it was placed. */
  get touched(): boolean {
    return this.#touched;
  }

  /** Whether it has gone around by itself since it was placed. */
  get spun(): boolean {
    return this.#spun !== 0;
  }

  /** Whether it is on a way that attributes send it. */
  get placing(): boolean {
    return this.#placing && this.moving;
  }

  /**
   * Place the camera by attributes. What a person did with it is given up.
   * @param atOnce - whether it is there at once, and does not glide
   * @throws {VolumeViewError} `attribute/invalid` where that is no place to look from; the camera then stays
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
    throw new VolumeViewError('attribute/invalid', 'camera-orbit, camera-target or field-of-view got a number that is too large or too small.');
  }

  /** Keep within other limits from now on. A camera that nobody moved is where it was placed, as far as they let it. */
  setLimits(limits: CameraLimits): void {
    this.#limits = limits;
    this.#keepSpun();
    if (this.#touched) this.aim(this.goal, true);
    else if (this.#frame === worldFrame) this.resetAtOnce();
  }

  /** Whether it stands at a distance that suits what is seen. */
  get framesItself(): boolean {
    return !this.#attributes.radius;
  }

  /** Another volume is seen from where the author placed the camera; of one in the same place the view stays. */
  setSubject(subject: Subject): void {
    const { center, radius, isCoarse } = this.#subject;
    if (![subject.radius, ...subject.center].every(isFinite)) return;
    const isNear = (a: number, b: number): boolean => Math.abs(a - b) <= 1e-9 * radius; // A coarse volume's bounds are rounded otherwise.
    const isSame = isNear(radius, subject.radius) && center.every((c, axis) => isNear(c, subject.center[axis]));
    const isStillHeld = !isCoarse || subject.isCoarse;
    if (isSame && isStillHeld && (this.#framing !== undefined || !subject.findFraming)) return;
    this.#subject = subject;
    this.#framing = subject.findFraming?.();
    if (!isSame || !this.#touched) this.resetAtOnce();
  }

  /** The picture's width / height. While nobody touched the camera, the subject stays framed. */
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
    const usual = this.#subject.isWeather ? weatherDefaults : defaults;
    this.#frame = worldFrame;
    this.#touched = false;
    const [angle, aspect] = [fieldOfView ?? defaults.fieldOfView, this.#aspect];
    // Turns of a larger angle would be lost in its rounding.
    const orbit = { theta: (theta ?? usual.theta) % (2 * Math.PI), phi: Math.min(Math.PI, Math.max(0, phi ?? usual.phi)) };
    // With a distance of the author's own nothing depends on what is seen.
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

  /** What a person did by hand, and what it did by itself, is where the next way begins. */
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

  /** Nobody is turned around more than half, unless limits lie on that way. */
  #takeShortWay(): void {
    const { min, max } = this.#limits;
    const turns = Math.round((this.#goal.theta - this.#pose.theta) / (2 * Math.PI));
    if (turns && isFinite(turns) && min.theta === undefined && max.theta === undefined) this.#pose = { ...this.#pose, theta: this.#pose.theta + 2 * Math.PI * turns };
  }

  /** @param usual - where nothing is said, in distances that just show the subject */
  #lengthOf(radius: Radius | undefined, fieldOfView: number, usual: number): number {
    if (radius && 'world' in radius) return radius.world;
    return framingDistance(this.#subject.radius * framedShare, fieldOfView, this.#aspect) * (radius?.fraction ?? usual);
  }

  /** A pose within the limits. Angles of a viewpoint are its own, and have none but the poles. */
  within(pose: Pose): Pose {
    const { min, max } = this.#limits;
    const [least, most] = this.#frame === worldFrame ? [min, max] : [{}, {}];
    const { radius } = this.#home;
    const low = min.radius ? this.#lengthOf(min.radius, pose.fieldOfView, 0) : Math.min(nearest * this.#subject.radius, radius);
    const high = max.radius ? this.#lengthOf(max.radius, pose.fieldOfView, 0) : Math.max(this.#lengthOf(undefined, pose.fieldOfView, farthest), radius);
    return {
      ...pose,
      theta: clamp(pose.theta, least.theta ?? -Infinity, most.theta ?? Infinity),
      phi: clamp(pose.phi, Math.max(0, least.phi ?? 0), Math.min(Math.PI, most.phi ?? Math.PI)),
      radius: clamp(pose.radius, low, high),
    };
  }

  /** Be where the author placed the camera. */
  resetAtOnce(): void {
    this.#place();
    this.jump();
  }

  /** Be at once where it wants to be. */
  jump(): void {
    this.#pose = this.#goal;
  }

  /** Turn to a side of the world, the short way, radians. */
  turnTo(theta: number, phi: number): void {
    this.#touched = true;
    this.#frame = worldFrame;
    this.#send();
    const round = 2 * Math.PI;
    const near = theta - round * Math.round((theta - this.#goal.theta) / round);
    const { theta: most } = this.within({ ...this.#goal, theta: near });
    // Limits may leave another turn only.
    const one = near === most ? near : near + Math.sign(most - near) * round;
    this.#goal = this.within({ ...this.#goal, theta: this.within({ ...this.#goal, theta: one }).theta === one ? one : near, phi });
  }

  /** Go to a pose. @param touched - whether a person's hand brought it there */
  aim(goal: Pose, touched: boolean): void {
    if (touched) this.#keepSpun();
    this.#placing = false;
    this.#lag = lag;
    this.#goal = this.within(this.#spun ? { ...goal, theta: goal.theta - this.#spun } : goal);
    this.#touched = touched;
  }

  /** Follow the goal for some milliseconds. */
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
    this.#pose = left >= atRest ? next : to; // Also where nobody can say how far it is.
  }

  /** Between limits it goes to and fro. */
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
