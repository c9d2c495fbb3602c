import type { AttachmentTarget } from '../model/label-target.ts';

/** The element that owns the attachment. */
export interface AttachmentHost<Target extends AttachmentTarget> {
  /** null while the element is in no page. */
  target(): Target | null;
  failed(error: unknown): void;
}

/** Shows something that is attached to a volume in the picture. The last request counts, and an error leaves the last good state. */
export abstract class AttachmentController<Target extends AttachmentTarget, Host extends AttachmentHost<Target>> {
  #run = new AbortController();

  constructor(readonly host: Host) {}

  /** Load and show the present request. */
  refresh(): void {
    this.#run.abort();
    const { signal } = (this.#run = new AbortController());
    const target = this.host.target();
    if (!target || (!target.volume && !target.awake)) return; // What is far away is loaded together with its volume.
    target.track(
      this.read(target, signal).catch((error: unknown) => {
        if (signal.aborted) return;
        this.unread(target);
        this.fail(error);
      }),
    );
  }

  /** The element has left its page. @param target - its former target */
  leave(target: Target): void {
    this.#run.abort();
    this.forget(target);
    target.cleared();
    target.reportFiles([]);
  }

  /** @param signal - aborted when the request is replaced */
  protected abstract read(target: Target, signal: AbortSignal): Promise<void>;

  /** Remove it from the target, and stop all work. */
  protected abstract forget(target: Target): void;

  /** The request has failed: remove what would be wrong on the present volume. */
  protected unread(_target: Target): void {}

  protected fail(error: unknown): void {
    this.host.target()?.failed(error);
    this.host.failed(error);
  }
}
