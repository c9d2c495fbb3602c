import { socketOf } from '../../src/viewer/model/view-socket.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { box, flag, number, numberOrAuto, numberOrFlag, numberOrText, text, vector } from './property-kinds.ts';
import { property, writeSafely } from './reflecting-element.ts';
import { ViewAttributes } from './view-attributes.ts';

/** The attributes for quality, camera, visible part and interaction. */
export class PictureAttributes extends ViewAttributes {
  /**
   * Number of steps along the longest ray. A step takes one sample, or several where something may be visible. `auto`, the default, keeps
   * `target-fps` while something moves and `max-error` at rest.
   * @default auto
   */
  @property({ kind: numberOrAuto }) steps!: number | 'auto' | null;

  /**
   * With `steps="auto"`: the error that a picture at rest may have, in 1/255; 1 by default. The RMS error is at most this, and at most one
   * pixel in a thousand differs by more than 8 times as much.
   * @default 1
   */
  @property({ attribute: 'max-error', kind: number }) maxError!: number | null;

  /**
   * With `steps="auto"`: whether a picture at rest keeps small things. `keep`, the default, takes a sample in each voxel of each ray, and a
   * ray for each pixel. `free` leaves out what `max-error` does not need: less work, but single voxels and thin lines may be missing.
   * @default keep
   */
  @property() detail!: 'keep' | 'free' | null;

  /**
   * With `steps="auto"`: frames per second while something moves; steps and pixels are chosen so that the device reaches this rate; 30 by
   * default.
   * @default 30
   */
  @property({ attribute: 'target-fps', kind: number }) targetFps!: number | null;

  /**
   * The only part that is shown, and that the camera frames: two opposite corners of a box, `x0 y0 z0 x1 y1 z1`, in world units; for a
   * radar scan in metres east, north and above the antenna, before the exaggeration of heights.
   */
  @property({ kind: box }) region!:
    | readonly [x0: number, y0: number, z0: number, x1: number, y1: number, z1: number]
    | null;

  /** A box that is cut out, written as `region`. What lies behind it becomes visible. */
  @property({ kind: box }) cutout!:
    | readonly [x0: number, y0: number, z0: number, x1: number, y1: number, z1: number]
    | null;

  /**
   * Rings around a radar at the height of its antenna, and a line to the north. The value is the distance between rings in kilometres; an
   * empty value chooses a round distance that suits the range of the radar, or the `region`, which clips the rings. By default a radar has
   * such rings and lines between them, as its ground; with `none` it has neither.
   */
  @property({ kind: numberOrFlag }) rings!: boolean | number | 'none';

  /**
   * Position of the camera, `theta phi radius`, for instance `30deg 70deg 110%`; each part may be `auto`. Setting it moves the camera
   * there, wherever a person has moved it; reading it returns the present position.
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
   * The point that the camera looks at, world coordinates `x y z`; by default the centre of the volume. Set and read like `cameraOrbit`.
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
   * Lower limits for the camera, written as `camera-orbit`; parts may be `auto` and `Infinity`. By default phi is from 0deg to 180deg,
   * theta has no limit, and a person can bring the camera no nearer than about a hundredth of the distance that shows the whole volume.
   * @default auto auto auto
   */
  @property({ attribute: 'min-camera-orbit' }) minCameraOrbit!: string | null;

  /**
   * Upper limits for the camera, written as `min-camera-orbit`. By default a person can bring the camera no farther than four times the
   * distance that shows the whole volume, or than the distance in `camera-orbit`.
   * @default auto auto auto
   */
  @property({ attribute: 'max-camera-orbit' }) maxCameraOrbit!: string | null;

  /**
   * How slowly the camera moves to where an attribute, a button or a key sends it: after this number of milliseconds it has gone 63 % of
   * the way. With 0 it jumps there at once, as it does under `prefers-reduced-motion` and before the first picture.
   * @default 120
   */
  @property({ attribute: 'interpolation-decay', kind: number }) interpolationDecay!: number | null;

  /**
   * The camera moves around the volume by itself while nobody moves it and the element is in sight; not under `prefers-reduced-motion`. A
   * button in the picture stops and restarts it.
   */
  @property({ attribute: 'auto-rotate', kind: flag }) autoRotate!: boolean;

