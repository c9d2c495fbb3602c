import type { X3dom } from './x3dom-types.ts';

/** Injects x3dom's own text, or the file if that fails, in the builds that contain the text: x3dom-text-for-bundlers.ts. */
export const injectOwnText: ((url: string, inject: (url: string) => Promise<X3dom>) => Promise<X3dom>) | null = null;
