import { corruptFile } from './file-problem.ts';

/**
 * Checks the lengths of the axes that a header says.
 * @param what - for messages: 'the MGH header'
 * @param name - what the header calls them: 'dimensions'
 * @throws {VolumeViewError} `format/corrupt`
 */
export function checkLengths(what: string, name: string, lengths: readonly number[]): void {
  if (lengths.every((n) => Number.isSafeInteger(n) && n >= 1)) return;
  throw corruptFile(what, `got ${name} ${lengths.slice(0, 10).join(' x ')}; expected whole numbers from 1`);
}
