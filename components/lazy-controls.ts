import { nothing } from 'lit';
import type { ViewControls } from './view-controls.ts';
import type { ControlledView } from './controlled-view.ts';

/** The controls of an element, its marker among them, which are loaded when it first has some. Without them the picture is what it is. */
export class LazyControls {
  #controls: ViewControls | null = null;
  #isWanted = false;

  constructor(readonly view: ControlledView, readonly hand: ViewControls['hand']) {}

  /** Attributes that ask for some are there, or they are not. */
  follow(wanted: boolean): void {
    if (wanted === this.#isWanted) return;
    this.#isWanted = wanted;
    if (wanted) void this.#load();
    else this.#drop();
  }

  async #load(): Promise<void> {
    const part = await import('./view-controls.ts').catch(() => null);
    if (!part) return console.warn('volume-view: the controls could not be loaded; check that all files of the package are on the server');
    if (!this.#isWanted || this.#controls) return;
    this.#controls = new part.ViewControls(this.view, this.hand);
    this.view.requestUpdate();
  }

  #drop(): void {
    this.#controls?.dispose();
    this.#controls = null;
    this.view.requestUpdate();
  }

  render(): unknown {
    return this.#controls?.render() ?? nothing;
  }
}
