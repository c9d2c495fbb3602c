import type { Crosshair } from '../../panes/crosshair.ts';
import type { CrosshairView, JoiningPane } from './crosshair-in-view.ts';

/** Has a pane's crosshair shown in the picture of the view that it belongs to. What does so is loaded with the first; without it the pane is what it is. */
export class ViewJoiner {
  #joined: { readonly view: object | null; readonly crosshair: Crosshair } | null = null;
  #end = (): void => {};

  constructor(readonly pane: Omit<JoiningPane, 'crosshair'>) {}

  /** @param view - null where the pane stands alone */
  join(view: object | null, crosshair: Crosshair): void {
    if (this.#joined?.view === view && this.#joined.crosshair === crosshair) return;
    this.leave();
    const joined = (this.#joined = { view, crosshair });
    if (!view) return;
    import('./crosshair-in-view.ts').then(({ joinView }) => {
      if (this.#joined === joined) this.#end = joinView(view as CrosshairView, { ...this.pane, crosshair });
    }).catch(console.warn);
  }

  leave(): void {
    this.#joined = null;
    this.#end();
    this.#end = () => {};
  }
}
