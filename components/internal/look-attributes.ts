import type { Appearance } from '../../src/editor/transfer-function-session.ts';
import type { Stop } from '../../src/optics/transfer/transfer-function.ts';
import { PictureAttributes } from './picture-attributes.ts';
import { number, pairOrText, transferFunction } from './property-kinds.ts';
import { property, writeSafely } from './reflecting-element.ts';

/** The properties that an editor changes. */
const edited = ['transferFunction', 'transferFunction2d', 'opacityFactor', 'lightFactor', 'shading'] as const;

/** The attributes that say how the volume should look. */
export class LookAttributes extends PictureAttributes {
  /** The attributes that an editor of the transfer function changes, all at once. */
  get appearance(): Appearance {
    return Object.fromEntries(edited.map((name) => [name, this[name]])) as unknown as Appearance;
  }

  set appearance(appearance: Appearance) {
    let given: Partial<Appearance> = { transferFunction: '?' };
    try {
      given = { ...appearance };
    } catch {} // It can't be read, and the element shows an error.
    // Values that are unchanged or not given stay as the page wrote them.
    for (const name of edited)
      if (name in given && given[name] !== this[name]) (this as Record<string, unknown>)[name] = given[name];
  }

  /**
   * One word for colours, light, opacity and projection that suit the data: `textbook` and `flat` for all data; `mip` for all data except
   * labels; `xray` and `skin` for CT and MRI; `bone` and `vessels` for CT. Other attributes override it.
   */
  @property() look!: string | null;

  /** The name of a preset, or stops `value colour opacity, ...`; by default a preset that suits the histogram of the data. */
  @property({ attribute: 'transfer-function' })
  get transferFunction(): string | null {
    return this.readText('transfer-function');
  }

  set transferFunction(value: string | readonly Stop[] | null) {
    this.writeText('transfer-function', writeSafely(transferFunction.write, value));
  }

  /**
   * Shows one value of each ray in the colours of the transfer function, instead of all that shines and absorbs along the ray: `max`, the
   * largest value, `min`, the smallest, or `average`. The largest opacity then counts as 1.
   */
  @property() projection!: 'max' | 'min' | 'average' | null;

  /**
   * `lit` shows the orientation of surfaces in the volume, by a light at the eye and the X3D lights among the children; `unlit` shows the
   * colours as they are in the legend; `ambient-occlusion` is `lit`, with soft shadows in caves and folds. By default the surfaces of `surface-values` are lit, and MRI and CT if no other attribute and no child
   * decides how they look. A `projection` is never lit.
   */
  @property() shading!: 'lit' | 'ambient-occlusion' | 'unlit' | null;

  /**
   * Surfaces where the data have a given value: `value colour opacity, ...`, at most four, each lit. A value is a number or a percentage of
   * the window. The opacity, 1 by default, is the share of light that one surface blocks. Without a `transfer-function` only these surfaces
   * are shown.
   */
  @property({ attribute: 'surface-values' }) surfaceValues!: string | null;

  /**
   * Factors of the opacity that depend on how steeply values change: `gradient factor, ...`. For instance `0 0, 10% 1` keeps boundaries and
   * hides regions of even values. A gradient is in data units per world unit (of a CT, HU per millimetre), or a percentage of the window
   * along a reference length. Gradients have to ascend.
   */
  @property({ attribute: 'gradient-opacity' }) gradientOpacity!: string | null;

  /**
   * Colours and opacities by value and gradient: `box low high low high colour opacity`, values before gradients, and `gaussian value
   * gradient width width colour opacity`, separated by commas, at most eight. It replaces `transfer-function`; gradients are as in
   * `gradient-opacity`.
   */
  @property({ attribute: 'transfer-function-2d' }) transferFunction2d!: string | null;

  /**
   * The range of data values, `low high`, that presets and percentages refer to; by default that of the histogram. Of a DICOM file with
   * windows also the name or the number of one of them, `lung` or `2`.
   */
  @property({ attribute: 'value-window', kind: pairOrText }) valueWindow!:
    | readonly [low: number, high: number]
    | string
    | null;

  /**
   * The world length to which the opacity of a stop refers; by default 1 % of the longest edge of the volume, less where the volume is
   * thin.
   */
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
