import type { Vector3 } from '../../volume/matrix.ts';
import { numberTypes } from '../base/number-types.ts';

export type RawType = keyof typeof numberTypes;

/** What a manifest says about a file without a header. */
export interface RawLayout {
  readonly type: RawType;
  /** Low byte first if undefined. */
  readonly endian?: 'little' | 'big';
  /** Samples along i (fastest), j and k. */
  readonly dimensions: Vector3;
  /** Bytes before the samples, in each file; 0 if undefined. */
  readonly offset?: number;
}

export const rawTypes = Object.keys(numberTypes) as readonly RawType[];
