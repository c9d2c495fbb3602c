// Messages about a pyramid that is read in bricks, over a port of its own: several share a worker.
import type { BrickSamples } from '../bricks/brick-data.ts';
import type { Brick } from '../bricks/pyramid.ts';
import type { ResidualTable } from '../bricks/residuals.ts';
import type { ErrorCode } from '../core/errors.ts';
import type { BrickStore } from '../formats/base/brick-store.ts';
import type { LoadRequest } from '../formats/base/load-request.ts';

/** Opens a pyramid, as the ordinary volume is loaded. */
export interface BricksRequest extends Omit<LoadRequest, 'limits' | 'finer'> {
  /** The worker's end. */
  readonly bricks: MessagePort;
  /** Of the ordinary volume: data value = slope * sample + intercept. */
  readonly scaling?: { readonly slope: number; readonly intercept: number };
}

/** To the worker. */
export type BricksOrder =
  | { readonly id: number; readonly brick: Brick; readonly isAlone?: boolean }
  | { readonly id: number; readonly residuals: true }
  /** The order of this number is given up. */
  | { readonly id: number; readonly stop: true }
  /** The last message. */
  | { readonly close: true };

export interface BricksFailure {
  /** Undefined for an order that was given up. */
  readonly code?: ErrorCode;
  readonly message: string;
}

/** What is known of a pyramid once it is open. */
export type OpenedBricks = Pick<BrickStore, 'side' | 'type' | 'slope' | 'intercept' | 'levels'>;

/** To the page: first whether it could be opened (null for what is not read in bricks), then an answer to each order. */
export type BricksAnswer =
  | { readonly opened: OpenedBricks | null }
  | { readonly failed: BricksFailure }
  | { readonly id: number; readonly brick: BrickSamples }
  | { readonly id: number; readonly residuals: ResidualTable | null }
  | { readonly id: number; readonly failure: BricksFailure };
