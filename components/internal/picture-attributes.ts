import { socketOf } from '../../src/viewer/model/view-socket.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { box, flag, number, numberOrAuto, numberOrFlag, numberOrText, text, vector } from './property-kinds.ts';
import { property, writeSafely } from './reflecting-element.ts';
import { ViewAttributes } from './view-attributes.ts';

/** How well and from where an author wants the volume shown, what of it, and what a person can do. */
export class PictureAttributes extends ViewAttributes {
  /**
   * Steps along the longest ray, each of one sample or, where something may be seen, several. `auto`, the default, keeps
   * `target-fps` while something moves and `max-error` at rest.
   * @default auto
   */
  @property({ kind: numberOrAuto }) steps!: number | 'auto' | null;

  /**
   * With `steps="auto"`: the error that a picture at rest may have, in 1/255; 1 by default. Its RMS is no more, and one pixel in a thousand at most differs by more than 8 times as much.
   * @default 1
   */
  @property({ attribute: 'max-error', kind: number }) maxError!: number | null;

  /**
   * With `steps="auto"`: frames a second while something moves, in steps and pixels that the device manages; 30 by default.
   * @default 30
   */
  @property({ attribute: 'target-fps', kind: number }) targetFps!: number | null;

  /**
   * The part that alone is shown, and that the camera frames: two opposite corners of a box, `x0 y0 z0 x1 y1 z1`, in world
   * units; of a radar scan in metres east, north and above the antenna, whatever the exaggeration of heights.
   */
  @property({ kind: box }) region!: readonly [x0: number, y0: number, z0: number, x1: number, y1: number, z1: number] | null;

  /** A box that is cut out, written as `region`. What lies behind it is seen. */
  @property({ kind: box }) cutout!: readonly [x0: number, y0: number, z0: number, x1: number, y1: number, z1: number] | null;

  /**
   * Rings around a radar at the height of its antenna, and a line to the north: kilometres from ring to ring; empty for
   * round ones that suit its reach, or the `region`, which cuts them. By default a radar has round ones and lines between them,
   * as its ground; with `none` it has neither.
   */
  @property({ kind: numberOrFlag }) rings!: boolean | number | 'none';

  /**
   * Where the camera stands, `theta phi radius`, for instance `30deg 70deg 110%`; each part may be `auto`. To set it brings the
   * camera there, wherever a person moved it; to read it tells where the camera is.
   * @default auto auto auto
   */
  @property({ attribute: 'camera-orbit' })
  get cameraOrbit(): string | null {
    return this.readSeen('camera-orbit');
  }

  set cameraOrbit(value: string | null) {
    this.writeText('camera-orbit', writeSafely(text.write, value));
  }

  /**
   * What the camera looks at, world coordinates `x y z`; by default the volume's centre. Set and read as `cameraOrbit`.
   * @default auto
   */
  @property({ attribute: 'camera-target', kind: vector })
  get cameraTarget(): Vector3 | null {
    return vector.read(this.readSeen('camera-target'));
  }

  set cameraTarget(value: Vector3 | null) {
    this.writeText('camera-target', writeSafely(vector.write, value));
  }

  /**
   * Vertical angle of view; 30deg by default.
   * @default 30deg
   */
  @property({ attribute: 'field-of-view' }) fieldOfView!: string | null;

  /**
   * Limits that the camera does not go below, written as `camera-orbit`; parts may be `auto` and `Infinity`. By default phi is from
   * 0deg to 180deg, theta has no limit, and a hand brings the camera no nearer than a hundredth of the distance that shows the whole volume, about.
   * @default auto auto auto
   */
  @property({ attribute: 'min-camera-orbit' }) minCameraOrbit!: string | null;

  /**
   * Limits that the camera does not go above, as `min-camera-orbit`. By default a hand brings the camera no farther than four times the distance that
   * shows the whole volume, or than where `camera-orbit` places it.
   * @default auto auto auto
   */
  @property({ attribute: 'max-camera-orbit' }) maxCameraOrbit!: string | null;

