import type { Appearance } from '../../src/editor/transfer-function-session.ts';
import type { Stop } from '../../src/optics/transfer/transfer-function.ts';
import { PictureAttributes } from './picture-attributes.ts';
import { number, pair, transferFunction } from './property-kinds.ts';
import { property, writeSafely } from './reflecting-element.ts';

/** What an editor changes. */
const edited = ['transferFunction', 'transferFunction2d', 'opacityFactor', 'lightFactor'] as const;

/** What an author wants the volume to look like. */
export class LookAttributes extends PictureAttributes {
  /** What an editor of the transfer function changes, all at once: four of the attributes. */
  get appearance(): Appearance {
    return Object.fromEntries(edited.map((name) => [name, this[name]])) as unknown as Appearance;
  }

  set appearance(appearance: Appearance) {
    let given: Partial<Appearance> = { transferFunction: '?' };
    try {
      given = { ...appearance };
    } catch {} // It can't be read, and the element says so.
    // What is the same, or not said, stays as the page wrote it.
    for (const name of edited) if (name in given && given[name] !== this[name]) (this as Record<string, unknown>)[name] = given[name];
  }

  /**
   * One word for colours, light, opacity and projection that suit the data: `textbook` and `flat`; `mip`, but for labels; of CT and MRI `xray` and `skin`; of CT
   * `bone` and `vessels`. Other attributes win over it.
   */
  @property() look!: string | null;

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
   * `lit` shows how surfaces in the volume stand, by a light at the eye and the X3D lights among the children; `unlit` shows colours as the
   * legend has them. By default the surfaces of `surface-values` are lit, and nothing else. A `projection` is never lit.
   */
  @property() shading!: 'lit' | 'unlit' | null;

  /**
   * Surfaces on which the data have a value: `value colour opacity, ...`, four at most, each lit. A value is a number or a percentage of the
   * window; an opacity, 1 by default, is what one surface hides. Without a `transfer-function` there is nothing but surfaces.
   */
  @property({ attribute: 'surface-values' }) surfaceValues!: string | null;

  /**
   * Factors of the opacity by how steeply values change: `gradient factor, ...`, for instance `0 0, 10% 1`, which leaves boundaries and clears what is
   * even. A gradient is in data units per world unit (of a CT, HU per millimetre), or a percentage of the window along a reference length; it rises.
   */
  @property({ attribute: 'gradient-opacity' }) gradientOpacity!: string | null;

  /**
   * Colours and opacities by value and gradient: `box low high low high colour opacity`, values before gradients, and
   * `gaussian value gradient width width colour opacity`, separated by commas, eight at most. It stands in for `transfer-function`; gradients are as in
   * `gradient-opacity`.
   */
  @property({ attribute: 'transfer-function-2d' }) transferFunction2d!: string | null;

  /** Data values `low high` that presets and percentages span; by default the histogram's. */
  @property({ attribute: 'value-window', kind: pair }) valueWindow!: readonly [low: number, high: number] | null;

  /** World length over which a stop's opacity holds; by default 1 % of the volume's longest edge, less where it is thin. */
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
}
