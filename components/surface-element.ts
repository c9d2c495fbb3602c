import { asVolumeViewError } from '../src/errors.ts';
import { SurfaceKeeper } from '../src/viewer/surface-keeper.ts';
import type { WantedSurface } from '../src/viewer/surface-attributes.ts';
import { noSurfaceTarget, SurfaceTarget } from '../src/viewer/surface-target.ts';
import type { Surface } from '../src/volume/surface.ts';
import type { Volume } from '../src/volume/volume.ts';
import type { VolumeHolder } from './held-volume.ts';
import { ReflectingElement } from './reflecting-element.ts';
import { tell } from './volume-view-events.ts';

/** An element that puts a surface into the scene of the `<volume-view>` around it. */
export abstract class SurfaceElement extends ReflectingElement {
  #view: HTMLElement | null = null;
  #target: SurfaceTarget | null = null;
  readonly #keeper = new SurfaceKeeper({
    localName: this.localName,
    wanted: (volume) => (this.hasAttribute('hidden') ? null : this.readWanted((name) => this.readText(name), volume)),
    target: () => this.#target,
    came: (surface) => tell(this, 'load', this.describe(surface)),
    progress: ({ loaded, total, phase }) => tell(this, 'progress', { loaded, total, phase }),
    failed: (error) => this.#tellOf(error),
  });

  constructor() {
    super();
    new MutationObserver(() => this.requestUpdate()).observe(this, { attributes: true, attributeFilter: ['hidden'] });
  }

  /** What its attributes ask for. @throws {VolumeViewError} */
  protected abstract readWanted(read: (name: string) => string | null, volume: Volume | null): WantedSurface;

  /** What pages are told of a surface. */
  protected abstract describe(surface: Surface): unknown;

  /** What is shown. */
  protected get surface(): Surface | null {
    return this.#keeper.surface;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    if (this.parentElement !== this.#view) void this.#enter(this.parentElement);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    // Being moved within the page takes it out and puts it back at once, often with the element around it.
    queueMicrotask(() => {
      if (!this.isConnected) this.#leave();
    });
  }

  protected override updated(): void {
    this.#keeper.refresh();
  }

  /** It is drawn by the `<volume-view>`, and has nothing to show of its own. */
  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  async #enter(view: HTMLElement | null): Promise<void> {
    this.#leave();
    this.#view = view;
    if (view?.localName !== 'volume-view') return this.#refuse();
    await customElements.whenDefined(view.localName);
    if (this.#view !== view || !this.isConnected) return;
    this.#target = new SurfaceTarget((view as unknown as VolumeHolder)._presenter, this);
    view.addEventListener('load', this.#reload);
    this.#keeper.refresh();
  }

  #leave(): void {
    this.#view?.removeEventListener('load', this.#reload);
    const target = this.#target;
    this.#view = null;
    this.#target = null;
    if (target) this.#keeper.leave(target);
  }

  /** There is no picture in which an error could stand. */
  #refuse(): void {
    const error = noSurfaceTarget(this.localName);
    console.warn(error.message);
    this.#tellOf(error);
  }

  readonly #reload = (): void => this.#keeper.refresh();

  #tellOf(thrown: unknown): void {
    const { code, message, cause } = asVolumeViewError(thrown, `${this.localName} of "${this.readText('src') ?? ''}"`);
    tell(this, 'error', { code, message, cause });
  }
}
