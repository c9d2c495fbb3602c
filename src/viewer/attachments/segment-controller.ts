// Shows X3D's segments as labels of the volume: loaded with the first SegmentedVolumeData.
import { VolumeViewError } from '../../core/errors.ts';
import type { Color } from '../../optics/transfer/transfer-function.ts';
import { childrenOf } from '../../page/page-children.ts';
import { LabelController } from './label-controller.ts';
import { labelFileOf } from '../loading/label-files.ts';
import type { LabelFile } from '../loading/label-files.ts';
import { PresenterTarget } from './label-target.ts';
import { readOpacityMap } from '../../x3d/nodes/read-opacity-map.ts';
import { isDrawn, reportStyles } from '../../x3d/nodes/read-segments.ts';
import type { Identifiers, Segment } from '../../x3d/nodes/read-segments.ts';
import type { LabelOverride, ViewLabels } from '../model/view-labels.ts';
import type { ViewSocket } from '../model/view-socket.ts';
import type { Volume } from '../../volume/volume.ts';

/** What an author says about segments. */
export interface Segments {
  readonly identifiers: Identifiers;
  readonly enabled: readonly boolean[];
  readonly all: readonly Segment[];
  /** The values that their textures span; null for the window of the volume. */
  readonly window: readonly [number, number] | null;
  /** See `readOpacityMap`. */
  readonly opacityFactor: number | null;
}

/** X3D's segments have no colours of their own. */
const white: Color = [1, 1, 1];

/** A page's own labels have priority over segments. */
class SegmentTarget extends PresenterTarget {
  span: Segments['window'] = null;

  override get window(): readonly [number, number] | null {
    return this.span ?? super.window;
  }

  get isTaken(): boolean {
    return childrenOf(this.view.host, 'volume-labels').length > 0;
  }

  override async show(labels: ViewLabels | null): Promise<void> {
    if (!labels || !this.isTaken) await super.show(labels);
  }
}

/** Controls the segments of a view. */
export class SegmentController {
  readonly #target: SegmentTarget;
  readonly #controller: LabelController;
  #segments: Segments | null = null;
  #functions: readonly (string | null)[] = [];

  constructor(socket: ViewSocket) {
    this.#target = new SegmentTarget(socket);
    this.#controller = new LabelController({
      said: (ids) => ({
        overrides: new Map(ids.map((id) => [id, this.#look(id)])),
        error: this.#segments && reportStyles(this.#segments.all, this.#segments.enabled, ids),
      }),
      load: (_, signal, fetch) => loadIdentifiers(this.#segments!.identifiers, signal, fetch),
      wanted: () => ({
        src: this.#segments && nameOf(this.#segments.identifiers),
        table: null,
        hidden: false,
        transferFunction: null,
      }),
      target: () => (this.#segments ? this.#target : null),
      changed: () => {},
      failed: () => {},
    });
    const { host } = socket.view!;
    host.addEventListener('load', () => this.#controller.refresh());
    host.addEventListener('optics-change', () => this.#controller.rewindow());
  }

  /** @param isLast - whether no newer segments have come meanwhile: textures may load slowly @throws {VolumeViewError} */
  async show(segments: Segments, isLast: () => boolean): Promise<void> {
    if (this.#target.isTaken) {
      throw new VolumeViewError(
        'attribute/invalid',
        '<SegmentedVolumeData> got <volume-labels>; expected one of the two, as a volume has one set of labels. The <volume-labels> is drawn.',
      );
    }
    const functions = await Promise.all(
      segments.all.map(async ({ texture }) => (texture ? readOpacityMap(texture, segments.opacityFactor) : null)),
    );
    if (!isLast()) return;
    this.#functions = functions;
    this.#segments = segments;
    this.#target.span = segments.window;
    this.#controller.refresh();
  }

  hide(): void {
    if (this.#segments) this.#controller.leave(this.#target);
    this.#segments = null;
  }

  #look(id: number): LabelOverride {
    const transferFunction = this.#functions[id];
    return {
      color: white,
      ...(this.#segments && !isDrawn(this.#segments.enabled, id) && { hidden: true as const }),
      ...(transferFunction && { transferFunction }),
    };
  }
}

/** Identifies a texture, and how it is read. */
function nameOf({ url, settings: { mosaic, slices } = {}, max }: Identifiers): string {
  return [url, mosaic && `${mosaic.columns}x${mosaic.rows}`, slices, max]
    .filter((part) => part !== undefined && part !== null)
    .join(' ');
}

function loadIdentifiers(
  { max, ...request }: Identifiers,
  signal: AbortSignal,
  fetch: PresenterTarget['fetch'],
): Promise<LabelFile> {
  return labelFileOf(request, signal, { fetch, change: (volume) => (max === null ? volume : spread(volume, max)) });
}

/** Convert X3DOM's shares of pixels to numbers of segments; `most` is the number of segments in X3DOM. */
function spread(volume: Volume, max: number): Volume {
  const { ids, samples } = volume;
  const full = samples instanceof Uint16Array || (ids?.at(-1) ?? 0) > 255 ? 65535 : 255;
  return {
    ...volume,
    ids: undefined,
    samples: samples.map((pixel) => segmentOf((ids ? ids[pixel] : pixel) / full, max)),
  };
}

/** Segment 0 starts at 0, and segment n at (n + 1/2) / most. */
export function segmentOf(share: number, max: number): number {
  return Math.max(0, Math.floor(share * max - 0.5));
}
