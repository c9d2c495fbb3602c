// @cornerstonejs/codec-charls has no types. Source: its bindings, packages/charls/src/jslib.cpp

/** What Emscripten's start takes, of which this is used. */
interface CharlsOptions {
  /** Gives it an instance of the library, so that it does not look for its file. */
  readonly instantiateWasm?: (
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
  ) => object;
  print(text: string): void;
  printErr(text: string): void;
}

interface CharlsDecoder {
  /** Memory of the library, to which the packed bytes are written. */
  getEncodedBuffer(bytes: number): Uint8Array;
  /** Throws where they are damaged. */
  decode(): void;
  /** Memory of the library: bytes, or little-endian words of two. */
  getDecodedBuffer(): Uint8Array;
  delete(): void;
}

interface CharlsModule {
  readonly JpegLSDecoder: new () => CharlsDecoder;
}

declare module '@cornerstonejs/codec-charls/decodewasmjs' {
  export default function start(options: CharlsOptions): Promise<CharlsModule>;
}

declare module '@cornerstonejs/codec-charls/decodewasm?url&inline' {
  /** A `data:` URL. */
  const url: string;
  export default url;
}

/** charls-wasm.ts with all that it imports. */
declare module 'built:charls-wasm' {
  export function startCharls(options: CharlsOptions): Promise<CharlsModule>;
}
