// @cornerstonejs/codec-charls has no types. Source: its bindings, packages/charls/src/jslib.cpp

interface CharlsModule {
  readonly JpegLSDecoder: new () => EmscriptenDecoder;
}

declare module '@cornerstonejs/codec-charls/decodewasmjs' {
  export default function start(options: EmscriptenOptions): Promise<CharlsModule>;
}

declare module '@cornerstonejs/codec-charls/decodewasm?url&inline' {
  /** A `data:` URL. */
  const url: string;
  export default url;
}

/** charls-wasm.ts with all that it imports. */
declare module 'built:charls-wasm' {
  export function startCharls(options: EmscriptenOptions): Promise<CharlsModule>;
}
