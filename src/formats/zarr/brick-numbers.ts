import type { BrickStore } from '../base/brick-store.ts';
import { hostIsLittleEndian, swapBytes } from '../base/number-types.ts';
import type { NumberType } from '../base/number-types.ts';
import type { Samples } from '../../volume/samples.ts';

/** How the numbers of a file become samples, the same for all bricks. */
export interface BrickNumbers extends Pick<BrickStore, 'type' | 'slope' | 'intercept'> {
  /** @param bytes - numbers in the file's byte order, which the function takes over; they begin at a multiple of 8 in their buffer */
  store(bytes: Uint8Array<ArrayBuffer>): Samples;
}

/** Data value = slope * sample + intercept. */
export interface Scaling {
  readonly slope: number;
  readonly intercept: number;
}

/**
 * Numbers of 8 and 16 bits are kept, signed ones shifted to unsigned. All others become floats.
 * @param scaling - of these floats: those of the ordinary volume, which is made for its range of values
 */
export function chooseBrickNumbers(type: NumberType, littleEndian: boolean, scaling: Scaling): BrickNumbers {
  const { bytesPerNumber: size, read } = type;
  const isSwapped = size > 1 && littleEndian !== hostIsLittleEndian;
  const viewOf = (bytes: Uint8Array<ArrayBuffer>): ReturnType<typeof read.view> => {
    if (isSwapped) swapBytes(bytes, size);
    return read.view(bytes);
  };
  if (size <= 2 && read.kind === 'integers') {
    const Store = size === 1 ? Uint8Array : Uint16Array;
    // As unsigned numbers they are the same bits, except the highest one.
    const isSigned = type.name.startsWith('int');
    const half = 2 ** (8 * size - 1);
    return {
      type: size === 1 ? 'uint8' : 'uint16',
      slope: 1,
      intercept: isSigned ? -half : 0,
      store(bytes) {
        viewOf(bytes);
        const samples = new Store(bytes.buffer, bytes.byteOffset, bytes.length / size);
        if (isSigned) for (let i = 0; i < samples.length; i++) samples[i] ^= half;
        return samples;
      },
    };
  }
  const { slope, intercept } = scaling;
  return {
    type: 'float32',
    slope,
    intercept,
    store: (bytes) =>
      Float32Array.from(viewOf(bytes) as ArrayLike<number | bigint>, (value) => {
        const number = Number(value);
        return Number.isFinite(number) ? (number - intercept) / slope : NaN;
      }),
  };
}
