/** Bytes that bricks of a page may take on the GPU, and on small devices. */
const [usual, onSmall] = [2 ** 28, 2 ** 27];

/** Gibibytes of the memory of a small device. */
const smallDevice = 4;

/** GiB, at most 8 and only in some browsers. Source: W3C, Device Memory. */
const isSmall = (): boolean =>
  ((globalThis.navigator ?? {}) as { readonly deviceMemory?: number }).deviceMemory! <= smallDevice;

/** What the bricks of a page may take on the GPU, if its author does not say it. */
export const usualGpuBytes = (): number => (isSmall() ? onSmall : usual);

/** Bytes of unpacked chunks that the worker keeps. */
export const chooseKeptBytes = (): number => (isSmall() ? 2 ** 26 : 2 ** 27);

/** The share of them that the chunks of one brick may need. */
export const shareOfBrick = 1 / 4;

/** Bricks that are read at once: browsers open about as many connections to one server. */
export const bricksAtOnce = 8;
