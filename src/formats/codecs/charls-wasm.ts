import start from '@cornerstonejs/codec-charls/decodewasmjs';
import url from '@cornerstonejs/codec-charls/decodewasm?url&inline';
import { compileOnce } from './compile-once.ts';

const startInstance = compileOnce(url);

/** Starts CharLS as WebAssembly, whose bytes are in this module: no bundler, server or policy has to know of a further file. */
export function startCharls(options: EmscriptenOptions): Promise<CharlsModule> {
  return startInstance((instantiateWasm) => start({ ...options, instantiateWasm }));
}
