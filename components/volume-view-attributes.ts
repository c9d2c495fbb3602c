import type { Appearance } from '../src/editor/transfer-function-session.ts';
import type { Stop } from '../src/optics/transfer-function.ts';
import type { Vector3 } from '../src/volume/matrix.ts';
import { oldAttributes, readAttribute, removeOldAttributes, renameAttribute } from './deprecated.ts';
import { noticeRoot } from './notice-root.ts';
import { box, flag, number, numberOrAuto, numberOrFlag, numberOrText, numbers, pair, size, text, transferFunction, vector } from './property-kinds.ts';
import { property, ReflectingElement, writeSafely } from './reflecting-element.ts';

/** The names of the properties that attributes hold. */
type PropertyName = Exclude<keyof VolumeViewAttributes, keyof ReflectingElement | 'appearance' | '_crosshair'>;

/** What an author writes on `<volume-view>`. A property is null where its attribute is absent or can't be read. */
export class VolumeViewAttributes extends ReflectingElement {
  static override get observedAttributes(): string[] {
    return [...super.observedAttributes, ...oldAttributes];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    noticeRoot(this);
  }

  override attributeChangedCallback(name: string, old: string | null, value: string | null): void {
    super.attributeChangedCallback(renameAttribute(name), old, value);
  }

  protected override readText(attribute: string): string | null {
    return readAttribute(this, attribute);
  }

  /** The text that tells what is seen, where a person may have changed that: by default what the author says. */
  protected readSeen(attribute: 'camera-orbit' | 'camera-target'): string | null {
    return this.readText(attribute);
  }

  protected override writeText(attribute: string, text: string | null): void {
    super.writeText(attribute, text);
    removeOldAttributes(this, attribute);
  }

  /** The attributes as they stand, by property, and null where absent. They are read where they are used, which tells what is wrong with them. */
  protected get given(): { readonly [Name in PropertyName]: string | null } {
    const { elementProperties } = this.constructor as typeof VolumeViewAttributes;
    const texts: Record<PropertyKey, string | null> = {};
    for (const [name, { attribute }] of elementProperties) {
      if (typeof attribute === 'string') texts[name] = this.readText(attribute);
    }
    return texts as { [Name in PropertyName]: string | null };
  }

  /** What an editor of the transfer function changes, all at once: three of the attributes. */
  get appearance(): Appearance {
    const { transferFunction, opacityFactor, lightFactor } = this;
    return { transferFunction, opacityFactor, lightFactor };
  }

  set appearance(appearance: Appearance) {
    let given = { ...this.appearance, transferFunction: '?' };
    try {
      given = { ...(appearance as typeof given) };
    } catch {} // It can't be read, and the element says so.
    const { transferFunction, opacityFactor, lightFactor } = given;
    // What is the same stays as the page wrote it.
    if (transferFunction !== this.transferFunction) this.transferFunction = transferFunction;
    if (opacityFactor !== this.opacityFactor) this.opacityFactor = opacityFactor;
    if (lightFactor !== this.lightFactor) this.lightFactor = lightFactor;
  }

  /**
   * URL of the data: a NIfTI, NRRD or MetaImage file, a mosaic image, a radar scan (ODIM_H5, CfRadial, NEXRAD Level II) or a JSON manifest.
   * Several URLs, separated by blanks, are scans in the order of time; a blank within a URL is written `%20`.
   */
  @property() src!: string | null;

  /** The files of `src` are one volume: images, a slice each, or a header and the files of its data; else they are scans in time. */
  @property({ kind: flag }) stack!: boolean;

  /** Tiles per row and column of a mosaic image, `COLUMNSxROWS`, row by row from the top left. */
  @property({ kind: size }) mosaic!: readonly [columns: number, rows: number] | null;

  /** Tiles of the mosaic that hold slices; all of them by default. */
  @property({ kind: number }) slices!: number | null;

  /**
   * World units per voxel, of a mosaic per pixel and slice: `x y z`. By default the file's own, or 1 1 1. A negative one
   * turns its axis round, for slices that run from head to feet, say.
   */
  @property({ kind: vector }) spacing!: Vector3 | null;

  /**
   * The grid that the data of a mosaic lie on: `cartesian`, or `spherical` for a radar's sweeps, one a tile.
   * @default cartesian
   */
  @property() coordinates!: string | null;

  /** Elevations of a radar's mosaic, degrees, one a tile: `0.5 1.2 2.4`. */
  @property({ kind: numbers }) elevations!: readonly number[] | null;

  /** Of a radar's mosaic: metres to the middle of the first gate, and from gate to gate. */
  @property({ kind: pair }) range!: readonly [first: number, step: number] | null;

