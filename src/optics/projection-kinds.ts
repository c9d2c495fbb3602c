/** What of a ray's values is shown, instead of emission and absorption. */
export type ProjectionKind = 'max' | 'min' | 'average';

export const projectionKinds: readonly ProjectionKind[] = ['max', 'min', 'average'];
