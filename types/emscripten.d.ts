/** What Emscripten's start of a library takes, of which this is used. */
interface EmscriptenOptions {
  /** Gives it an instance of the library, so that it does not look for its file. */
  readonly instantiateWasm?: (
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
  ) => object;
  print(text: string): void;
  printErr(text: string): void;
}

/** A decoder of @cornerstonejs, of which none has types. */
interface EmscriptenDecoder {
  /** Memory of the library, to which the packed bytes are written. */
  getEncodedBuffer(bytes: number): Uint8Array;
  /** Throws where they are damaged. */
  decode(): void;
  /** Memory of the library: row by row, all components of a pixel together, in bytes or little-endian words of two. */
  getDecodedBuffer(): Uint8Array;
  delete(): void;
}
