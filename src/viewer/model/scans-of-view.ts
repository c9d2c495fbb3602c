import type { LoadProgressListener } from '../../formats/base/load-request.ts';
import type { PlaceData, ScanData } from '../../formats/base/scan-data.ts';
import type { Volume } from '../../volume/volume.ts';

/** The scans of a view, where its source has several. */
export interface ScansOfView {
  readonly sources: readonly ScanSource[];
  /** The scan of this number, where it is in memory. */
  findKept(index: number): Volume | null;
  /**
   * Load a scan that is not to be shown, and do not keep it.
   * @param place - in its place the numbers of one place in several scans, of which it is the first
   * @throws as loadVolume does
   */
  loadAside(index: number, signal: AbortSignal, onProgress?: LoadProgressListener, place?: PlaceData): Promise<Volume>;
}

/** One of several scans: a file of its own, an entry of a manifest, or a volume of a file that holds several. */
export interface ScanSource {
  readonly url: string;
  /** All files of it, where it has several. */
  readonly files?: readonly string[];
  /** Its number in the manifest, or in the file. */
  readonly index?: number;
  /** ISO 8601, if it is known before the scan is loaded. */
  readonly time?: string | null;
  /** Where it lies in a file that holds several. */
  readonly data?: ScanData;
}
