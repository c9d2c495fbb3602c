/** Gives the worker's text, in the builds that carry it: scripts/build.mjs writes it here. */
export const loadWorkerText: (() => Promise<string>) | null = null;
/** Whether the text comes before the file. @param _url - of the file */
export const isTextSurer = (_url?: string): boolean => false;
