import type { OtherShapes } from './other-shapes.ts';
import type { StartedCanvas } from './start-canvas.ts';
import type { X3dom } from './x3dom-types.ts';

/** Loads the code for other shapes in a scene when the element gets its first X3D child, or when something needs it. */
export class OtherShapesLoader {
  #shapes: OtherShapes | null = null;
  #loading: Promise<void> | null = null;
  #disposed = false;
  readonly #observer: MutationObserver;

  constructor(
    readonly x3dom: X3dom,
    readonly started: StartedCanvas,
    readonly host: Element,
  ) {
    this.#observer = new MutationObserver(() => this.#look());
    this.#observer.observe(host, { childList: true, subtree: true });
    this.#look();
  }

  /** null if the scene holds only the volume, or the code is still being loaded. */
  get shapes(): OtherShapes | null {
    return this.#shapes;
  }

  /** Resolves when the code is loaded; at once if nothing is being loaded. */
  async ready(): Promise<void> {
    await this.#loading;
  }

  load(): Promise<void> {
    return (this.#loading ??= this.#load());
  }

  dispose(): void {
    this.#disposed = true;
    this.#observer.disconnect();
    this.#shapes?.dispose();
  }

  #look(): void {
    if ([...this.host.getElementsByTagName('*')].some((child) => this.x3dom.isX3DElement(child))) void this.load();
  }

  async #load(): Promise<void> {
    try {
      const { OtherShapes } = await import('./other-shapes.ts');
      if (this.#disposed) return;
      this.#observer.disconnect();
      this.#shapes = new OtherShapes(this.x3dom, this.started, this.host);
    } catch (error) {
      this.#loading = null; // The volume is shown without them, and the next child tries again.
      console.error(error);
    }
  }
}
