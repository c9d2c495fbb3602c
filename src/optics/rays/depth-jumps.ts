/** Where a pixel's ray ends: at a shape, or where it leaves the volume. */
export interface RayEnd {
  /** Grows with depth. It is linear in the pixel if the ends lie in a plane: -1 / depth, or the depth itself in a parallel projection. */
  readonly place: number;
  /** Two places that differ by less count as the same. */
  readonly slack: number;
  /** Whether the ray ends at a shape, inside the volume or in front of it. */
  readonly isCut: boolean;
  /** Whether the ray does not meet the volume. */
  readonly isMiss: boolean;
}

/** The scale by which ends of rays are compared. All lengths are in bounding diameters. */
export interface EndScale {
  /** Depth of t = 0; null in a parallel projection. */
  readonly planeDepth: number | null;
  readonly stepLength: number;
}

/** Ends of rays count as the same if they are nearer to each other than this share of a step. */
export const endSlack = 1 / 16;

/** Nearer to the eye than this, in bounding diameters, depths are not distinguished. */
export const nearestEnd = 1e-6;

/**
 * @param entry - where the ray would begin without shapes, in t
 * @param surfaceT - t of the nearest shape; Infinity if there is none
 * Twin: shaders/chunks/depth/depth-jumps.glsl
 */
export function rayEnd(
  [entry, exit]: readonly [number, number],
  surfaceT: number,
  { planeDepth, stepLength }: EndScale,
): RayEnd {
  const t = Math.max(entry, Math.min(exit, surfaceT));
  const isCut = surfaceT < exit;
  const isMiss = !(entry < exit);
  const slack = endSlack * stepLength;
  if (planeDepth === null) return { place: t, slack, isCut, isMiss };
  const depth = Math.max(nearestEnd, planeDepth + t);
  return { place: -1 / depth, slack: slack / depth ** 2, isCut, isMiss };
}

/**
 * What the ends of a quad's rays show that the ends of the four known rays around it do not. A shape only takes light away, so a
 * ray that ends nearer than the known rays shows at most what they show.
 */
export const jumps = { none: 0, nearer: 0.5, farther: 1 } as const;

/** Ends of rays at a quad of 2 x 2 pixels, and around it. */
export interface EndsAround {
  /**
   * The ends of the known rays: of the quad's own pixel at its lower left, and of the pixels two to the right, two above, and both. On
   * coarse lattices, lines and points end no rays.
   */
  readonly known: readonly [RayEnd, RayEnd, RayEnd, RayEnd];
  /** The ends of the quad's pixels: lower left, lower right, upper left, upper right. */
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
 * @param own - ends of its pixels; solid - where they would end without lines and points
 * @returns the sum of 1 (lower left), 2 (lower right), 4 (upper left) and 8 (upper right) for these pixels
 * Twin: shaders/chunks/depth/depth-jumps.glsl
 */
export function findThin(own: EndsAround['own'], solid: EndsAround['own']): number {
  return own.reduce((sum, { place, slack }, i) => sum + (solid[i].place - place > slack ? 2 ** i : 0), 0);
}

/** If the brightest channel of the known pixels (0..1) is at most this, they count as black: what they show is only rounding. */
export const faint = 1.5 / 255;

/**
 * Whether a quad's pixels get rays because of shapes, whatever the curvature.
 * @param jump - of the ends of its rays, as it is stored in bytes
 * @param brightest - largest channel of the four known pixels, 0..1
 * Twin: shaders/chunks/walk/needs-rays.glsl
 */
export function needsRays(jump: number, brightest: number): boolean {
  return jump > (brightest > faint ? jumps.nearer / 2 : (jumps.nearer + jumps.farther) / 2);
}
