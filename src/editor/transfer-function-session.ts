import type { Patch } from '../optics/transfer/patches.ts';
import type { TransferFunction } from '../optics/transfer/transfer-function.ts';
import { writePatches } from '../optics/transfer/write-patches.ts';
import { writeTransferFunction } from '../optics/transfer/write-transfer-function.ts';
import { EditHistory } from './edit-history.ts';
import { simplifyStops } from './transfer-function-edits.ts';

/** The appearance that a page sets, as attribute values; null if it sets nothing. */
export interface Appearance {
  readonly transferFunction: string | null;
  readonly transferFunction2d?: string | null;
  readonly opacityFactor: number | null;
  readonly lightFactor: number | null;
  readonly shading?: string | null;
}

/** The same, parsed. */
interface Optics {
  readonly transferFunction: TransferFunction;
  readonly patches?: readonly Patch[];
  readonly opacityFactor: number;
  readonly lightFactor: number;
  readonly shading?: string;
}

/** The state that is edited. */
export interface Look {
  readonly stops: TransferFunction;
  /** Boxes and Gaussians of values and gradients; none if only values count. */
  readonly patches: readonly Patch[];
  readonly opacityFactor: number;
  readonly lightFactor: number;
  /** The attributes that describe this state. */
  readonly attributes: Appearance;
}

/** What an editor needs of a <volume-view>. */
export interface EditedView {
  appearance: Appearance;
  readonly optics: Optics | null;
}

/** More stops than this can't be handled separately by a person. */
export const maxHandles = 24;

const names = ['transferFunction', 'transferFunction2d', 'opacityFactor', 'lightFactor', 'shading'] as const;

/**
 * The edits of one volume's appearance: the present state, the earlier ones, and the writing to the volume, at most
 * once per frame. It begins with what the page itself sets; if the page sets something else, it begins again.
 */
export class EditSession {
  #view: EditedView | null = null;
  #history: EditHistory<Look> | null = null;
  #look: Look | null = null;
  /** The volume's attributes when they were last read or written here. */
  #known: Appearance | null = null;
  /** What the view chose together with its colours. It would go with the first stops of the page's own, so an edit writes it. */
  #chosen: Partial<Appearance> = {};
  #frame = 0;

  /** @param wrote - called after the volume received an edit that continues (`input`) or is finished (`change`) */
  constructor(readonly wrote: (type: 'input' | 'change') => void) {}

  /** The present state; null without a volume. */
  get look(): Look | null {
    return this.#look;
  }

  get canUndo(): boolean {
    return this.#history?.canUndo ?? false;
  }

  get canRedo(): boolean {
    return this.#history?.canRedo ?? false;
  }

  /** Whether anything differs from what the page set. */
  get canReset(): boolean {
    return this.#history !== null && this.#look !== this.#history.first;
  }

  /** Reads the present state of a volume. */
  follow(view: EditedView | null): void {
    const optics = view?.optics;
    if (!view || !optics) return this.#stop();
    const attributes = view.appearance;
    if (view !== this.#view || !this.#look || !isSame(attributes, this.#known!)) {
      this.#begin(view, optics, attributes);
    } else if (
      this.#frame === 0 &&
      !optics.patches?.length &&
      attributes.transferFunction !== writeTransferFunction(this.#look.stops)
    ) {
      // Without boxes and Gaussians the attribute defines the stops. For another volume or window the page's text may
      // mean other stops, so they are taken again.
      this.#replaceStops(simplifyStops(optics.transferFunction, maxHandles));
    }
    if (this.#frame === 0 && (attributes.transferFunction2d ?? null) !== textOf(this.#look!.patches))
      this.#replacePatches(optics.patches ?? []);
  }

  /** Changes the stops, without a step of the history; commit() makes it a step. */
  setStops(stops: TransferFunction): void {
    if (stops === this.#look?.stops) return;
    this.#edit({ stops }, { transferFunction: writeTransferFunction(stops) });
  }

  /** Changes the boxes and Gaussians, without a step of the history. */
  setPatches(patches: readonly Patch[]): void {
    this.#edit({ patches }, { transferFunction2d: textOf(patches) });
  }

  /** Changes a factor, without a step of the history. */
  setFactor(name: 'opacityFactor' | 'lightFactor', factor: number): void {
    this.#edit({ [name]: factor }, { [name]: factor });
  }

  /** Ends the edit: it becomes a step that can be undone. */
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

  /** Returns to what the page set, which is a step too. */
  reset(): void {
    if (!this.#history) return;
    this.#history.push(this.#history.first);
    this.#go(this.#history.first);
  }

  /** The appearance as attributes for a page to copy. */
  writeAttributes(): string {
    if (!this.#look) return '';
    const { stops, opacityFactor, lightFactor, attributes } = this.#look;
    const { transferFunction, transferFunction2d = null } = attributes;
    const shading = attributes.shading ?? this.#chosen.shading;
    return [
      ...(transferFunction2d === null ? [] : [writeAttribute('transfer-function-2d', transferFunction2d)]),
      ...(transferFunction2d !== null && transferFunction === null
        ? []
        : [writeAttribute('transfer-function', transferFunction ?? writeTransferFunction(stops))]),
      ...(opacityFactor === 1 ? [] : [writeAttribute('opacity-factor', String(opacityFactor))]),
      ...(lightFactor === 1 ? [] : [writeAttribute('light-factor', String(lightFactor))]),
      ...(shading ? [writeAttribute('shading', shading)] : []),
    ].join(' ');
  }

  #begin(view: EditedView, optics: Optics, attributes: Appearance): void {
    this.#stop();
    const { transferFunction, patches = [], opacityFactor, lightFactor, shading = 'unlit' } = optics;
    const isChosen = opacityFactor !== (attributes.opacityFactor ?? 1);
    this.#chosen = {
      ...(isChosen ? { opacityFactor } : {}),
      ...(shading === (attributes.shading ?? 'unlit') ? {} : { shading }),
    };
    this.#view = view;
    this.#known = attributes;
    this.#look = {
      stops: simplifyStops(transferFunction, maxHandles),
      patches,
      opacityFactor,
      lightFactor,
      attributes,
    };
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
    this.#look = { ...this.#look, ...change, attributes: { ...this.#look.attributes, ...this.#chosen, ...attributes } };
    if (this.#frame === 0) this.#frame = requestAnimationFrame(() => this.#write('input'));
  }

  #go(appearance: Look): void {
    if (appearance === this.#look) return;
    this.#look = appearance;
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
