/** Whether an address is that of a Zarr: a folder, one in it, or an archive of one. */
export const isZarr = (url: string): boolean => /\.(zarr(\.zip)?|ozx)([/?#]|$)/.test(url);
