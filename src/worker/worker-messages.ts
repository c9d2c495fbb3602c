import type { ErrorCode } from '../core/errors.ts';
import type { Surface } from '../volume/surface.ts';
import type { Volume } from '../volume/volume.ts';
import type { ScanTimes } from '../formats/base/choose-scan.ts';
import type { ScanData } from '../formats/base/scan-data.ts';
import type { CoarseVolume, DeviceLimits, LoadProgress, LoadRequest } from '../formats/base/load-request.ts';
import type { BricksRequest } from './brick-messages.ts';
import type { SurfaceRequest } from './surface-request.ts';

/** The first message of a load to the worker, which must have no other order. */
export interface WorkerOrder {
  readonly request: Omit<LoadRequest, 'limits'> | SurfaceRequest | BricksRequest;
  readonly pageOrigin: string;
  /** To the page, where it fetches by a function of its own. */
  readonly port?: MessagePort;
}

/** The second message: the limits, which become known a little later. */
export interface WorkerLimits {
  readonly limits: DeviceLimits;
}

/** The load was given up: the worker stops what it does for it. */
export interface WorkerStop {
  readonly stop: true;
}

/**
 * Messages from the worker: 'ready' once, then for each order progress, scans and a coarse volume, and one of the others
 * last.
 */
export type WorkerReport =
  | { readonly type: 'ready' }
  | { readonly type: 'progress'; readonly progress: LoadProgress }
  | { readonly type: 'scans'; readonly times: ScanTimes; readonly data?: readonly ScanData[] }
  | { readonly type: 'coarse'; readonly coarse: CoarseVolume | null }
  | { readonly type: 'done'; readonly volume: Volume | Surface }
  | { readonly type: 'failed'; readonly code: ErrorCode; readonly message: string; readonly cause?: string }
  | { readonly type: 'needs-main-thread' };

/** To a stop the worker answers 'stopped', when it has no order any longer. */
export type WorkerAnswer = WorkerReport | { readonly type: 'stopped' };

/** Sends a report of an order. */
export type Report = (message: WorkerReport, transfer?: Transferable[]) => void;
