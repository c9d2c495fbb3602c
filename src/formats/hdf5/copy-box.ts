/** An array in memory: its bytes, and its lengths along the axes, slowest first. */
export interface Box {
  readonly bytes: Uint8Array;
  readonly shape: readonly number[];
}

/**
 * Copies one array into another.
 * @param start - where the source's first element goes along each axis of the target; elements beyond its edges are
 * left out
 */
export function copyBox(source: Box, target: Box, start: readonly number[], elementBytes: number): void {
  const last = target.shape.length - 1;
  if (last < 0) {
    target.bytes.set(source.bytes.subarray(0, elementBytes));
    return;
  }
  const copyAxis = (axis: number, sourceAt: number, targetAt: number): void => {
    const from = Math.max(0, -start[axis]);
    const to = Math.min(source.shape[axis], target.shape[axis] - start[axis]);
    if (axis === last) {
      if (to <= from) return;
      const begin = (sourceAt * source.shape[axis] + from) * elementBytes;
      const at = (targetAt * target.shape[axis] + start[axis] + from) * elementBytes;
      target.bytes.set(source.bytes.subarray(begin, begin + (to - from) * elementBytes), at);
      return;
    }
    for (let i = from; i < to; i++)
      copyAxis(axis + 1, sourceAt * source.shape[axis] + i, targetAt * target.shape[axis] + start[axis] + i);
  };
  copyAxis(0, 0, 0);
}
