/// Stored value at a place, in texels of the atlas; false if there is no data. The device's filter interpolates, but where a voxel of the brick may lack data, each is fetched.
bool sampleAtlas(vec3 place, out float value) {
  if (mayLackData) return interpolateAt(place, value);
  value = filterAtlas(place);
  return true;
}

/// The same; p: unit cube.
bool sampleVolume(vec3 p, out float value) {
  return sampleAtlas(inAtlas(p), value);
}
