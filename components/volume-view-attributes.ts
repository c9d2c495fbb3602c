import { LitElement } from 'lit';
import type { PropertyValues } from 'lit';
import type { Appearance } from '../src/editor/transfer-function-session.ts';
import { property } from 'lit/decorators.js';
import { renameAttribute } from './deprecated.ts';
import { openRoots } from './open-roots.ts';

/** Takes null for an absent attribute and any text for a present one; the text is read where it is used. */
const asText = (value: string | null): string | null => value;

/** What an author writes on `<volume-view>`: texts, as they stand in HTML; null where absent. */
export class VolumeViewAttributes extends LitElement {
  override connectedCallback(): void {
    super.connectedCallback();
    openRoots.notice(this);
  }

  static override get observedAttributes(): string[] {
    return [...super.observedAttributes, 'play'];
  }

  /** The old spelling of an attribute is read as the new one. */
  override attributeChangedCallback(name: string, before: string | null, value: string | null): void {
    super.attributeChangedCallback(name === 'play' ? renameAttribute(name) : name, before, value);
  }

  /** Scripts write numbers too, `view.steps = 200`, and `undefined` for nothing. */
  protected override willUpdate(changed: PropertyValues): void {
    const { elementProperties } = this.constructor as typeof LitElement;
    const texts = this as unknown as Record<PropertyKey, string | number | null | undefined>;
    for (const name of changed.keys()) {
      if (elementProperties.get(name)?.converter === asText) texts[name] = texts[name]?.toString() ?? null;
    }
  }

  /** What an editor of the transfer function changes, all at once: three of the attributes. */
  get appearance(): Appearance {
    const { transferFunction, opacityFactor, lightFactor } = this;
    return { transferFunction, opacityFactor, lightFactor };
  }

  set appearance({ transferFunction, opacityFactor, lightFactor }: Appearance) {
    Object.assign(this, { transferFunction, opacityFactor, lightFactor });
  }

  /**
   * URL of the data: a NIfTI file, a mosaic image, a radar scan (ODIM_H5, CfRadial, NEXRAD Level II) or a JSON manifest.
   * Several URLs, separated by blanks, are scans in the order of time; a blank within a URL is written `%20`.
   */
  @property({ converter: asText }) src: string | null = null;

  /** Tiles per row and column of a mosaic image, `COLUMNSxROWS`, row by row from the top left. */
  @property({ converter: asText }) mosaic: string | null = null;

  /** Tiles of the mosaic that hold slices; all of them by default. */
  @property({ converter: asText }) slices: string | null = null;

  /**
   * World units per voxel, of a mosaic per pixel and slice: `x y z`. By default the file's own, or 1 1 1. A negative one
   * turns its axis round, for slices that run from head to feet, say.
   */
  @property({ converter: asText }) spacing: string | null = null;

  /** The grid that the data of a mosaic lie on: `cartesian`, or `spherical` for a radar's sweeps, one a tile. */
  @property({ converter: asText }) coordinates: string | null = null;

  /** Elevations of a radar's mosaic, degrees, one a tile: `0.5 1.2 2.4`. */
  @property({ converter: asText }) elevations: string | null = null;

  /** Of a radar's mosaic: metres to the middle of the first gate, and from gate to gate. */
  @property({ converter: asText }) range: string | null = null;

  /** Of a radar's mosaic: middle of the first ray and step to the next, degrees clockwise from north; all around by default. */
  @property({ converter: asText }) azimuth: string | null = null;

  /** The quantity of a radar scan, as its file names it: `DBZH`, `VRAD` ... By default its reflectivity. */
  @property({ converter: asText }) moment: string | null = null;

  /**
   * How a radar's beams run: `standard`, bent by the atmosphere over a round Earth (4/3 of its radius), or `straight`
   * over a flat one.
   */
  @property({ converter: asText, attribute: 'beam-model' }) beamModel: string | null = null;

