import type { RayStyle } from '../../optics/rays/ray-style.ts';
import type { GridFrame } from '../../volume/grid.ts';
import type { Volume } from '../../volume/volume.ts';
import { noCuts } from './cuts.ts';
import type { Cuts } from './cuts.ts';
import type { ViewLabels } from '../model/view-labels.ts';
import type { ViewOverlay } from '../model/view-overlay.ts';
import type { ViewSocket } from '../model/view-socket.ts';
import { styleOf } from '../model/volume-info.ts';
import type { VolumeOptics } from '../model/volume-info.ts';

/** The volume that is shown, its visible part and its appearance: all that any scene needs for it. */
export class ShownVolume {
  volume: Volume | null = null;
  optics: VolumeOptics | null = null;
  cuts: Cuts = noCuts;

  /** @param parts - of the view; null where there is only the volume */
  constructor(readonly parts: Pick<ViewSocket, 'last'> | null = null) {}

  get labels(): ViewLabels | null {
    return this.parts?.last('labels') ?? null;
  }

  /** A second field over the volume. */
  get overlay(): ViewOverlay | null {
    return this.parts?.last('overlay') ?? null;
  }

  /** Whether there is enough to draw a picture. */
  get isReady(): boolean {
    return this.volume !== null && this.optics !== null;
  }

  /** How rays are drawn, if not by emission and absorption alone; null for that. */
  get style(): RayStyle | null {
    return this.optics && styleOf(this.optics);
  }

  /** The visible part: cameras frame it, and steps are counted along its diagonal. To be read only where there is a volume. */
  get grid(): GridFrame {
    const { grid, finer } = this.volume!;
    return this.cuts.region ?? finer?.grid ?? grid;
  }
}
