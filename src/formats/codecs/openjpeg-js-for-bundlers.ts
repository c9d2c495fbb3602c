// In place of openjpeg-js.ts, in the modules for bundlers.
export * from 'built:openjpeg-js';
