import { nothing } from 'lit';
import type { LitElement } from 'lit';

/** A part of an element that the element draws inside itself. */
export interface DrawnPart {
  render(): unknown;
  dispose(): void;
}

/**
 * A part of an element whose code is loaded when the element first needs it. If the code can't be loaded, the element works without this
 * part.
 */
export class LazyPart {
  #part: DrawnPart | null = null;
  #isWanted = false;

  constructor(
    readonly host: LitElement,
    readonly load: () => Promise<DrawnPart>,
  ) {}

  /** Load the part when it has something to show, and drop it when it has nothing. */
  follow(wanted: boolean): void {
    if (wanted === this.#isWanted) return;
    this.#isWanted = wanted;
    if (wanted) void this.#bring();
    else this.#drop();
  }

  async #bring(): Promise<void> {
    const part = await this.load().catch(() => null);
    if (!part)
      return console.warn(
        'volume-view: the controls could not be loaded; check that all files of the package are on the server',
      );
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
