/**
 * What a scene makes the ray-caster do. Each is a 0/1 define of the composed shader; everything else is a uniform, and
 * changing a uniform compiles nothing.
 */
export interface ShaderFeatures {
  /** GLSL ES 3.00, else 1.00. */
  readonly webgl2: boolean;
  /** The volume is a 3D texture (WebGL 2 only), else a mosaic in a 2D texture. */
  readonly texture3d: boolean;
  /** The volume lies on a radar's polar grid, in 2D textures. */
  readonly polar: boolean;
  /** Rays of its sweeps have elevations of their own. */
  readonly radialElevations: boolean;
  /** 16-bit samples in two 8-bit channels. */
  readonly twoBytes: boolean;
  /** Some voxels hold no data. */
  readonly noData: boolean;
  /** Tri-linear interpolation by eight fetches, where the device's filter is absent or too coarse. */
  readonly filterInShader: boolean;
  /** The transfer function's table is interpolated by two fetches, where the device can't filter float textures. */
  readonly tableInShader: boolean;
  /** Rays end at the scene's opaque shapes. */
  readonly surfaces: boolean;
  /** Rays end at slices through a radar volume. */
  readonly slices: boolean;
  /** Quads of pixels may do without rays of their own; not where what ends rays at once, a shape or a slice, would be missed. */
  readonly adaptive: boolean;
}

/**
 * Whether a combination can occur: 3D textures need WebGL 2, and only the shader's own filter knows no data, which for
 * cartesian grids is told by floats alone. Polar grids always have some, and they alone have slices and rays.
 */
export function isLegal(features: ShaderFeatures): boolean {
  if (features.texture3d && !features.webgl2) return false;
  if (features.adaptive && (features.surfaces || features.slices)) return false;
  if ((features.slices || features.radialElevations) && !features.polar) return false;
  if (features.polar) return features.filterInShader && features.noData && !features.texture3d;
  if (features.noData && (!features.filterInShader || features.twoBytes)) return false;
  return true;
}

/** Everything off but the language. */
export function noFeatures(webgl2: boolean): ShaderFeatures {
  return {
    webgl2, texture3d: false, polar: false, radialElevations: false, twoBytes: false, noData: false, filterInShader: false,
    tableInShader: false, surfaces: false, slices: false, adaptive: false,
  };
}

/** Every legal combination; a test compiles them all. */
export function legalCombinations(): ShaderFeatures[] {
  const names = ['webgl2', 'texture3d', 'polar', 'radialElevations', 'twoBytes', 'noData', 'filterInShader', 'tableInShader', 'surfaces', 'slices', 'adaptive'] as const;
  const combinations: ShaderFeatures[] = [];
  for (let bits = 0; bits < 1 << names.length; bits++) {
    const entries = names.map((name, i) => [name, ((bits >> i) & 1) === 1]);
    const features = Object.fromEntries(entries) as Record<(typeof names)[number], boolean>;
    if (isLegal(features)) combinations.push(features);
  }
  return combinations;
}