  /** Of a radar's mosaic: middle of the first radial and step to the next, degrees clockwise from north; all around by default. */
  @property({ kind: pair }) azimuth!: readonly [first: number, step: number] | null;

  /** The quantity of a radar scan, as its file names it: `DBZH`, `VRAD` ... By default its reflectivity. */
  @property() moment!: string | null;

  /**
   * How a radar's beams run: `standard`, bent by the atmosphere over a round Earth (4/3 of its radius), or `straight`
   * over a flat one.
   * @default standard
   */
  @property({ attribute: 'beam-model' }) beamModel!: string | null;

  /** Heights of a radar scan are shown so many times as large; 5 by default, 1 where it reaches less than 50 km. */
  @property({ attribute: 'vertical-exaggeration', kind: number }) verticalExaggeration!: number | null;

  /**
   * Which of several scans is shown: a zero-based index, or a time in UTC, `2018-12-20T06:06:28Z`, for the latest scan at or
   * before it (the first one if all are later). By default the first. To set it shows that scan,
   * whichever `next`, `previous`, `play` or a person went to since; `scan` tells which one is shown.
   * @default 0
   */
  @property({ kind: numberOrText }) time!: number | string | null;

  /** Shows one of several scans after the other as soon as a source is open, without `play()`; begins again after the last. */
  @property({ kind: flag }) autoplay!: boolean;

  /**
   * Scans a second, while they play, or as many as can be loaded and drawn; 2 by default.
   * @default 2
   */
  @property({ attribute: 'play-speed', kind: number }) playSpeed!: number | null;

  /** A preset's name, or stops `value colour opacity, ...`; by default one that suits the data's histogram. */
  @property({ attribute: 'transfer-function' })
  get transferFunction(): string | null {
    return this.readText('transfer-function');
  }

  set transferFunction(value: string | readonly Stop[] | null) {
    this.writeText('transfer-function', writeSafely(transferFunction.write, value));
  }

  /**
   * Shows one value of each ray in the colours of the transfer function, instead of all that shines and absorbs along it:
   * the largest, `max`, the smallest, `min`, or the `average`. The largest opacity then counts as 1.
   */
  @property() projection!: 'max' | 'min' | 'average' | null;

  /**
   * `lit` shows how surfaces in the volume stand, by a light at the eye and the X3D lights among the children; `unlit`, the default, shows
   * colours as the legend has them. A `projection` is never lit. @default unlit
   */
  @property() shading!: 'lit' | 'unlit' | null;

  /** Data values `low high` that presets and percentages span; by default the histogram's. */
  @property({ attribute: 'value-window', kind: pair }) valueWindow!: readonly [low: number, high: number] | null;

  /** World length over which a stop's opacity holds; by default 1 % of the volume's longest edge. */
  @property({ attribute: 'reference-length', kind: number }) referenceLength!: number | null;

  /**
   * Multiplies the extinction of the whole volume; 1 by default.
   * @default 1
   */
  @property({ attribute: 'opacity-factor', kind: number }) opacityFactor!: number | null;

  /**
   * Multiplies the light of the whole volume, which saturates at white; 1 by default.
   * @default 1
   */
  @property({ attribute: 'light-factor', kind: number }) lightFactor!: number | null;

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
   * What mouse, fingers and keys move: the camera, or, with `none`, nothing.
   * @default auto
   */
  @property() interaction!: string | null;

  /** Shows buttons over the picture, as a video has them: standard views, the first view, full screen, save, copy the view, help. */
  @property({ kind: flag }) controls!: boolean;

  /**
   * Which of the `controls` are left out, separated by blanks: `noplay`, `noviews`, `noreset`, `nofullscreen`, `nosave`, `nocopy`, `nohelp`, `nohint`.
   */
  @property() controlslist!: string | null;

  /** A click or a tap on the picture fires `volume-pick`: what is there. A `<volume-readout>` or a `<volume-slice-view>` for the element has the same effect. */
  @property({ kind: flag }) pickable!: boolean;

  /**
   * Where the crosshair of the `<volume-slice-view>`s of this view is, `x y z` in world units. To set it brings them there; to
   * read it tells where they are. Without such panes it has no effect.
   */
  @property({ kind: vector })
  get cursor(): Vector3 | null {
    return this._crosshair?.place ?? vector.read(this.readText('cursor'));
  }

  set cursor(value: Vector3 | null) {
    this.writeText('cursor', writeSafely(vector.write, value));
  }

  /** @internal */
  _crosshair: { readonly place: Vector3 | null } | null = null;

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
