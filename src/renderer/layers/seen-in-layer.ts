import { brighten } from '../../optics/transfer/brighten.ts';
import type { SeenVolume } from '../../optics/cells/cell-detail.ts';
import type { Contribution } from '../../optics/cells/empty-space-distance.ts';
import { findSeenCells } from '../../optics/cells/seen-cells.ts';
import type { Substeps } from '../../optics/cells/substeps.ts';
import type { VolumeData } from '../../volume/volume.ts';
import { Kept } from '../device/kept.ts';
import type { Optics } from '../ray/ray-module.ts';

/** Attachments and styles that add to what is seen of a volume, or hide a part of it. */
export interface MoreSeen {
  /** Keys: if one of these objects changes, `more` gives a different result. */
  readonly shown: readonly unknown[];
  more(
    seen: SeenVolume,
  ): Pick<SeenVolume, 'more' | 'functions' | 'hasSurfaces' | 'jumps' | 'found' | 'style'> | undefined;
}

/** What can be seen of a layer's volume, macrocell by macrocell. It is computed again when the volume or its appearance changes. */
export class SeenInLayer {
  readonly #cells = new Kept<Uint8Array>();
  readonly #seen = new Kept<SeenVolume>();
  readonly #detail = new Kept<Uint8Array>();

  /**
   * Which macrocells show something, and what they show.
   * @param contributions - which values can show; empty if any value can be seen
   */
  find(volume: VolumeData, optics: Optics, contributions: readonly Contribution[], attached: MoreSeen): SeenVolume {
    const { transferFunction, lightFactor, opacityFactor, referenceLength } = optics;
    const cells = this.#cells.get([volume, ...contributions], () =>
      findSeenCells(volume.macrocells, contributions, volume),
    );
    return this.#seen.get([cells, optics, ...attached.shown], () => {
      const seen = {
        volume,
        cells,
        transferFunction: brighten(transferFunction, lightFactor),
        opticalScale: opacityFactor / referenceLength,
      };
      return { ...seen, ...attached.more(seen) };
    });
  }

  /** The minimum sampling of each macrocell; null if only the samples at a step's ends decide how it is cut. */
  detail({ max, voxelsPerStep, mayLose, findDetail }: Substeps, find: () => SeenVolume | null): Uint8Array | null {
    const seen = voxelsPerStep > 0 ? find() : null;
    return seen && findDetail ? this.#detail.get([seen, mayLose, max], () => findDetail(seen, mayLose)) : null;
  }

  /** The last result of `detail`; null before the first one. */
  get lastDetail(): Uint8Array | null {
    return this.#detail.last;
  }
}
