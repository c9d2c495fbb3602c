/** Whether an address is that of a Zarr: a folder, one in it, or an archive of one. */
export const isZarr = (url: string): boolean => /\.(zarr|ozx)([/?#]|$)/.test(url);