  /**
   * How slowly the camera goes where an attribute, a button or a key sends it: after so many milliseconds 63 % of the way are done.
   * With 0 it is there at once, as it is under `prefers-reduced-motion` and before the first picture.
   * @default 120
   */
  @property({ attribute: 'interpolation-decay', kind: number }) interpolationDecay!: number | null;

  /**
   * The camera goes around the volume by itself while nobody moves it and the element is in sight; not under `prefers-reduced-motion`. A button in
   * the picture stops it and lets it go on.
   */
  @property({ attribute: 'auto-rotate', kind: flag }) autoRotate!: boolean;

  /**
   * Milliseconds from the first picture, and from the last movement by a hand, until `auto-rotate` begins.
   * @default 3000
   */
  @property({ attribute: 'auto-rotate-delay', kind: number }) autoRotateDelay!: number | null;

  /**
   * How fast `auto-rotate` goes: an angle in a second, `10deg` or `0.2rad`, or a percentage of the usual speed, which is a turn in 64 seconds; negative the other way around.
   * @default 100%
   */
  @property({ attribute: 'rotation-per-second' }) rotationPerSecond!: string | null;

  /**
   * Shows in a corner of the picture which way it is turned: the letters R, L, A, P, S, I of a patient's sides, or N, E, S, W of a radar's. Each is a button that turns to that
   * side. Nothing shows where the file does not say whose sides its axes are.
   */
  @property({ attribute: 'orientation-marker', kind: flag }) orientationMarker!: boolean;

  /**
   * What mouse, fingers and keys move: the camera, or, with `none`, nothing.
   * @default auto
   */
  @property() interaction!: string | null;

  /** Shows buttons over the picture, as a video has them: standard views, zoom, the first view, full screen, save, copy the view or the code of a frame, help. */
  @property({ kind: flag }) controls!: boolean;

  /**
   * Which of the `controls` are left out, separated by blanks: `noplay`, `norotate`, `noviews`, `nozoom`, `noreset`, `nofullscreen`, `nosave`, `nocopy`, `noembed`, `nohelp`, `nohint`.
   */
  @property() controlslist!: string | null;

  /** A click or a tap on the picture fires `volume-pick`: what is there. A `<volume-readout>` or a `<volume-slice-view>` for the element has the same effect. */
  @property({ kind: flag }) pickable!: boolean;

  /**
   * Each picture at rest is checked: some of its rays are cast on the processor too, in 64 bits. Where the graphics processor draws otherwise,
   * that is an `error` with the code `webgl/inaccurate`; `picture-check` fires in any case.
   */
  @property({ attribute: 'self-check', kind: flag }) selfCheck!: boolean;

  /**
   * Where the crosshair of the `<volume-slice-view>`s of this view is, `x y z` in world units. To set it brings them there; to
   * read it tells where they are. Without such panes it has no effect.
   */
  @property({ kind: vector })
  get cursor(): Vector3 | null {
    return socketOf(this).last('cursor') ?? vector.read(this.readText('cursor'));
  }

  set cursor(value: Vector3 | null) {
    this.writeText('cursor', writeSafely(vector.write, value));
  }

  /**
   * Whether the crosshair of the panes of this view stands in the picture too: `auto`, or `none`.
   * @default auto
   */
  @property() crosshair!: 'auto' | 'none' | null;

  /** Width of the element where CSS says none: pixels, or a percentage. With `height` its ratio holds. */
  @property({ kind: numberOrText }) width!: number | string | null;

  /** Height of the element where CSS says none, as `width`. */
  @property({ kind: numberOrText }) height!: number | string | null;

  /** What the picture shows, for those who do not see it. */
  @property() alt!: string | null;

  /** URL of an image that stands there until the first picture. */
  @property() poster!: string | null;

  /**
   * `lazy`, the default, waits with loading until the element comes near the visible part of the page, or a script asks for
   * its picture; `eager` loads at once.
   * @default lazy
   */
  @property() loading!: string | null;
}
