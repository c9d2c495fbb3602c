/**
 * Extinction per reference length of an opacity per reference length: `-ln(1 - alpha)`; Infinity for opacity 1.
 * Over a length of `ratio` reference lengths the opacity then is `1 - exp(-extinction * ratio)`, which is
 * `1 - (1 - alpha)^ratio`.
 * Source: the Beer-Lambert law; paper.md, equation 1 as put right
 */
export function extinction(alpha: number): number {
  return -Math.log1p(-alpha);
}
