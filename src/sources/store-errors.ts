import { VolumeViewError } from '../core/errors.ts';

/** A file is larger than a load may read. @param name - of the file */
export function refuseSize(name: string, bytes: number, maxBytes: number): VolumeViewError {
  const [has, max] = [bytes, maxBytes].map((count) => count.toLocaleString('en'));
  return new VolumeViewError('format/too-large', `${name} has ${has} bytes; expected at most ${max}`);
}
