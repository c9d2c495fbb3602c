export const x3domUrl: string = new URL('../../node_modules/x3dom/x3dom.js', import.meta.url).href;
