/** What Emscripten hands over, so that others instantiate its module. */
export type InstantiateWasm = (
  imports: WebAssembly.Imports,
  receive: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
) => object;

/**
 * Compiles a library once for all loads of a worker: each load has an instance and memory of its own, which take little time.
 * @param url - `data:` URL of the library's bytes
 * @returns starts an instance, by what Emscripten calls its start
 */
export function compileOnce(url: string): <T>(start: (instantiateWasm: InstantiateWasm) => Promise<T>) => Promise<T> {
  let compiled: Promise<WebAssembly.Module> | undefined;
  return async (start) => {
    compiled ??= WebAssembly.compile(bytesOf(url));
    const module = await compiled;
    return new Promise((resolve, reject) => {
      // Emscripten would wait for an instance that does not come.
      start((imports, receive) => {
        WebAssembly.instantiate(module, imports).then((instance) => receive(instance, module), reject);
        return {};
      }).then(resolve, reject);
    });
  };
}

function bytesOf(url: string): Uint8Array<ArrayBuffer> {
  const text = atob(url.slice(url.indexOf(',') + 1));
  return Uint8Array.from(text, (byte) => byte.charCodeAt(0));
}
