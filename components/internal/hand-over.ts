/** Only the scripts in dist that a page loads as modules hand over to another address: see hand-over-dist.ts. */
export const handOver = (_name: string): boolean => false;
