import { asVolumeViewError } from '../../src/core/errors.ts';
import type { VolumeViewError } from '../../src/core/errors.ts';
import { childrenOf, hostOf } from '../../src/page/page-children.ts';
import { ReflectingElement } from './reflecting-element.ts';
import { emit } from './volume-view-events.ts';

/** Loads what the attributes of such an element name, adds it to the target and removes it again. */
interface Controller<Target> {
  refresh(): void;
  leave(target: Target): void;
}

/**
 * An element that adds something to the volume of the element around it (its host). It follows the volumes of the host, and removes what it
 * added when it leaves.
 */
export abstract class AttachmentElement<Target> extends ReflectingElement {
  #around: HTMLElement | null = null;
  #target: Target | null = null;
  #stay = new AbortController();

  protected abstract readonly controller: Controller<Target>;

  /** The reason why the element can't be inside `around`; null where it can. */
  protected abstract refuse(around: HTMLElement | null): VolumeViewError | null;

  /** Join the host. @param around - the host, already defined @param stay - aborted when this element leaves the host */
  protected abstract join(around: HTMLElement, stay: AbortSignal): Target;

  /** Called after the element has left its host and removed what it had added. */
  protected left(_around: HTMLElement): void {}

  /** What the element adds something to; null while it has no host. */
  protected get target(): Target | null {
    return this.#target;
  }

  /** The file that `src` names, for error messages. */
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
    // Moving an element within the page disconnects it and connects it again at once, often together with its host.
    queueMicrotask(() => {
      if (!this.isConnected) this.#leave();
    });
  }

  /** The element is now in another document, where the view around it has started again. */
  override adoptedCallback(): void {
    super.adoptedCallback();
    this.#leave();
  }

  protected override updated(_changed: ReadonlyMap<PropertyKey, unknown>): void {
    this.controller.refresh();
  }

  /** The host draws what this element adds. The element itself shows nothing. */
  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  protected reportError(thrown: unknown): void {
    const { code, message, cause } = asVolumeViewError(thrown, `${this.localName} of "${this.file}"`);
    emit(this, 'error', { code, message, cause });
  }

  async #enter(around: HTMLElement | null): Promise<void> {
    this.#leave();
    this.#around = around;
    const { signal } = (this.#stay = new AbortController());
    const problem = this.refuse(around);
    if (problem) {
      console.warn(problem.message); // There is no picture in which the error could be shown.
      return this.reportError(problem);
    }
    await customElements.whenDefined(around!.localName);
    if (signal.aborted || !this.isConnected) return;
    this.#target = this.join(around!, signal);
    around!.addEventListener('load', () => this.controller.refresh(), { signal });
    this.controller.refresh();
  }

  #leave(): void {
    this.#stay.abort();
    const [around, target] = [this.#around, this.#target];
    this.#around = null;
    this.#target = null;
    if (!target) return;
    this.controller.leave(target);
    if (around!.contains(this)) return;
    this.left(around!);
    // Where a host takes only one such element, the next one replaces this one.
    const [next] = childrenOf(around!, this.localName);
    if (next instanceof AttachmentElement && !next.#target) void next.#enter(around);
  }
}
