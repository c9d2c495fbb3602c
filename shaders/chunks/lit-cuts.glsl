/// Half-spaces that are kept, a column each: voxels inside. Twin: optics/cut-fade.ts, fadeAtCuts
uniform mat4 uClipVoxelsA;
uniform mat4 uClipVoxelsB;
uniform mat4 uClipVoxelsC;

/// As uRegionInVoxels, of a box that is cut out.
uniform mat4 uCutoutInVoxels;

float least(vec4 x) {
  return min(min(x.x, x.y), min(x.z, x.w));
}

/// Voxels inside of all planes, and outside of the box.
float depthAtClips(vec3 p) {
  vec4 place = vec4(p, 1.0);
  vec3 low = (place * uCutoutInVoxels).xyz;
  vec3 depth = min(low, uCutoutInVoxels[3].xyz - low);
  float outside = -min(min(depth.x, depth.y), depth.z);
  return min(outside, min(least(place * uClipVoxelsA), min(least(place * uClipVoxelsB), least(place * uClipVoxelsC))));
}
