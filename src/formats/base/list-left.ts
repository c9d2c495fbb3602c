/**
 * Says in words what part of a file is not shown, as a volume carries it; nothing if everything is shown.
 * @param volumes - number of volumes in the file; the first is shown
 * @param rest - what else is left out; null entries are ignored
 */
export function listLeft(volumes: number, ...rest: readonly (string | null)[]): { readonly left?: readonly string[] } {
  const more = volumes > 1 ? (volumes > 2 ? `volumes 2 to ${volumes} of the file` : 'volume 2 of the file') : null;
  const left = [more, ...rest].filter((one) => one !== null);
  return left.length > 0 ? { left } : {};
}
