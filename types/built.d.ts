// Modules that scripts/build.mjs makes: their imports are in files that only a build contains.

/** The worker with all readers, and without large libraries, as one classic script. */
declare module 'built:worker' {
  export const text: string;
}

/** The same with large libraries, which few files need. */
declare module 'built:whole-worker' {
  export const text: string;
}

/** The worker without the modules that are imported as `#rare/…`. */
declare module 'built:usual-worker' {
  export const text: string;
}

/** x3dom's own script. */
declare module 'built:x3dom' {
  export const text: string;
}

/** culori.ts with all that it imports. */
declare module 'built:culori' {
  export * from 'culori/fn';
}

/** mediabunny.ts with all that it imports. */
declare module 'built:mediabunny' {
  export * from 'mediabunny';
}
