/** Where a pixel's ray ends: at a shape, or where it leaves the volume. */
export interface RayEnd {
  /** Grows with depth, and is linear in the pixel where the ends lie in a plane: -1 / depth, or depth in a parallel projection. */
  readonly place: number;
  /** Two places that differ by less are the same. */
  readonly slack: number;
  /** At a shape, within the volume or before it. */
  readonly isCut: boolean;
  /** The ray does not meet the volume. */
  readonly isMiss: boolean;
}

/** What ends of rays are told with. All lengths are bounding diameters. */
export interface EndScale {
  /** Depth of t = 0; null in a parallel projection. */
  readonly planeDepth: number | null;
  readonly stepLength: number;
}

/** Ends of rays that are nearer to each other than this share of a step are the same. */
export const endSlack = 1 / 16;

/** Nearer to the eye than this, in bounding diameters, nothing is told apart. */
export const nearestEnd = 1e-6;

/**
 * @param entry - where the ray would run if there were no shapes, t
 * @param surfaceT - where the nearest shape stands, t; Infinity where there is none
 * Twin: shaders/chunks/depth/depth-jumps.glsl
 */
export function rayEnd([entry, exit]: readonly [number, number], surfaceT: number, { planeDepth, stepLength }: EndScale): RayEnd {
  const t = Math.max(entry, Math.min(exit, surfaceT));
  const isCut = surfaceT < exit;
  const isMiss = !(entry < exit);
  const slack = endSlack * stepLength;
  if (planeDepth === null) return { place: t, slack, isCut, isMiss };
  const depth = Math.max(nearestEnd, planeDepth + t);
  return { place: -1 / depth, slack: slack / depth ** 2, isCut, isMiss };
}

/**
 * What the ends of a quad's rays say that the ends of the four known rays around do not. A shape only takes light away, so a
 * ray that ends nearer than these shows no more than they do.
 */
export const jumps = { none: 0, nearer: 0.5, farther: 1 } as const;

/** Ends at and around a quad of 2 x 2 pixels. */
export interface EndsAround {
  /**
   * Of the known rays: of the quad's own pixel at its lower left, and two pixels right of it, above it, and right above. On coarse
   * lattices lines and points end no rays.
   */
  readonly known: readonly [RayEnd, RayEnd, RayEnd, RayEnd];
  /** Of the quad's pixels: this one, right of it, above it, and right above. */
  readonly own: readonly [RayEnd, RayEnd, RayEnd, RayEnd];
}

/** Twin: shaders/chunks/depth/depth-jumps.glsl */
export function findJump({ known, own }: EndsAround): number {
  const all = [...known, ...own];
  if (!all.some(({ isCut, isMiss }) => isCut && !isMiss)) return jumps.none;
  if (all.some(({ isMiss }) => isMiss)) return jumps.farther;
  const [a, b, c, d] = known.map(({ place }) => place);
  const expected = [a, (a + b) / 2, (a + c) / 2, (a + b + c + d) / 4];
  const offs = own.map(({ place, slack }, i) => (place - expected[i]) / slack);
  if (offs.some((off) => off > 1)) return jumps.farther;
  return offs.some((off) => off < -1) ? jumps.nearer : jumps.none;
}

/**
 * Which of a quad's rays end at lines and points.
 * @param own - of its pixels; solid - where they would end without lines and points
 * @returns the sum of 1, 2, 4 and 8 for the pixel at its lower left, right of it, above it, and right above
 * Twin: shaders/chunks/depth/depth-jumps.glsl
 */
export function findThin(own: EndsAround['own'], solid: EndsAround['own']): number {
  return own.reduce((sum, { place, slack }, i) => sum + (solid[i].place - place > slack ? 2 ** i : 0), 0);
}

/** The brightest channel of the known pixels, 0..1, up to which they are black: what is seen there is no more than rounding. */
export const faint = 1.5 / 255;

/**
 * Whether a quad's pixels get rays because of shapes, whatever the curvature.
 * @param jump - of its ends, as bytes keep it
 * @param brightest - channel of the four known pixels, 0..1
 * Twin: shaders/chunks/walk/needs-rays.glsl
 */
export function needsRays(jump: number, brightest: number): boolean {
  return jump > (brightest > faint ? jumps.nearer / 2 : (jumps.nearer + jumps.farther) / 2);
}
