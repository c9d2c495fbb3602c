// In place of openjpeg-js.ts, in the modules for bundlers: a worker that is a file has that library, and for others every app would build a
// megabyte of code more.
import { VolumeViewError } from '../../core/errors.ts';

export function startOpenJpeg(): Promise<OpenJpegModule> {
  return Promise.reject(
    new VolumeViewError(
      'format/unsupported',
      "JPEG 2000 needs WebAssembly, which the policy of this page does not allow; add 'wasm-unsafe-eval' to script-src of its Content-Security-Policy",
    ),
  );
}
