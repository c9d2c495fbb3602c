// @cornerstonejs/codec-openjpeg has no types. Source: its bindings, packages/openjpeg/src/jslib.cpp

interface OpenJpegDecoder extends EmscriptenDecoder {
  getFrameInfo(): {
    readonly width: number;
    readonly height: number;
    readonly bitsPerSample: number;
    readonly componentCount: number;
    readonly isSigned: boolean;
  };
}

interface OpenJpegModule {
  readonly J2KDecoder: new () => OpenJpegDecoder;
}

declare module '@cornerstonejs/codec-openjpeg/decodewasmjs' {
  export default function start(options: EmscriptenOptions): Promise<OpenJpegModule>;
}

declare module '@cornerstonejs/codec-openjpeg/decode' {
  export default function start(options: EmscriptenOptions): Promise<OpenJpegModule>;
}

declare module '@cornerstonejs/codec-openjpeg/decodewasm?url&inline' {
  /** A `data:` URL. */
  const url: string;
  export default url;
}

/** openjpeg-wasm.ts with all that it imports. */
declare module 'built:openjpeg-wasm' {
  export function startOpenJpeg(options: EmscriptenOptions): Promise<OpenJpegModule>;
}
