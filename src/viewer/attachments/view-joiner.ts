import type { Crosshair } from '../../panes/crosshair.ts';
import type { CrosshairView, JoiningPane } from './crosshair-in-view.ts';

/**
 * Shows a pane's crosshair in the picture of the view to which the pane belongs. The code for this is loaded with the first such
 * pane; if it can't be loaded, the pane works without it.
 */
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
    import('./crosshair-in-view.ts')
      .then(({ joinView }) => {
        if (this.#joined === joined) this.#end = joinView(view as CrosshairView, { ...this.pane, crosshair });
      })
      .catch(console.warn);
  }

  leave(): void {
    this.#joined = null;
    this.#end();
    this.#end = () => {};
  }
}
