// In place of mediabunny.ts, in the modules for bundlers: it is a small part of a large package, which users of this one need not install.
export * from 'built:mediabunny';
