/** Gives x3dom's text, in the builds that carry it: scripts/build.mjs writes it here. */
export const loadX3domText: (() => Promise<string>) | null = null;
