/**
 * Give the worker's text, in the builds that carry it (scripts/build.mjs writes it here): the first that can read a file is to be taken.
 * @param _url - of the file
 */
export const listWorkerTexts = (_url: string): readonly (() => Promise<string>)[] => [];
/** Whether the text comes before the file. @param _url - of the worker's file */
export const isTextSurer = (_url?: string): boolean => false;
