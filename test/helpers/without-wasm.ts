/** Runs a task as on a page whose policy does not allow WebAssembly. */
export async function withoutWasm<T>(task: () => Promise<T>): Promise<T> {
  const native = WebAssembly.Module;
  const refuse = function () {
    throw new WebAssembly.CompileError('refused by the policy');
  };
  WebAssembly.Module = refuse as unknown as typeof WebAssembly.Module;
  try {
    return await task();
  } finally {
    WebAssembly.Module = native;
  }
}
