/** Starts a library that Emscripten made. In Node it asks for its folder, which it does not need: its bytes are given. */
export async function startLibrary<T>(start: () => Promise<T>): Promise<T> {
  const isNode = !('__dirname' in globalThis) && 'process' in globalThis;
  if (isNode) Reflect.set(globalThis, '__dirname', '');
  try {
    return await start();
  } finally {
    if (isNode) Reflect.deleteProperty(globalThis, '__dirname');
  }
}

/** Options of a library, which it makes its own: nothing that it prints is shown. */
export const beSilent = (): { print: () => void; printErr: () => void } => ({
  print: () => undefined,
  printErr: () => undefined,
});

/** Whether a module without content can be compiled: a policy without 'wasm-unsafe-eval' refuses all. */
export function mayCompile(): boolean {
  try {
    return new WebAssembly.Module(Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0)) instanceof WebAssembly.Module;
  } catch {
    return false;
  }
}

/** Gives the memory of a decoder back. */
export function release(decoder: { delete(): void }): void {
  try {
    decoder.delete();
  } catch {
    // A library that has ended by itself has nothing to release.
  }
}
