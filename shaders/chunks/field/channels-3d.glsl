/// Light of the channels of each voxel: red, green, blue and brightness.
uniform sampler3D uChannels;

vec4 filterChannels(vec3 p) {
  return texture(uChannels, p);
}
