/**
 * The colours of a volume of one slice: from black to white, and nothing shines through, as in a photograph. A slice is at least 20 reference lengths thick, so 0.08 % of what
 * is behind it is left; with more opacity, a layer in the same place would be pale.
 */
export const sliceStops = '0% black 30%, 100% white 30%';

/** The same of a slice of a CT, whose unit its file may not say: these words say it. */
export const ctSliceStops = '0% black 30%, 100% #fff 30%';

/** The same of a slice that has its own colours, in which they stay as they are. */
export const colorSliceStops = '0% white 30%, 100% white 30%';

/** Whether colours are those of a slice that is a picture in gray. */
export function isGraySlice(transferFunction: string | undefined): boolean {
  return transferFunction === sliceStops || transferFunction === ctSliceStops;
}
