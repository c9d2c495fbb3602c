import { asVolumeViewError } from '../../src/core/errors.ts';
import type { VolumeViewError } from '../../src/core/errors.ts';
import { childrenOf, hostOf } from '../../src/page/page-children.ts';
import { ReflectingElement } from './reflecting-element.ts';
import { tell } from './volume-view-events.ts';

/** Loads what such an element asks for, and puts it there. */
interface Keeper<Target> {
  refresh(): void;
  leave(target: Target): void;
}

/** An element that puts something beside the volume of the element around it. It follows that one's volumes, and takes what it put there along. */
export abstract class BesideElement<Target> extends ReflectingElement {
  #around: HTMLElement | null = null;
  #target: Target | null = null;
  #stay = new AbortController();

  protected abstract readonly keeper: Keeper<Target>;

  /** Why it can't be there; null where it can. */
  protected abstract refuse(around: HTMLElement | null): VolumeViewError | null;

  /** @param around - defined by now @param stay - ends when this element leaves it */
  protected abstract join(around: HTMLElement, stay: AbortSignal): Target;

  /** It has taken along what it had put there. */
  protected left(_around: HTMLElement): void {}

  /** Where it puts something; null while it is nowhere. */
  protected get target(): Target | null {
    return this.#target;
  }

  /** The file that it asks for, for messages. */
  protected get file(): string {
    return this.readText('src') ?? '';
  }

  override connectedCallback(): void {
    super.connectedCallback();
    const around = hostOf(this) ?? this.parentElement;
    if (around !== this.#around) void this.#enter(around);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    // Being moved within the page takes it out and puts it back at once, often with the element around it.
    queueMicrotask(() => {
      if (!this.isConnected) this.#leave();
    });
  }

  /** The view around it has begun anew in another document. */
  override adoptedCallback(): void {
    super.adoptedCallback();
    this.#leave();
  }

  protected override updated(_changed: ReadonlyMap<PropertyKey, unknown>): void {
    this.keeper.refresh();
  }

  /** It is drawn by the element around it, and has nothing to show of its own. */
  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  protected tellError(thrown: unknown): void {
    const { code, message, cause } = asVolumeViewError(thrown, `${this.localName} of "${this.file}"`);
    tell(this, 'error', { code, message, cause });
  }

  async #enter(around: HTMLElement | null): Promise<void> {
    this.#leave();
    this.#around = around;
    const { signal } = (this.#stay = new AbortController());
    const problem = this.refuse(around);
    if (problem) {
      console.warn(problem.message); // There is no picture in which it could stand.
      return this.tellError(problem);
    }
    await customElements.whenDefined(around!.localName);
    if (signal.aborted || !this.isConnected) return;
    this.#target = this.join(around!, signal);
    around!.addEventListener('load', () => this.keeper.refresh(), { signal });
    this.keeper.refresh();
  }

  #leave(): void {
    this.#stay.abort();
    const [around, target] = [this.#around, this.#target];
    this.#around = null;
    this.#target = null;
    if (!target) return;
    this.keeper.leave(target);
    if (around!.contains(this)) return;
    this.left(around!);
    // Where only one can be, the next one takes its place.
    const [next] = childrenOf(around!, this.localName);
    if (next instanceof BesideElement && !next.#target) void next.#enter(around);
  }
}
