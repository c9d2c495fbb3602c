import start from '@cornerstonejs/codec-openjpeg/decodewasmjs';
import url from '@cornerstonejs/codec-openjpeg/decodewasm?url&inline';

/** Starts OpenJPEG as WebAssembly, whose bytes are in this module: no bundler, server or policy has to know of a further file. */
export function startOpenJpeg(options: OpenJpegOptions): Promise<OpenJpegModule> {
  const text = atob(url.slice(url.indexOf(',') + 1));
  return start({ ...options, wasmBinary: Uint8Array.from(text, (byte) => byte.charCodeAt(0)) });
}
