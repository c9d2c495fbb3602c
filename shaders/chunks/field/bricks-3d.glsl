/// A volume with bricks of finer levels over it. Twin: bricks/resident-bricks.ts
uniform sampler3D uVolume;

/// Slots of bricks: each has SLOT_SIDE texels along each axis, the outermost of which are the halo.
uniform sampler3D uBricks;

/// A texel for each cell (brick of the finest level): the slot of its brick in three bytes; 1 + the brick's level, or 0 where it has none.
uniform sampler2D uBrickPages;

/// Four texels for each level: its voxels are xyz of the first * place + xyz of the second; its size in voxels; cells of a brick.
uniform sampler2D uBrickLevels;

/// Cells along each axis.
uniform vec3 uBrickCells;

/// Voxels along the unit cube: of the finest level, for light; and of the finest level of which there are bricks, for the walk.
uniform vec3 uFinestVoxels;
uniform vec3 uPlaneVoxels;

#define FINEST_VOXELS uFinestVoxels
#define PLANE_VOXELS uPlaneVoxels

/// The voxels at the last place for which `findVoxels` was called: voxel = scale * place + shift, and how many there are. The voxel at 0 of a
/// brick's level would lie at texel `brickStart` of its slot.
bool isInBrick;
vec3 voxelScale;
vec3 voxelShift;
vec3 voxelCount;
vec3 brickStart;

vec4 brickLevel(int level, int row) {
  return texelFetch(uBrickLevels, ivec2(4 * level + row, 0), 0);
}

/// p: unit cube
void findVoxels(vec3 p) {
  vec3 cell = clamp(floor((p * brickLevel(0, 0).xyz + brickLevel(0, 1).xyz) / BRICK_SIDE), vec3(0.0), uBrickCells - 1.0);
  int number = int(cell.x + 0.5) + int(uBrickCells.x + 0.5) * (int(cell.y + 0.5) + int(uBrickCells.y + 0.5) * int(cell.z + 0.5));
  ivec4 page = ivec4(texelFetch(uBrickPages, ivec2(number % PAGE_COLUMNS, number / PAGE_COLUMNS), 0) * 255.0 + 0.5);
  isInBrick = page.a > 0;
  voxelScale = uDimensions;
  voxelShift = vec3(0.0);
  voxelCount = uDimensions;
  if (isInBrick) {
    int level = page.a - 1;
    int slot = page.r + 256 * page.g + 65536 * page.b;
    voxelScale = brickLevel(level, 0).xyz;
    voxelShift = brickLevel(level, 1).xyz;
    voxelCount = brickLevel(level, 2).xyz;
    vec3 bricks = ceil(voxelCount / BRICK_SIDE);
    vec3 brick = min(bricks - 1.0, floor((cell + 0.5) / brickLevel(level, 3).xyz));
    vec3 place = vec3(slot % SLOT_COLUMNS, slot / SLOT_COLUMNS % SLOT_ROWS, slot / (SLOT_COLUMNS * SLOT_ROWS));
    brickStart = SLOT_SIDE * place + BRICK_HALO - BRICK_SIDE * brick;
  }
}

#define IN_VOXELS(p) inVoxels(p)
#define LAST_VOXEL (voxelCount - 1.0)

vec3 inVoxels(vec3 p) {
  findVoxels(p);
  return p * voxelScale + voxelShift;
}

/// Stored value of a voxel next to the place for which `findVoxels` was called last; index: whole numbers, inside the level.
float fetchVoxel(vec3 index) {
  vec4 texel;
  if (isInBrick) texel = texelFetch(uBricks, ivec3(brickStart + index + 0.5), 0);
  else texel = texelFetch(uVolume, ivec3(index + 0.5), 0);
  return decodeTexel(texel);
}

/// Stored value, interpolated by the device's own tri-linear filter; p: unit cube.
float filterVolume(vec3 p) {
  findVoxels(p);
  if (!isInBrick) return decodeTexel(textureLod(uVolume, p, 0.0));
  vec3 voxel = clamp(p * voxelScale + voxelShift, vec3(0.5), voxelCount - 0.5);
  return decodeTexel(textureLod(uBricks, (brickStart + voxel) / vec3(textureSize(uBricks, 0)), 0.0));
}
