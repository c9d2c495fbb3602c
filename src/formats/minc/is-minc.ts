/** Whether an HDF5 file is MINC 2: the name of its one group is near its start. */
export function isMinc(bytes: Uint8Array): boolean {
  return new TextDecoder('latin1').decode(bytes.subarray(0, 2 ** 16)).includes('minc-2.0');
}
