/** @param low, high - values that may be there @param length - of what may be missed, reference lengths */
export type JumpDepth = (low: number, high: number, length: number) => number;
