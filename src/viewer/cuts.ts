import { loadPart } from '../load-part.ts';
import type { Slice } from '../radar/slices.ts';
import type { RayCut } from '../renderer/ray/ray-module.ts';
import type { GridFrame } from '../volume/grid.ts';
import type { Volume } from '../volume/volume.ts';
import type { ErrorBoard } from './error-board.ts';
import type * as ReadCuts from './read-cuts.ts';
import type { LabelledRings } from './read-rings.ts';
import type { ScanModel } from './scan-model.ts';
import type { Settings } from './settings.ts';

/** Which part of a volume is shown, where it is cut, and what is drawn around it. */
export interface Cuts {
  /** null for all of it. */
  readonly region: GridFrame | null;
  /** What cameras frame, which may be of another scan; null for what is shown. */
  readonly framed: GridFrame | null;
  readonly slices: readonly Slice[];
  /** What else cuts rays. */
  readonly cuts: readonly RayCut[];
  /** null for none. */
  readonly rings: LabelledRings | null;
}

export const noCuts: Cuts = { region: null, framed: null, slices: [], cuts: [], rings: null };

/** The attributes of <volume-slice>. */
const sliceAttributes = ['type', 'at', 'normal', 'thickness', 'projection', 'value-window', 'window-function', 'colors', 'elevation', 'sweep', 'height', 'azimuth', 'from', 'to', 'hidden'];

/** Calls back when the <volume-slice> children of an element come, go or change. */
export function watchSlices(host: Element, changed: () => void): { disconnect(): void } {
  const observer = new MutationObserver((records) => {
    const isSlice = (node: Node): boolean => node instanceof Element && node.localName === 'volume-slice';
    if (records.some(({ target, addedNodes, removedNodes }) => [target, ...addedNodes, ...removedNodes].some(isSlice))) changed();
  });
  observer.observe(host, { childList: true, subtree: true, attributes: true, attributeFilter: sliceAttributes });
  return observer;
}

/** Reads the cuts that an author asks for. What does so is loaded with the first of them. */
export class CutReader {
  #reader: typeof ReadCuts | null = null;

  /**
   * @param host - the element, whose children may be slices
   * @param settings - as they are at the moment
   */
  constructor(
    readonly host: Element,
    readonly errors: ErrorBoard,
    readonly settings: () => Settings,
  ) {}

  /** Whether `read` needs nothing more to be loaded. */
  isReady({ grid }: Pick<Volume, 'grid'>): boolean {
    const { region, rings } = this.settings();
    const hasRings = rings.value !== 'none' && (rings.value !== null || grid.kind === 'polar');
    return this.#reader?.isReady(this.host) ?? (region.value === null && !hasRings && ![...this.host.children].some((child) => child.localName === 'volume-slice'));
  }

  async prepare(volume: Pick<Volume, 'grid'>): Promise<void> {
    if (this.isReady(volume)) return;
    const reader = await loadPart(import('./read-cuts.ts'), 'reads regions, slices and rings');
    await reader.prepare(this.host);
    this.#reader = reader;
  }

  /**
   * What can't be read is told, and left out.
   * @param model - the volume that cameras go by
   */
  read(volume: Volume, model: ScanModel): Cuts {
    if (!this.#reader) return { ...noCuts, framed: model.grid };
    const { readRegion, readRings, readSlices } = this.#reader;
    const { region, rings, look } = this.settings();
    const { error, ...slices } = readSlices(this.host, volume, look.value?.window ?? null);
    const cuts: { -readonly [key in keyof Cuts]: Cuts[key] } = { ...noCuts, ...slices, framed: model.grid };
    this.errors.take('region', region, (box) => {
      cuts.region = readRegion(box, volume);
      cuts.framed = readRegion(box, model) ?? model.grid;
    });
    this.errors.take('rings', rings, (spacing) => (cuts.rings = readRings(spacing, volume, cuts.region)));
    this.errors.attempt('slices', () => {
      if (error) throw error;
    });
    return cuts;
  }
}
