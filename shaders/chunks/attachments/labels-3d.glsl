/// The number of each voxel's label, in one byte or in two.
uniform sampler3D uLabels;

vec4 fetchLabelTexel(vec3 index) {
  return texelFetch(uLabels, ivec3(index + 0.5), 0);
}
