/** Whether a text is the start of an AFNI header. */
export function isAfniHeader(text: string): boolean {
  return /^type\s*=\s*(?:string|integer|float)-attribute\s/.test(text);
}
