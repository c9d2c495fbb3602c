// Files that are damaged, among others that are not.
import { VolumeViewError } from '../../core/errors.ts';
import { corruptFile } from '../base/file-problem.ts';

/** A damaged file, and why it can't be read. */
export interface Damage {
  /** 'file 12 of 300'. */
  readonly what: string;
  readonly error: VolumeViewError;
}

/**
 * What an error says of a file, where only this file is concerned.
 * @returns null for errors of another kind: the load was given up, or the file is in a form that is not read
 */
export function findDamage(error: unknown, what: string): Damage | null {
  if (error instanceof VolumeViewError) return error.code === 'format/corrupt' ? { what, error } : null;
  // The usual words for such an error have the name of the file.
  if (error instanceof RangeError || error instanceof TypeError)
    return { what, error: corruptFile(what, `can not be decoded (${error.message})`) };
  return null;
}

/** @throws the first error where most files are damaged: what is left would not be what was chosen */
export function checkDamage(damaged: readonly Damage[], files: number): void {
  if (damaged.length > 0 && 2 * damaged.length >= files) throw damaged[0].error;
}

/** What is said of damaged files. @param done - 'left out', as it was done with them */
export function describeDamage(damaged: readonly Damage[], done: string): string[] {
  if (damaged.length === 0) return [];
  const [{ what, error }, ...others] = damaged;
  const why = error.message.startsWith(`${what} `) ? error.message.slice(what.length + 1) : error.message;
  const more =
    others.length === 0 ? '' : `, and ${others.length.toLocaleString('en')} more file${others.length > 1 ? 's' : ''}`;
  return [`${what}${more}: damaged, and ${done} (${why})`];
}
