/** What of a ray's values is shown, instead of emission and absorption. */
export type ProjectionKind = 'max' | 'min' | 'average';


/** Whether the surfaces that a field has everywhere are lit. */
export type Shading = 'lit' | 'unlit';

export const shadings: readonly Shading[] = ['lit', 'unlit'];

export const projectionKinds: readonly ProjectionKind[] = ['max', 'min', 'average'];
