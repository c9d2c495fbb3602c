import type { BesideTarget } from '../model/label-target.ts';

/** The element that asks for it. */
export interface BesideHost<Target extends BesideTarget> {
  /** null while it is in no page. */
  target(): Target | null;
  failed(error: unknown): void;
}

/** Brings something beside a volume into the picture. What is asked for last counts, and what fails leaves the last good one. */
export abstract class BesideKeeper<Target extends BesideTarget, Host extends BesideHost<Target>> {
  #run = new AbortController();

  constructor(readonly host: Host) {}

  /** Load and show what is asked for now. */
  refresh(): void {
    this.#run.abort();
    const { signal } = (this.#run = new AbortController());
    const target = this.host.target();
    if (!target || (!target.volume && !target.awake)) return; // What is far away is loaded with its volume.
    target.track(this.read(target, signal).catch((error: unknown) => {
      if (signal.aborted) return;
      this.unread(target);
      this.fail(error);
    }));
  }

  /** The element has left its page. @param target - where it was */
  leave(target: Target): void {
    this.#run.abort();
    this.forget(target);
    target.cleared();
    target.reportFiles([]);
  }

  /** @param signal - of what is not asked for any more */
  protected abstract read(target: Target, signal: AbortSignal): Promise<void>;

  /** Nothing of it stays there, and nothing goes on. */
  protected abstract forget(target: Target): void;

  /** What is asked for could not be had: what would be wrong there is to go. */
  protected unread(_target: Target): void {}

  protected fail(error: unknown): void {
    this.host.target()?.failed(error);
    this.host.failed(error);
  }
}
