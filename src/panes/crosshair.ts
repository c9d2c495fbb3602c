import type { Vector3 } from '../volume/matrix.ts';

/** The common point of several panes, and the windows of the volumes in them. A change in one pane is shown in all. */
export class Crosshair {
  #place: Vector3 | null = null;
  readonly #windows = new WeakMap<object, readonly [number, number]>();
  readonly #listeners = new Set<() => void>();

  /** World coordinates; null before a volume is loaded. */
  get place(): Vector3 | null {
    return this.#place;
  }

  moveTo(place: Vector3): void {
    if (String(place) === String(this.#place)) return;
    this.#place = place;
    this.#notify();
  }

  /** Data values of black and white that a person has chosen for a volume; null for the page's own. */
  windowOf(volume: object): readonly [number, number] | null {
    return this.#windows.get(volume) ?? null;
  }

  setWindow(volume: object, window: readonly [number, number] | null): void {
    if (window) this.#windows.set(volume, window);
    else this.#windows.delete(volume);
    this.#notify();
  }

  /** @returns a function that removes the listener */
  listen(changed: () => void): () => void {
    this.#listeners.add(changed);
    return () => this.#listeners.delete(changed);
  }

  #notify(): void {
    for (const changed of this.#listeners) changed();
  }
}

const byName = new Map<string, WeakRef<Crosshair>>();
const byOwner = new WeakMap<object, Crosshair>();

/** The crosshair of a group of panes. Panes without a group name share the crosshair of their owner. */
export function findCrosshair(group: string | null, owner: object): Crosshair {
  const found = group === null ? byOwner.get(owner) : byName.get(group)?.deref();
  if (found) return found;
  const crosshair = new Crosshair();
  if (group === null) byOwner.set(owner, crosshair);
  else byName.set(group, new WeakRef(crosshair));
  return crosshair;
}
