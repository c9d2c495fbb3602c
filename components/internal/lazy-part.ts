import { nothing } from 'lit';
import type { LitElement } from 'lit';

/** What an element draws as a part of itself. */
export interface DrawnPart {
  render(): unknown;
  dispose(): void;
}

/** A part of an element that is loaded when it first has some of it. Without it the picture is what it is. */
export class LazyPart {
  #part: DrawnPart | null = null;
  #isWanted = false;

  constructor(readonly host: LitElement, readonly load: () => Promise<DrawnPart>) {}

  /** There is something for it to show, or there is not. */
  follow(wanted: boolean): void {
    if (wanted === this.#isWanted) return;
    this.#isWanted = wanted;
    if (wanted) void this.#bring();
    else this.#drop();
  }

  async #bring(): Promise<void> {
    const part = await this.load().catch(() => null);
    if (!part) return console.warn('volume-view: the controls could not be loaded; check that all files of the package are on the server');
    if (!this.#isWanted || this.#part) return part.dispose();
    this.#part = part;
    this.host.requestUpdate();
  }

  #drop(): void {
    this.#part?.dispose();
    this.#part = null;
    this.host.requestUpdate();
  }

  render(): unknown {
    return this.#part?.render() ?? nothing;
  }
}
