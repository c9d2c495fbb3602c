// How much light and styles may change between two samples whose values differ little. The stated largest error includes this.
import type { GridFrame } from '../../volume/grid.ts';
import type { VolumeData } from '../../volume/volume.ts';
import { domainOf } from '../transfer/emission.ts';
import { flatChange, weighChange } from '../rays/gradient.ts';
import { fogFlat } from '../transfer/lights.ts';
import { perGradientReach, perReferenceLength } from '../rays/styled.ts';
import type { TransferFunction } from '../transfer/transfer-function.ts';
import { buildStyleTable, flatFactor, flatOf, shareOfChange, styleColumns } from '../transfer/volume-styles.ts';
import type { StyleChain, VolumeStyle } from '../transfer/volume-styles.ts';

/** How styles change the extinction of what is visible for a range of values. */
export interface StyleChange {
  /** The largest factor. */
  readonly max: number;
  /** The largest difference in appearance that one and the same value may have, colours included, as a share of the extinction. */
  readonly apart: number;
}

/** The change in cells with values in a range, data units. */
export type StyleRange = (low: number, high: number) => StyleChange;

/** A volume and its style. */
export interface StyledAppearance {
  readonly volume: Pick<VolumeData, 'range' | 'finer'> & { readonly grid: GridFrame & { readonly kind?: string } };
  readonly transferFunction: TransferFunction;
  readonly referenceLength: number;
}

/** For central differences: along each axis, a difference is at most half of the range of values. */
const steepest = Math.sqrt(3) / 2;

/** The largest change of values from voxel to voxel. A radar's gates may have any size, so theirs has no limit. */
function changeAmong({ grid }: StyledAppearance['volume']): (low: number, high: number) => number {
  return (low, high) => (grid.kind === 'polar' && high > low ? Infinity : steepest * (high - low));
}

/** For light on fog: where the field is not flat, the light that is seen may be anything up to the opacity. */
export function rangeLight({ volume, transferFunction }: StyledAppearance): StyleRange {
  const flat = fogFlat * flatChange(domainOf(transferFunction), volume.range);
  const change = changeAmong(volume);
  return (low, high) => ({ max: 1, apart: weighUpTo(change(low, high), flat) });
}

/** For styles, from their own table. */
export function rangeStyles(chains: readonly StyleChain[], appearance: StyledAppearance): StyleRange {
  const { volume, transferFunction, referenceLength } = appearance;
  const flat = flatChange(domainOf(transferFunction), volume.range);
  const change = changeAmong(volume);
  const toChange = perReferenceLength(volume.finer?.finest ?? volume.grid, referenceLength) / flat;
  const all = chains.map(({ weight, styles }) => {
    const table = buildStyleTable(styles);
    const [byFacing, byChange, byReach] = [0, 1, 2].map((channel) => extremes(table, channel));
    const perReach = perGradientReach(styles, flat, referenceLength);
    const facing = byFacing(1);
    const min = Math.min(flatFactor(styles), facing[0]);
    const max = Math.max(flatFactor(styles), facing[1]);
    return {
      weight,
      hasColors: styles.some(isColored),
      min,
      max,
      byChange,
      byReach: (along: number) => byReach(perReach > 0 ? Math.min(1, along * perReach) : 0),
    };
  });
  return (low, high) => {
    const perVoxel = change(low, high);
    const along = toChange * perVoxel;
    const weighed = weighUpTo(perVoxel, flatOf(chains) * flat);
    return all.reduce<StyleChange>(
      (sum, one) => {
        const [ofChange, ofReach] = [
          one.byChange(shareOfChange(Math.min(1e30, along))),
          one.byReach(Math.min(1e30, along)),
        ];
        const max = one.max * ofChange[1] * ofReach[1];
        const apart = max - one.min * ofChange[0] * ofReach[0] + (one.hasColors ? weighed * max : 0);
        return { max: sum.max + one.weight * max, apart: sum.apart + one.weight * apart };
      },
      { max: 0, apart: 0 },
    );
  };
}

function weighUpTo(change: number, flat: number): number {
  return change < Infinity ? weighChange([change, 0, 0], flat) : 1;
}

function isColored({ kind }: VolumeStyle): boolean {
  return kind !== 'boundary' && kind !== 'gradient' && kind !== 'silhouette';
}

/** The smallest and largest factor in a row of the table, from its beginning to a share of it. */
function extremes(table: Float64Array, channel: number): (share: number) => readonly [number, number] {
  const known: (readonly [number, number])[] = [];
  for (let i = 0; i < styleColumns; i++) {
    const factor = table[4 * (3 * styleColumns + i) + channel];
    const [min, max] = known[i - 1] ?? [factor, factor];
    known.push([Math.min(min, factor), Math.max(max, factor)]);
  }
  return (share) => known[Math.min(styleColumns - 1, Math.ceil(share * (styleColumns - 1)))];
}
