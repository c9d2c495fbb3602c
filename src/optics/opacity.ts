/**
 * Opacity of a step from the opacity of a reference length: `1 - (1 - alpha)^ratio`, the Beer-Lambert law.
 * Written with log1p and expm1, so that it keeps its relative precision for opacities near 0.
 * @param alpha - opacity over the reference length, 0..1
 * @param ratio - step length / reference length (times the opacity factor), >= 0
 * @returns opacity over the step, 0..1; an opacity of 1 stays 1 over any length but 0
 * Source: paper.md, equation 1 as put right; Engel et al., *Real-Time Volume Graphics*, 2006, eq. 1.14
 */
export function correctOpacity(alpha: number, ratio: number): number {
  if (!(ratio > 0) || !(alpha > 0)) return 0;
  if (alpha >= 1) return 1;
  return -Math.expm1(ratio * Math.log1p(-alpha));
}

/** Extinction coefficient per reference length of an opacity: `-ln(1 - alpha)`; Infinity for opacity 1. */
export function extinction(alpha: number): number {
  return -Math.log1p(-alpha);
}
