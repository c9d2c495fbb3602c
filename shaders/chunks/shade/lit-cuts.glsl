/// Half-spaces that are kept, a column for each: the distance inside, in voxels. Twin: optics/rays/cut-fade.ts, fadeAtCuts
uniform mat4 uClipVoxelsA;
uniform mat4 uClipVoxelsB;
uniform mat4 uClipVoxelsC;

/// From a place of the unit cube to its distances in voxels from the low faces of the shown region, a column for each; the last column is
/// the region's size.
uniform mat4 uRegionInVoxels;

/// The same for a box that is cut out.
uniform mat4 uCutoutInVoxels;

float smallest(vec4 x) {
  return min(min(x.x, x.y), min(x.z, x.w));
}

/// Distance in voxels from the nearest cut: inside of the region and of all planes, and outside of the box.
float depthAtClips(vec3 p) {
  vec4 place = vec4(p, 1.0);
  float inside = depthInBox((place * uRegionInVoxels).xyz, uRegionInVoxels[3].xyz);
  float outside = -depthInBox((place * uCutoutInVoxels).xyz, uCutoutInVoxels[3].xyz);
  return min(min(inside, outside), min(smallest(place * uClipVoxelsA), min(smallest(place * uClipVoxelsB), smallest(place * uClipVoxelsC))));
}
