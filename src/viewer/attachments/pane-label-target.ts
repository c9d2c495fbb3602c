import { asVolumeViewError } from '../../core/errors.ts';
import type { VolumeViewError } from '../../core/errors.ts';
import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import { asLabels } from '../../volume/label-volume.ts';
import type { Volume } from '../../volume/volume.ts';
import type { FileNotices, ReportedFile } from '../model/file-notices.ts';
import { reportFileNotices } from '../model/report-notices.ts';
import type { LabelTarget } from './label-target.ts';

/** A pane with its own volume. */
export interface LabelledPane {
  readonly volume: () => Volume | null;
  readonly file: () => string;
  /** Its labels, or their settings, have changed. */
  changed(): void;
  /** Show another volume in place of its own. */
  take(volume: Volume): void;
}

/** Labels in a <volume-slice-view> with its own file. */
export class PaneTarget implements LabelTarget {
  readonly awake = true;
  /** Panes have no transfer functions of labels. */
  readonly window = null;
  readonly showsGhosts = false;
  /** The transfer function of a volume that is itself labels. */
  look: TransferFunction | null = null;
  /** The error of the labels. */
  error: VolumeViewError | null = null;
  /** What of the labels' file is not shown. */
  readonly fileNotices = new Map<object, readonly FileNotices[]>();
  #work: Promise<unknown> = Promise.resolve();

  constructor(readonly pane: LabelledPane) {}

  get volume(): Volume | null {
    return this.pane.volume();
  }

  get file(): string {
    return this.pane.file();
  }

  /** Resolves when all running work is done. */
  get done(): Promise<unknown> {
    return this.#work;
  }

  async show(): Promise<void> {
    this.pane.changed();
  }

  replaceTransferFunction(transferFunction: TransferFunction | null): void {
    this.look = transferFunction;
  }

  async takeAsLabels(volume: Volume): Promise<void> {
    this.pane.take(asLabels(volume));
  }

  track(work: Promise<unknown>): void {
    this.#work = Promise.all([this.#work, work]);
  }

  failed(error: unknown): void {
    this.error = asVolumeViewError(error, `labels of "${this.file}"`);
    this.pane.changed();
  }

  cleared(): void {
    if (!this.error) return;
    this.error = null;
    this.pane.changed();
  }

  reportFiles(files: readonly ReportedFile[]): void {
    reportFileNotices({ fileNotices: this.fileNotices, user: this.pane }, this, files);
  }
}
