import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import type { Volume } from '../../volume/volume.ts';
import type { ToldFile } from './beside-notices.ts';
import type { ViewLabels } from './view-labels.ts';

/** What something beside a volume is put on. */
export interface BesideTarget {
  /** The last good volume; null before there is one. */
  readonly volume: Volume | null;
  /** Whether a volume is being loaded, or would be: the picture is near enough to be seen soon. */
  readonly awake: boolean;
  /** Work that a script that waits for the picture has to wait for. It does not reject. */
  track(work: Promise<unknown>): void;
  failed(error: unknown): void;
  cleared(): void;
  /** What of its files is not in the picture, for those who look at it; empty where all is. */
  reportFiles(files: readonly ToldFile[]): void;
}

/** What labels are put on. */
export interface LabelTarget extends BesideTarget {
  /** The file of that volume, for messages. */
  readonly file: string;
  /** Data values that presets and percentages span; null before there is a volume. */
  readonly window: readonly [number, number] | null;
  /** Whether what is hidden can be seen as a trace. */
  readonly showsGhosts: boolean;
  /** Show labels; null for none. @throws {VolumeViewError} */
  wear(labels: ViewLabels | null): Promise<void>;
  /** How a volume looks that is labels itself, where its page says nothing; null for what its values suggest. */
  dress(transferFunction: TransferFunction | null): void;
  /** Show a volume's values as labels where they were taken for intensities. @throws {VolumeViewError} */
  takeAsLabels(volume: Volume): Promise<void>;
}
