/**
 * What of a file is not shown, in words, as a volume carries it; nothing where all is.
 * @param volumes - that the file holds, of which the first is shown
 * @param rest - what else is left out; those that are null are not
 */
export function listLeft(volumes: number, ...rest: readonly (string | null)[]): { readonly left?: readonly string[] } {
  const more = volumes > 1 ? (volumes > 2 ? `volumes 2 to ${volumes} of the file` : 'volume 2 of the file') : null;
  const left = [more, ...rest].filter((one) => one !== null);
  return left.length > 0 ? { left } : {};
}
