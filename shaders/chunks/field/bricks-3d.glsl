/// A volume with bricks of finer levels over it, all in one atlas: the volume with a halo of two voxels, and slots of bricks with theirs.
/// Twin: bricks/resident-bricks.ts
uniform sampler3D uVolume;

/// A texel for each cell (brick of the finest level). What it shows lies at the texel of the atlas = place * scale + its x, y, z; its w says which scale that is, plus
/// LACKING where a voxel that it is interpolated from may lack data. With GROUPED_PAGES it is one for each group of cells: where w is below 0, these have texels of
/// their own, at the cell + x, y, z.
uniform sampler3D uBrickPages;

#define LACKING 4096

/// Voxels along the unit cube: of the finest level; and of the finest level of which there are bricks, for the walk.
uniform vec3 uFinestVoxels;
uniform vec3 uPlaneVoxels;

#define FINEST_VOXELS uFinestVoxels
#define PLANE_VOXELS uPlaneVoxels

#if !HALVED_LEVELS
/// The same of all levels of bricks, finest first, then of the volume over which they lie: w is a number of one of them. With HALVED_LEVELS, w counts how often voxels
/// are twice as long as the finest ones, in 4 bits for each axis.
uniform vec3 uLevelScales[16];
#endif

/// Cell = place * the first + the second; and the last one.
uniform vec3 uCellScale;
uniform vec3 uCellShift;
uniform vec3 uLastCell;

/// 1 / cells along each axis of a group: a power of two.
uniform float uPerGroup;

/// Places between which the finest level lies.
uniform vec3 uFinestLow;
uniform vec3 uFinestHigh;

/// 1 / texels of the atlas.
uniform vec3 uPerTexel;

/// Of what is shown at the last place that `inAtlas` was asked for: voxels along the unit cube, cells along each axis that are known to show the same brick, and
/// whether any of its voxels may lack data.
vec3 voxelScale;
float sameCells = 1.0;
bool mayLackData = false;

/// What is known of the cell that a ray has looked into last: how many times as long as those of the finest level of which there are bricks its voxels are at least,
/// samples for each of them, and whole steps that are left in it.
float longer = 1.0;
float samplesPerVoxel = 1.0;
float toWall = 0.0;

/// 2 to a power, of its bits: 127 << 23 are those of 1.0. Processors have no quick way to shift by a number that differs from pixel to pixel.
float powerOfTwo(int power) {
  return intBitsToFloat((127 + power) << 23);
}

/// The distance of samples in a cell, in steps; code: of the cell, 4 more for each doubling of the length of its voxels; within: whole steps that are left in it;
/// power: uDetailPower, which is far below 0 where cells do not matter. Twin: optics/cells/min-substeps.ts
float spacingOf(float code, float power, float within) {
  int known = int(code + 0.5);
  int cuts = int(clamp(float(known & 3) + power, 0.0, 3.0) + 0.5);
  int doublings = power < -4.5 ? 0 : known >> 2;
  samplesPerVoxel = powerOfTwo(cuts);
  longer = powerOfTwo(doublings);
  toWall = max(1.0, within);
  return min(powerOfTwo(doublings - cuts), toWall);
}

/// Voxels along the unit cube, by the w of a page. Processors have no quick way to look up an array either.
vec3 scaleOf(int code) {
#if HALVED_LEVELS
  ivec3 halvings = ivec3(code, code >> 4, code >> 8) & 15;
  return uFinestVoxels * intBitsToFloat((127 - halvings) << 23);
#else
  return uLevelScales[code & 15];
#endif
}

/// The texel of the atlas where the value at a place lies; p: unit cube. Halos have what interpolation there needs, and that of the places a texel away along each axis, also at the ends of a level.
vec3 inAtlas(vec3 p) {
  vec3 place = clamp(p, uFinestLow, uFinestHigh);
  vec3 cell = min(place * uCellScale + uCellShift, uLastCell);
#if GROUPED_PAGES
  vec4 page = texelFetch(uBrickPages, ivec3(cell * uPerGroup), 0);
  sameCells = page.w < 0.0 ? 1.0 : 1.0 / uPerGroup;
  if (page.w < 0.0) page = texelFetch(uBrickPages, ivec3(cell + page.xyz), 0);
#else
  vec4 page = texelFetch(uBrickPages, ivec3(cell), 0);
#endif
  voxelScale = scaleOf(int(page.w));
  mayLackData = page.w >= float(LACKING);
  return place * voxelScale + page.xyz;
}

/// How far a line runs from a place to the next whole number along any axis; way: how far a unit of length moves it.
float meetWhole(vec3 place, vec3 way) {
  vec3 ahead = sign(way) * place;
  vec3 lengths = (floor(ahead) + 1.0 - ahead) / max(abs(way), vec3(1.0e-9));
  return min(min(lengths.x, lengths.y), lengths.z);
}

/// Where a line meets the next plane of voxel centres of what is shown at a place of it. Places are lengths; forward: how far a unit of length moves it.
float meetPlane(vec3 origin, vec3 forward, float at) {
  vec3 place = inAtlas(origin + forward * at) - 0.5;
  return at + meetWhole(place, forward * voxelScale);
}

/// Where a piece ends that begins at a place of a line: at the next plane of voxel centres of what is shown there; or shortly before or behind a face between bricks, over
/// which values may jump. No piece is shorter than `shortest`. Twin: bricks/brick-kinks.ts
float meetPlaneOrFace(vec3 origin, vec3 forward, float from, float shortest) {
  float at = from + shortest;
  float plane = meetPlane(origin, forward, at);
  vec3 way = forward * uCellScale / sameCells;
  vec3 cell = ((origin + forward * at) * uCellScale + uCellShift) / sameCells;
  bool isBehindFace = meetWhole(cell, -way) < shortest;
  return isBehindFace ? at : max(at, min(plane, at + meetWhole(cell, way) - 0.5 * shortest));
}

#define IN_VOXELS(p) inAtlas(p)
#define LAST_VOXEL (1.0 / uPerTexel - 1.0)

/// Stored value of a texel of the atlas.
float fetchVoxel(vec3 index) {
  return decodeTexel(texelFetch(uVolume, ivec3(index + 0.5), 0));
}

/// Stored value, interpolated by the device's own tri-linear filter; place: in texels of the atlas.
float filterAtlas(vec3 place) {
  return decodeTexel(textureLod(uVolume, place * uPerTexel, 0.0));
}

/// The same; p: unit cube.
float filterVolume(vec3 p) {
  return filterAtlas(inAtlas(p));
}
