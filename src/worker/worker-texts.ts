/**
 * The worker's text, in the builds that contain it: worker-texts-classic.ts and worker-texts-for-bundlers.ts. The first one that can read
 * the file is used.
 * @param _url - of the file
 */
export const listWorkerTexts = (_url: string): readonly (() => Promise<string>)[] => [];
/** Whether the text is tried before the worker's file. @param _url - of the worker's file */
export const isTextSurer = (_url?: string): boolean => false;