  /** Heights of a radar scan are shown so many times as large; 5 by default, 1 where it reaches less than 50 km. */
  @property({ converter: asText, attribute: 'vertical-exaggeration' }) verticalExaggeration: string | null = null;

  /**
   * Which of several scans is shown: its number from 0, or a time in UTC, `2018-12-20T06:06:28Z`, for the last scan that is
   * not after it (the first one where all are). By default the first. To set it shows that scan, whichever `next`,
   * `previous`, `play` or a person went to since; `scan` tells which one is shown.
   */
  @property({ converter: asText, hasChanged: () => true }) time: string | null = null;

  /** Shows one of several scans after the other as soon as a source is open, without `play()`; begins again after the last. */
  @property({ type: Boolean, reflect: true }) autoplay = false;

  /** Scans a second, while they play, or as many as can be loaded and drawn; 2 by default. */
  @property({ converter: asText, attribute: 'play-speed' }) playSpeed: string | null = null;

  /** A preset's name, or stops `value colour opacity, ...`; by default one that suits the data's histogram. */
  @property({ converter: asText, attribute: 'transfer-function' }) transferFunction: string | null = null;

  /** Data values `low high` that presets and percentages span; by default the histogram's. */
  @property({ converter: asText }) window: string | null = null;

  /** World length over which a stop's opacity holds; by default 1 % of the volume's longest edge. */
  @property({ converter: asText, attribute: 'reference-length' }) referenceLength: string | null = null;

  /** Multiplies the extinction of the whole volume; 1 by default. */
  @property({ converter: asText, attribute: 'opacity-factor' }) opacityFactor: string | null = null;

  /** Multiplies the light of the whole volume, which saturates at white; 1 by default. */
  @property({ converter: asText, attribute: 'light-factor' }) lightFactor: string | null = null;

  /**
   * Steps along the longest ray, each of one sample or, where something may be seen, several. `auto`, the default, keeps
   * `target-fps` while something moves and `max-error` at rest.
   */
  @property({ converter: asText }) steps: string | null = null;

  /** With `steps="auto"`: the fewest steps are taken that keep the picture at rest within this error (RMS, in 1/255); 1 by default. */
  @property({ converter: asText, attribute: 'max-error' }) maxError: string | null = null;

  /** With `steps="auto"`: frames a second while something moves, in steps and pixels that the device manages; 30 by default. */
  @property({ converter: asText, attribute: 'target-fps' }) targetFps: string | null = null;

  /**
   * The part that alone is shown, and that the camera frames: two opposite corners of a box, `x0 y0 z0 x1 y1 z1`, in world
   * units; of a radar scan in metres east, north and above the antenna, whatever the exaggeration of heights.
   */
  @property({ converter: asText }) region: string | null = null;

  /**
   * Rings around a radar at the height of its antenna, and a line to the north: kilometres from ring to ring; empty for
   * round ones that suit its reach, or the `region`, which cuts them. None by default.
   */
  @property({ converter: asText }) rings: string | null = null;

  /** Where the camera stands, `theta phi radius`, for instance `30deg 70deg 110%`; each part may be `auto`. */
  @property({ converter: asText, attribute: 'camera-orbit' }) cameraOrbit: string | null = null;

  /** What the camera looks at, world coordinates `x y z`; by default the volume's centre. */
  @property({ converter: asText, attribute: 'camera-target' }) cameraTarget: string | null = null;

  /** Vertical angle of view; 30deg by default. */
  @property({ converter: asText, attribute: 'field-of-view' }) fieldOfView: string | null = null;

  /** `off` leaves the camera to the page. */
  @property({ converter: asText, attribute: 'camera-controls' }) cameraControls: string | null = null;

  /** What the picture shows, for those who do not see it. */
  @property({ converter: asText }) alt: string | null = null;

  /** URL of an image that stands there until the first picture. */
  @property({ converter: asText }) poster: string | null = null;

  /**
   * `lazy`, the default, waits with loading until the element comes near the visible part of the page, or a script asks for
   * its picture; `eager` loads at once.
   */
  @property({ converter: asText }) loading: string | null = null;
}
