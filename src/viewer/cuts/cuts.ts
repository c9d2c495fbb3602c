import { loadPart } from '../../core/load-part.ts';
import type { Volume } from '../../volume/volume.ts';
import type { ErrorState } from '../model/error-state.ts';
import type * as ReadCuts from './read-cuts.ts';
import type { ScanModel } from '../model/scan-model.ts';
import type { Settings } from '../model/settings.ts';
import { socketOf } from '../model/view-socket.ts';
import { noCuts } from './shown-cuts.ts';
import type { Cuts } from './shown-cuts.ts';

export { noCuts };
export type { Cuts };

/** Whether a node in an element's page cuts its volume. */
const isCut = (node: Node): boolean => /^(volume-slice|clipplane)$/i.test(node.nodeName);

/** Whether an added or removed node is a cut, or contains one. */
const holdsCut = (node: Node): boolean =>
  isCut(node) || (node instanceof Element && [...node.getElementsByTagName('*')].some(isCut));

/**
 * Call `changed` when something that cuts the volume of an element is added, removed or changed; where there are volume nodes of
 * X3D, also call it with true, after each change.
 */
export function watchSlices(host: Element, changed: (isLook?: boolean) => void): { disconnect(): void } {
  const appearance = (): unknown =>
    [...host.getElementsByTagName('*')].some((one) => /volume(style|data)$/i.test(one.localName)) && changed(true);
  const observer = new MutationObserver((records) => {
    if (
      records.some(
        ({ target, attributeName, addedNodes, removedNodes }) =>
          attributeName === 'cutout' || isCut(target) || [...addedNodes, ...removedNodes].some(holdsCut),
      )
    )
      changed();
    appearance();
  });
  appearance();
  observer.observe(host, { childList: true, subtree: true, attributes: true });
  return observer;
}

/** Reads the cuts that an author requests. The code for this is loaded with the first cut. */
export class CutReader {
  #reader: typeof ReadCuts | null = null;

  /**
   * @param host - the element, whose children may be slices
   * @param settings - returns the present settings
   */
  constructor(
    readonly host: Element,
    readonly errors: ErrorState,
    readonly settings: () => Settings,
  ) {}

  /** Whether `read` works without loading more code. */
  isReady(volume: Pick<Volume, 'grid' | 'radar'>): boolean {
    const { region, rings } = this.settings();
    const hasRings = rings.value !== 'none' && (rings.value !== null || volume.grid.kind === 'polar');
    return (
      this.#reader?.isReady(this.host, volume, hasRings) ??
      (region.value === null &&
        !hasRings &&
        ![...this.host.getElementsByTagName('*')].some(isCut) &&
        !this.host.hasAttribute('cutout') &&
        socketOf(this.host).parts.every((part) => !part.clip))
    );
  }

  /** @param all - load the code for the map too; the first picture does not wait for it */
  async prepare(volume: Pick<Volume, 'grid' | 'radar'>, all = false): Promise<void> {
    if (this.isReady(volume)) return;
    const reader = await loadPart(import('./read-cuts.ts'), 'reads cuts');
    await reader.prepare(this.host);
    if (all) await reader.prepareMap(volume);
    this.#reader = reader;
  }

  /**
   * Read the cuts; what can't be read is reported, and left out.
   * @param model - the volume that sets the camera
   */
  read(volume: Volume, model: ScanModel): Cuts {
    const none = { ...noCuts, framed: model.grid };
    return this.#reader?.readCuts(this, volume, model, none) ?? none;
  }
}
