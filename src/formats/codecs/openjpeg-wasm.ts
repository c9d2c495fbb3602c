import start from '@cornerstonejs/codec-openjpeg/decodewasmjs';
import url from '@cornerstonejs/codec-openjpeg/decodewasm?url&inline';
import { compileOnce } from './compile-once.ts';

const startInstance = compileOnce(url);

/** Starts OpenJPEG as WebAssembly, whose bytes are in this module: no bundler, server or policy has to know of a further file. */
export function startOpenJpeg(options: EmscriptenOptions): Promise<OpenJpegModule> {
  return startInstance((instantiateWasm) => start({ ...options, instantiateWasm }));
}
