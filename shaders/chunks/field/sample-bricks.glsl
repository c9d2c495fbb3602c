/// Stored value at a point; p: unit cube. False if there is no data. The device's filter interpolates, but where a voxel may lack data, each is fetched.
bool sampleVolume(vec3 p, out float value) {
  vec3 place = inAtlas(p);
  if (mayLackData) return interpolateAt(place, value);
  value = decodeTexel(textureLod(uVolume, place * uPerTexel, 0.0));
  return true;
}
