#ifndef BRICKS
/// The distance of samples in a cell, in steps; code: of the cell, 4 more for each doubling of the voxels in a step; within: whole steps that are left in it;
/// power: uDetailPower, which is far below 0 where cells do not matter. Twin: optics/cells/min-substeps.ts
float spacingOf(float code, float power, float within) {
  float doublings = floor(0.25 * code + 0.1);
  float cuts = clamp(power + code - 4.0 * doublings, 0.0, 3.0) - (power < -4.5 ? 0.0 : doublings);
  if (cuts < -0.5) return max(1.0, min(cuts < -1.5 ? 4.0 : 2.0, within));
  return cuts < 0.5 ? 1.0 : cuts < 1.5 ? 0.5 : cuts < 2.5 ? 0.25 : 0.125;
}
#endif
