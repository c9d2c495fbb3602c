import { brighten } from '../../optics/transfer/brighten.ts';
import type { SeenVolume } from '../../optics/cells/cell-detail.ts';
import type { Contribution } from '../../optics/cells/empty-space-distance.ts';
import { findSeenCells } from '../../optics/cells/seen-cells.ts';
import type { Substeps } from '../../optics/cells/substeps.ts';
import type { Volume } from '../../volume/volume.ts';
import { Kept } from '../device/kept.ts';
import type { Optics } from '../ray/ray-module.ts';

/** What adds to what is seen of a volume, or hides some of it. */
export interface MoreSeen {
  /** Others where it tells otherwise. */
  readonly shown: readonly unknown[];
  more(seen: SeenVolume): Pick<SeenVolume, 'more' | 'functions' | 'hasSurfaces' | 'jumps' | 'found' | 'style'> | undefined;
}

/** What can be seen of a layer's volume, macrocell by macrocell; found again when the volume or its look is another. */
export class SeenInLayer {
  readonly #cells = new Kept<Uint8Array>();
  readonly #seen = new Kept<SeenVolume>();
  readonly #detail = new Kept<Uint8Array>();

  /**
   * In which macrocells something can be seen, and what.
   * @param contributions - which values do what; none where any value may be seen
   */
  find(volume: Volume, optics: Optics, contributions: readonly Contribution[], beside: MoreSeen): SeenVolume {
    const { transferFunction, lightFactor, opacityFactor, referenceLength } = optics;
    const cells = this.#cells.get([volume, ...contributions], () => findSeenCells(volume.macrocells, contributions, volume));
    return this.#seen.get([cells, optics, ...beside.shown], () => {
      const seen = { volume, cells, transferFunction: brighten(transferFunction, lightFactor), opticalScale: opacityFactor / referenceLength };
      return { ...seen, ...beside.more(seen) };
    });
  }

  /** How finely each macrocell is sampled at the least; null where steps are cut by what is at their ends alone. */
  detail({ voxelsPerStep, mayLose, findDetail }: Substeps, find: () => SeenVolume | null): Uint8Array | null {
    const seen = voxelsPerStep > 0 ? find() : null;
    return seen && findDetail ? this.#detail.get([seen, mayLose], () => findDetail(seen, mayLose)) : null;
  }

  /** What `detail` told last; null before. */
  get lastDetail(): Uint8Array | null {
    return this.#detail.last;
  }
}
