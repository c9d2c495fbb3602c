import { invalidAttribute } from '../../core/errors.ts';
import type { Volume } from '../../volume/volume.ts';
import type { WindowSetting } from '../model/parse-attributes.ts';

/**
 * The values of black and white that an attribute says: by numbers, or by the name or number of a window of the file.
 * @throws {VolumeViewError} `attribute/invalid` where the file has no such window
 */
export function findWindow<None extends null>(
  given: WindowSetting | None,
  { windows = [] }: Pick<Volume, 'windows'>,
): readonly [number, number] | None {
  if (given === null || typeof given !== 'string') return given;
  const word = given.trim().toLowerCase();
  const found = windows.find(({ name }, i) => name.toLowerCase() === word || String(i + 1) === word);
  if (!found) throw invalidAttribute('value-window', given, `two numbers, like "-150 250"${describe(windows)}`);
  return [found.from, found.to];
}

function describe(windows: NonNullable<Volume['windows']>): string {
  if (windows.length === 0) return '; a name or number stands for a window of the file, and this file has none';
  return `, or a window of the file: ${windows.map(({ name }, i) => `${i + 1} or ${name}`).join(', ')}`;
}
