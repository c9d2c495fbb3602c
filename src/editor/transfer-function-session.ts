import type { Patch } from '../optics/transfer/patches.ts';
import type { TransferFunction } from '../optics/transfer/transfer-function.ts';
import { writePatches } from '../optics/transfer/write-patches.ts';
import { writeTransferFunction } from '../optics/transfer/write-transfer-function.ts';
import { EditHistory } from './edit-history.ts';
import { simplifyStops } from './transfer-function-edits.ts';

/** How a page wants a volume to look, in its attributes' words; null where it says nothing. */
export interface Appearance {
  readonly transferFunction: string | null;
  readonly transferFunction2d?: string | null;
  readonly opacityFactor: number | null;
  readonly lightFactor: number | null;
}

/** The same as numbers: what a volume looks like. */
interface Optics {
  readonly transferFunction: TransferFunction;
  readonly patches?: readonly Patch[];
  readonly opacityFactor: number;
  readonly lightFactor: number;
}

/** What is edited. */
export interface Look {
  readonly stops: TransferFunction;
  /** Boxes and Gaussians of values and gradients; none where values alone count. */
  readonly patches: readonly Patch[];
  readonly opacityFactor: number;
  readonly lightFactor: number;
  /** The attributes that say so. */
  readonly attributes: Appearance;
}

/** What an editor needs of a <volume-view>. */
export interface EditedView {
  appearance: Appearance;
  readonly optics: Optics | null;
}

/** More stops than that are no longer to be told apart by hand. */
export const maxHandles = 24;

const names = ['transferFunction', 'transferFunction2d', 'opacityFactor', 'lightFactor'] as const;

/**
 * The edits of one volume's look: the present look, what was before, and the writing to the volume, once a frame at
 * most. What the page itself says is where it begins; when the page says something else it begins anew.
 */
export class EditSession {
  #view: EditedView | null = null;
  #history: EditHistory<Look> | null = null;
  #look: Look | null = null;
  /** What the volume's attributes were when they were last read or written here. */
  #known: Appearance | null = null;
  #frame = 0;

  /** @param wrote - called after the volume has been given an edit that goes on (`input`) or is done (`change`) */
  constructor(readonly wrote: (type: 'input' | 'change') => void) {}

  /** The present look; null without a volume. */
  get look(): Look | null {
    return this.#look;
  }

  get canUndo(): boolean {
    return this.#history?.canUndo ?? false;
  }

  get canRedo(): boolean {
    return this.#history?.canRedo ?? false;
  }

  /** Whether anything differs from what the page said. */
  get canReset(): boolean {
    return this.#history !== null && this.#look !== this.#history.first;
  }

  /** Take in what a volume says now. */
  follow(view: EditedView | null): void {
    const optics = view?.optics;
    if (!view || !optics) return this.#stop();
    const attributes = view.appearance;
    if (view !== this.#view || !this.#look || !isSame(attributes, this.#known!)) {
      this.#begin(view, optics, attributes);
    } else if (this.#frame === 0 && !optics.patches?.length && attributes.transferFunction !== writeTransferFunction(this.#look.stops)) {
      // Those of boxes and Gaussians say nothing of stops. The page's own words, which may mean other stops for another volume or window.
      this.#replaceStops(simplifyStops(optics.transferFunction, maxHandles));
    }
    if (this.#frame === 0 && (attributes.transferFunction2d ?? null) !== textOf(this.#look!.patches)) this.#replacePatches(optics.patches ?? []);
  }

  /** Change the stops, for now; commit() makes it a step. */
  setStops(stops: TransferFunction): void {
    if (stops === this.#look?.stops) return;
    this.#edit({ stops }, { transferFunction: writeTransferFunction(stops) });
  }

  /** Change the boxes and Gaussians, for now. */
  setPatches(patches: readonly Patch[]): void {
    this.#edit({ patches }, { transferFunction2d: textOf(patches) });
  }

  /** Change a factor, for now. */
  setFactor(name: 'opacityFactor' | 'lightFactor', factor: number): void {
    this.#edit({ [name]: factor }, { [name]: factor });
  }

  /** The edit is done: it becomes a step that can be undone. */
  commit(): void {
    if (!this.#history || !this.#look || this.#look === this.#history.present) return;
    this.#history.push(this.#look);
    this.#write('change');
  }

  undo(): void {
    if (this.#history) this.#go(this.#history.undo());
  }

  redo(): void {
    if (this.#history) this.#go(this.#history.redo());
  }

  /** Back to what the page said, which is a step too. */
  reset(): void {
    if (!this.#history) return;
    this.#history.push(this.#history.first);
    this.#go(this.#history.first);
  }

  /** The look as attributes for a page to copy. */
  writeAttributes(): string {
    if (!this.#look) return '';
    const { stops, opacityFactor, lightFactor, attributes } = this.#look;
    const { transferFunction, transferFunction2d = null } = attributes;
    return [
      ...(transferFunction2d === null ? [] : [writeAttribute('transfer-function-2d', transferFunction2d)]),
      ...(transferFunction2d !== null && transferFunction === null ? [] : [writeAttribute('transfer-function', transferFunction ?? writeTransferFunction(stops))]),
      ...(opacityFactor === 1 ? [] : [writeAttribute('opacity-factor', String(opacityFactor))]),
      ...(lightFactor === 1 ? [] : [writeAttribute('light-factor', String(lightFactor))]),
    ].join(' ');
  }

  #begin(view: EditedView, optics: Optics, attributes: Appearance): void {
    this.#stop();
    const { transferFunction, patches = [], opacityFactor, lightFactor } = optics;
    this.#view = view;
    this.#known = attributes;
    this.#look = { stops: simplifyStops(transferFunction, maxHandles), patches, opacityFactor, lightFactor, attributes };
    this.#history = new EditHistory(this.#look);
  }

  #stop(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#view = null;
    this.#look = null;
    this.#history = null;
  }

  #replaceStops(stops: TransferFunction): void {
    if (writeTransferFunction(stops) === writeTransferFunction(this.#look!.stops)) return;
    this.#look = { ...this.#look!, stops };
    this.#history!.replace(this.#look);
  }

  #replacePatches(patches: readonly Patch[]): void {
    if (textOf(patches) === textOf(this.#look!.patches)) return;
    this.#look = { ...this.#look!, patches };
    this.#history!.replace(this.#look);
  }

  #edit(change: Partial<Look>, attributes: Partial<Appearance>): void {
    if (!this.#look) return;
    this.#look = { ...this.#look, ...change, attributes: { ...this.#look.attributes, ...attributes } };
    if (this.#frame === 0) this.#frame = requestAnimationFrame(() => this.#write('input'));
  }

  #go(look: Look): void {
    if (look === this.#look) return;
    this.#look = look;
    this.#write('change');
  }

  #write(type: 'input' | 'change'): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    if (!this.#view || !this.#look) return;
    this.#known = this.#look.attributes;
    this.#view.appearance = this.#known;
    this.wrote(type);
  }
}

/** null for none. */
function textOf(patches: readonly Patch[]): string | null {
  return patches.length > 0 ? writePatches(patches) : null;
}

function isSame(a: Appearance, b: Appearance): boolean {
  return names.every((name) => a[name] === b[name]);
}

function writeAttribute(name: string, text: string): string {
  return `${name}="${text.replaceAll('&', '&amp;').replaceAll('"', '&quot;')}"`;
}