  /**
   * Milliseconds until `auto-rotate` begins, counted from the first picture and from the last movement by a person.
   * @default 3000
   */
  @property({ attribute: 'auto-rotate-delay', kind: number }) autoRotateDelay!: number | null;

  /**
   * Speed of `auto-rotate`: an angle per second, `10deg` or `0.2rad`, or a percentage of the usual speed, which is one turn in 64 seconds;
   * negative values turn the other way.
   * @default 100%
   */
  @property({ attribute: 'rotation-per-second' }) rotationPerSecond!: string | null;

  /**
   * Shows the orientation of the picture in one of its corners: the letters R, L, A, P, S, I for the sides of a patient, or N, E, S, W for
   * a radar. Each letter is a button that turns the view to that side. Nothing is shown where the file does not say which sides its axes
   * point to.
   */
  @property({ attribute: 'orientation-marker', kind: flag }) orientationMarker!: boolean;

  /**
   * What mouse, fingers and keys move: the camera, or, with `none`, nothing.
   * @default auto
   */
  @property() interaction!: string | null;

  /**
   * Shows buttons over the picture, as on a video: standard views, zoom, the first view, full screen, save, copy the view or the code of an
   * iframe, help.
   */
  @property({ kind: flag }) controls!: boolean;

  /**
   * Which of the `controls` are left out, separated by blanks: `noplay`, `norotate`, `noviews`, `nozoom`, `noreset`, `nofullscreen`,
   * `nosave`, `nocopy`, `nolink`, `noembed`, `nohelp`, `nohint`.
   */
  @property() controlslist!: string | null;

  /**
   * The view opens what a link to it says: an address that ends with `#`, the `id` of the view, `?` and attributes, as `getLink()` and
   * "Copy a link" of the `controls` write it. A link can change where the view is seen from and how it looks, never its data.
   */
  @property({ attribute: 'link-state', kind: flag }) linkState!: boolean;

  /**
   * A click or a tap on the picture fires `volume-pick`, with the value at that place. A `<volume-readout>` or a `<volume-slice-view>` for
   * the element has the same effect.
   */
  @property({ kind: flag }) pickable!: boolean;

  /**
   * For the author of a page, while it is written: a click, a tap or the crosshair of keys chooses a place, and a panel over the picture has
   * the tag of a `<volume-note>` there, to copy into the page.
   */
  @property({ kind: flag }) authoring!: boolean;

  /**
   * Checks each picture at rest: some of its rays are computed on the CPU too, in 64 bits. If the GPU draws something different, an `error`
   * with the code `webgl/inaccurate` is fired; `picture-check` fires in any case.
   */
  @property({ attribute: 'self-check', kind: flag }) selfCheck!: boolean;

  /**
   * Position of the crosshair in the `<volume-slice-view>`s of this view, `x y z` in world units. Setting it moves the crosshair; reading
   * it returns the present position. Without such panes it has no effect.
   */
  @property({ kind: vector })
  get cursor(): Vector3 | null {
    return socketOf(this).last('cursor') ?? vector.read(this.readText('cursor'));
  }

  set cursor(value: Vector3 | null) {
    this.writeText('cursor', writeSafely(vector.write, value));
  }

  /**
   * Whether the picture shows the crosshair of the panes of this view too: `auto`, or `none`.
   * @default auto
   */
  @property() crosshair!: 'auto' | 'none' | null;

  /** Width of the element where CSS sets none: pixels, or a percentage. Together with `height` it sets the aspect ratio. */
  @property({ kind: numberOrText }) width!: number | string | null;

  /** Height of the element where CSS sets none, written as `width`. */
  @property({ kind: numberOrText }) height!: number | string | null;

  /** A description of the picture, for people who do not see it. */
  @property() alt!: string | null;

  /** URL of an image that is shown until the first picture. */
  @property() poster!: string | null;

  /**
   * `lazy`, the default, starts to load when the element comes near the visible part of the page, or when a script requests its picture;
   * `eager` loads at once.
   * @default lazy
   */
  @property() loading!: string | null;
}
