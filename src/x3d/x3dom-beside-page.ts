/** Replaces x3dom-url.ts in bundlers that would treat x3dom as a module: the field `alias` of package.json. */
export const findX3domUrl = (): string => './x3dom.js';
