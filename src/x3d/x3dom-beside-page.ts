/** Stands in for x3dom-url.ts where a bundler would take x3dom for a module: the field `alias` of package.json. */
export const findX3domUrl = (): string => './x3dom.js';
