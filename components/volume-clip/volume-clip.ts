import type { PropertyValues } from 'lit';
import { stretchOf } from '../../src/radar/polar-geometry.ts';
import { readClipAttributes } from '../../src/viewer/cuts/clip-attributes.ts';
import { ClipModel } from '../../src/viewer/cuts/clip-model.ts';
import type { ClipGrip, ClipRoom } from '../../src/viewer/cuts/clip-model.ts';
import type { ClipShape } from '../../src/viewer/model/clip-source.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import type { ViewPart } from '../../src/viewer/model/view-socket.ts';
import { Handles } from '../../src/viewer/overlays/handles.ts';
import type { Handle } from '../../src/viewer/overlays/handles.ts';
import { corners } from '../../src/volume/grid.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { ClipLocale } from '../../src/messages/clip-locale.ts';
import { box, number, vector } from '../internal/property-kinds.ts';
import { property, ReflectingElement, writeSafely } from '../internal/reflecting-element.ts';
import { VolumeLink } from '../internal/volume-link.ts';
import type { VolumeView } from '../volume-view/volume-view.ts';

type Box = readonly [x0: number, y0: number, z0: number, x1: number, y1: number, z1: number];

/**
 * A plane or a box that cuts the volume of a `<volume-view>` open, with handles over its picture: mouse and finger drag them, and
 * keys move them. At most six planes cut a volume, X3D's ClipPlanes included, and one box is cut out of it.
 *
 * Without `for` it cuts the nearest `<volume-view>`: the one around it, else the first one in the smallest element that contains both.
 * With `hidden` it cuts nothing.
 *
 * `<volume-clip for="head" type="plane" normal="1 0 0" at="0"></volume-clip>`
 *
 * @tag volume-clip
 * @cssproperty --volume-view-handle-color - of the `<volume-view>`: colour of the handles, which are parts `handle` of the view
 * @fires {CustomEvent<ClipShape>} clip-change - a person moves it; the detail gives its new position
 */
export class VolumeClip extends ReflectingElement {
  /** The id of the `<volume-view>`; by default the nearest one. */
  @property({ attribute: 'for' }) htmlFor!: string | null;

  /**
   * `plane` or `box`.
   * @default plane
   */
  @property() type!: string | null;

  /** Of a plane: its normal, `x y z`. The part of the volume on that side is kept. By default upwards, `0 0 1`. */
  @property({ kind: vector }) normal!: Vector3 | null;

  /**
   * Of a box: whether the `inside` or the `outside` is kept.
   * @default inside
   */
  @property() keep!: string | null;

  readonly #model = new ClipModel();
  readonly #locale = new ClipLocale(this);
  readonly #link = new VolumeLink(this, () => this.#follow(), ['load', 'optics-change', 'time-change']);
  readonly #part: ViewPart = {
    key: 'volume-clip',
    element: this,
    clip: () => {
      if (this.#error) throw this.#error;
      return this.hidden ? null : this.#shape;
    },
  };
  #view: VolumeView | null = null;
  #handles: Handles | null = null;
  /** The error in the attributes, if any. */
  #error: unknown = null;

  constructor() {
    super();
    new MutationObserver(() => this.requestUpdate()).observe(this, { attributes: true, attributeFilter: ['hidden'] });
  }

  /**
   * Of a plane: its position along the normal, in world units (mm). By default the middle of the volume. For a radar, heights are those
   * before the exaggeration. Reading it returns the position to which a person moved it.
   */
  @property({ kind: number })
  get at(): number | null {
    const shape = this.#shape;
    return shape?.kind === 'plane' ? shape.at : number.read(this.readText('at'));
  }

  set at(at: number | null) {
    this.writeText('at', writeSafely(number.write, at));
  }

  /**
   * Of a box: two opposite corners, `x0 y0 z0 x1 y1 z1`, written as the view's `region`. By default all of the volume, or an eighth of it
   * where the outside is kept. Reading it returns the box to which a person moved it.
   */
  @property({ kind: box })
  get box(): Box | null {
    const shape = this.#shape;
    return shape?.kind === 'box' ? (shape.box as Box) : box.read(this.readText('box'));
  }

  set box(corners: Box | null) {
    this.writeText('box', writeSafely(box.write, corners));
  }

  override attributeChangedCallback(name: string, before: string | null, value: string | null): void {
    super.attributeChangedCallback(name, before, value);
    if (name !== 'for') this.#read();
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('htmlFor') && this.hasUpdated) this.#link.find();
  }

  protected override updated(): void {
    this.#show();
    this.#cut();
  }

  /** Its handles are in the view. The element itself shows nothing. */
  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  get #room(): ClipRoom | null {
    const grid = this.#link.volume?.grid;
    if (!grid) return null;
    const stretch = stretchOf(grid);
    const places = corners(grid);
    const [low, high] = [Math.min, Math.max].map(
      (end) =>
        [1, 1, stretch].map((scale, axis) => end(...places.map((place) => place[axis])) / scale) as unknown as Vector3,
    );
    return { low, high, stretch };
  }

  get #shape(): ClipShape | null {
    return this.#error ? null : this.#model.shape(this.#room);
  }

  #read(): void {
    this.#error = null;
    try {
      this.#model.said = readClipAttributes((name) => this.readText(name));
    } catch (error) {
      this.#error = error; // The view that would be cut shows the error.
    }
  }

  /** Called when there is another view, or none, or another volume in it. */
  #follow(): void {
    const { view } = this.#link;
    if (view !== this.#view) {
      const before = this.#view;
      if (before) void socketOf(before).leave(this.#part);
      this.#handles?.dispose();
      this.#handles = null;
      this.#view = view;
      if (view) void socketOf(view).join(this.#part);
    }
    this.requestUpdate();
  }

  #show(): void {
    const [view, room] = [this.#view, this.#room];
    const picture = view?.shadowRoot?.querySelector('.picture');
    if (!view || !room || !picture || this.hidden || this.#error) return this.#handles?.set([]);
    this.#handles ??= new Handles(view, picture, { moved: (index, to) => this.#move(index, to) });
    this.#handles.set(this.#model.grips(room).map((grip) => this.#name(grip, room)));
  }

  #cut(): void {
    if (this.#view) void socketOf(this.#view).update(this.#part);
  }

  #name({ at, along, side }: ClipGrip, { stretch }: ClipRoom): Handle {
    const { language, messages } = this.#locale;
    const shape = this.#shape!;
    const own: Vector3 = [at[0], at[1], at[2] / stretch];
    const places = shape.kind === 'plane' ? [shape.at!] : side ? [own[side.axis]] : own;
    const name =
      shape.kind === 'plane'
        ? messages.clipPlane
        : side
          ? messages.clipSides[side.axis][Number(side.isHigh)]
          : messages.clipBox;
    return {
      at,
      along,
      name,
      place: places.map((place) => language.number(place)).join(' '),
      keys: along ? messages.handleKeysAlong : messages.handleKeys,
    };
  }

  #move(index: number, to: Vector3): void {
    const room = this.#room;
    if (!room) return;
    this.#model.move(index, to, room);
    this.#show();
    this.#cut();
    const event = new CustomEvent('clip-change', { detail: this.#shape });
    this.dispatchEvent(event);
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-clip': VolumeClip;
  }
}
