// In place of charls-wasm.ts, in the modules for bundlers: the library is CommonJS, and names modules of Node.
export * from 'built:charls-wasm';
