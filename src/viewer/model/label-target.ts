import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import type { Volume } from '../../volume/volume.ts';
import type { ReportedFile } from './file-notices.ts';
import type { ViewLabels } from './view-labels.ts';

/** The target of something that is attached to a volume. */
export interface AttachmentTarget {
  /** The last good volume; null before there is one. */
  readonly volume: Volume | null;
  /** Whether a volume is loading, or would load if there were one: the picture is near enough to be visible soon. */
  readonly awake: boolean;
  /** Add work that scripts wait for when they wait for the picture. It does not reject. */
  track(work: Promise<unknown>): void;
  /** Fetches its files instead of the browser, where the page has set such a function for the volume. */
  readonly fetch?: typeof globalThis.fetch | null;
  failed(error: unknown): void;
  cleared(): void;
  /** Report to the people who see the picture which parts of its files are not in it; empty where all are. */
  reportFiles(files: readonly ReportedFile[]): void;
}

/** The target of labels. */
export interface LabelTarget extends AttachmentTarget {
  /** The file of that volume, for messages. */
  readonly file: string;
  /** Data values that presets and percentages span; null before there is a volume. */
  readonly window: readonly [number, number] | null;
  /** Whether hidden labels can stay faintly visible, as ghosts. */
  readonly showsGhosts: boolean;
  /** Show labels; null for none. @throws {VolumeViewError} */
  show(labels: ViewLabels | null): Promise<void>;
  /** Set the appearance of a volume that is itself labels, where its page gives none; null to derive it from the values. */
  replaceTransferFunction(transferFunction: TransferFunction | null): void;
  /** Show a volume's values as labels, after they were read as intensities. @throws {VolumeViewError} */
  takeAsLabels(volume: Volume): Promise<void>;
}
