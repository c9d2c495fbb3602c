/**
 * Extinction per reference length for an opacity per reference length: `-ln(1 - alpha)`; Infinity for opacity 1.
 * Over a length of `ratio` reference lengths, the opacity is then `1 - exp(-extinction * ratio)`, which is
 * `1 - (1 - alpha)^ratio`.
 * Source: the Beer-Lambert law; paper.md, equation 1 as corrected there
 */
export function extinction(alpha: number): number {
  return -Math.log1p(-alpha);
}
