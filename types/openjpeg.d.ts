// @cornerstonejs/codec-openjpeg has no types. Source: its bindings, packages/openjpeg/src/jslib.cpp

/** What Emscripten's start takes, of which this is used. */
interface OpenJpegOptions {
  /** Gives it an instance of the library, so that it does not look for its file. */
  readonly instantiateWasm?: (
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
  ) => object;
  print(text: string): void;
  printErr(text: string): void;
}

interface OpenJpegDecoder {
  /** Memory of the library, to which the packed bytes are written. */
  getEncodedBuffer(bytes: number): Uint8Array;
  /** Throws a number where they are damaged. */
  decode(): void;
  getFrameInfo(): {
    readonly width: number;
    readonly height: number;
    readonly bitsPerSample: number;
    readonly componentCount: number;
    readonly isSigned: boolean;
  };
  /** Memory of the library: row by row, all components of a pixel together, in bytes or little-endian words of two. */
  getDecodedBuffer(): Uint8Array;
  delete(): void;
}

interface OpenJpegModule {
  readonly J2KDecoder: new () => OpenJpegDecoder;
}

declare module '@cornerstonejs/codec-openjpeg/decodewasmjs' {
  export default function start(options: OpenJpegOptions): Promise<OpenJpegModule>;
}

declare module '@cornerstonejs/codec-openjpeg/decode' {
  export default function start(options: OpenJpegOptions): Promise<OpenJpegModule>;
}

declare module '@cornerstonejs/codec-openjpeg/decodewasm?url&inline' {
  /** A `data:` URL. */
  const url: string;
  export default url;
}

/** openjpeg-wasm.ts with all that it imports. */
declare module 'built:openjpeg-wasm' {
  export function startOpenJpeg(options: OpenJpegOptions): Promise<OpenJpegModule>;
}
