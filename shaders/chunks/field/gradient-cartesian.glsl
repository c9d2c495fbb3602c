/// The taps of a cartesian grid are one voxel apart along its axes. Twin: optics/rays/gradient.ts, cartesianGradient
vec3 growsTowards(vec3 p, vec3 from, vec3 perVoxel) {
  return perVoxel;
}

#ifdef BRICKS
/// The voxels are those that are shown at the place, in texels of the atlas: a brick has a halo, so that taps stay in it.
vec3 beginTaps(vec3 p) {
  return inAtlas(p);
}

vec3 tapSteps(vec3 from) {
  return vec3(1.0);
}

#if !FILTER_IN_SHADER
/// From voxel to voxel, where all of them have data: the device's filter gives their values.
vec3 changeInAtlas(vec3 from) {
  vec3 low = vec3(filterAtlas(from - vec3(1.0, 0.0, 0.0)), filterAtlas(from - vec3(0.0, 1.0, 0.0)), filterAtlas(from - vec3(0.0, 0.0, 1.0)));
  vec3 high = vec3(filterAtlas(from + vec3(1.0, 0.0, 0.0)), filterAtlas(from + vec3(0.0, 1.0, 0.0)), filterAtlas(from + vec3(0.0, 0.0, 1.0)));
  return 0.5 * uTableDomain.x * (high - low);
}
#endif

#if FILTER_IN_SHADER
#define TAPS_IN_LOOP

bool tapField(vec3 at, out float stored) {
  return interpolateAt(at, stored);
}
#elif NO_DATA
#define TAPS_IN_LOOP

bool tapField(vec3 at, out float stored) {
  return sampleAtlas(at, stored);
}
#else
vec3 changePerVoxel(Sample known, vec3 from) {
  return changeInAtlas(from) * voxelScale / FINEST_VOXELS;
}
#endif
#else
vec3 beginTaps(vec3 p) {
  return p;
}

#if FILTER_IN_SHADER || NO_DATA
#define TAPS_IN_LOOP

vec3 tapSteps(vec3 from) {
  return 1.0 / uDimensions;
}

bool tapField(vec3 at, out float stored) {
  return sampleVolume(at, stored);
}
#elif TEXTURE_3D
/// All places have data, and the device's filter gives their values: each tap is one line. Twin: optics/rays/gradient.ts, differ
vec3 changePerVoxel(Sample known, vec3 from) {
  vec3 voxel = 1.0 / uDimensions;
  vec3 low = vec3(filterVolume(from - vec3(voxel.x, 0.0, 0.0)), filterVolume(from - vec3(0.0, voxel.y, 0.0)), filterVolume(from - vec3(0.0, 0.0, voxel.z)));
  vec3 high = vec3(filterVolume(from + vec3(voxel.x, 0.0, 0.0)), filterVolume(from + vec3(0.0, voxel.y, 0.0)), filterVolume(from + vec3(0.0, 0.0, voxel.z)));
  return 0.5 * uTableDomain.x * (high - low);
}
#else
/// Stored value in a slice, see filterVolume; tile: first texel of the slice's tile; at: texels from there.
float filterTile(vec2 tile, vec2 at) {
  return decodeTexel(texture2D(uVolume, (tile + clamp(at, vec2(0.5), uDimensions.xy - 0.5)) / uMosaic.zw));
}

/// The same in the two slices around a place: the taps along x and y are in the same slices. Twin: optics/rays/gradient.ts, differ
vec3 changePerVoxel(Sample known, vec3 from) {
  vec2 at = from.xy * uDimensions.xy;
  float last = uDimensions.z - 1.0;
  vec3 slices = clamp(from.z * uDimensions.z - 0.5 + vec3(-1.0, 0.0, 1.0), 0.0, last);
  vec3 below = floor(slices);
  vec3 share = slices - below;
  vec3 above = min(below + 1.0, last);
  vec2 tile = tileOrigin(below.y);
  vec4 across = vec4(filterTile(tile, at - vec2(1.0, 0.0)), filterTile(tile, at + vec2(1.0, 0.0)), filterTile(tile, at - vec2(0.0, 1.0)), filterTile(tile, at + vec2(0.0, 1.0)));
  tile = tileOrigin(above.y);
  vec4 next = vec4(filterTile(tile, at - vec2(1.0, 0.0)), filterTile(tile, at + vec2(1.0, 0.0)), filterTile(tile, at - vec2(0.0, 1.0)), filterTile(tile, at + vec2(0.0, 1.0)));
  across += share.y * (next - across);
  vec2 low = vec2(filterTile(tileOrigin(below.x), at), filterTile(tileOrigin(below.z), at));
  vec2 high = vec2(filterTile(tileOrigin(above.x), at), filterTile(tileOrigin(above.z), at));
  low += share.xz * (high - low);
  return 0.5 * uTableDomain.x * vec3(across.y - across.x, across.w - across.z, low.y - low.x);
}
#endif
#endif
