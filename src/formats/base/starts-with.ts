/** Whether bytes begin with a signature, a string of one character per byte. */
export function startsWith(bytes: Uint8Array, signature: string): boolean {
  return bytes.length >= signature.length && Array.from(signature).every((c, i) => bytes[i] === c.charCodeAt(0));
}
