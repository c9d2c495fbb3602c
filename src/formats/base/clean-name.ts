/** Maximum length of a name. */
const longest = 200;

/** A stranger's name in one line, without control characters. */
export function cleanName(text: string): string {
  return Array.from(text.replace(/[\p{Cc}\p{Zl}\p{Zp}\s]+/gu, ' '))
    .slice(0, longest)
    .join('');
}
