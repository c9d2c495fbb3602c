uniform sampler3D uVolume;

/// Stored value of one voxel; index: whole numbers, inside the grid.
float fetchVoxel(vec3 index) {
  return decodeTexel(texelFetch(uVolume, ivec3(index + 0.5), 0));
}

/// Stored value, interpolated by the device's own tri-linear filter; p: unit cube.
float filterVolume(vec3 p) {
  return decodeTexel(texture(uVolume, p));
}
