/** Maximum number of substeps of a step; each end of a substep is a sample. */
export const maxSubsteps = 8;

/**
 * Substeps of a step on which everything is visible. If the opacity of a voxel is w, its cube root times this gives the
 * smallest error for the samples taken: the error of a substep grows with w and with the square of its length.
 */
export const substepsPerRoot = 28;

/** Texels of the table of substeps, see optics/transfer/substep-table.ts */
export const substepTableSize = { columns: 256, rows: 32 } as const;

/** Share of the transfer function's domain that the table covers. Beyond it, no nearby value changes anything. */
export const substepTableDomain = { from: -0.25, to: 1.25 } as const;
