/** @param low, high - the range of values that may occur @param length - of what may be missed, in reference lengths */
export type JumpDepth = (low: number, high: number, length: number) => number;
