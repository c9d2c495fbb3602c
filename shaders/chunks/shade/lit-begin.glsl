/// The material of the volume's surfaces: ambient, diffuse, specular, shininess.
uniform vec4 uMaterial;

/// The effect of light on a colour: the factor of the colour, and the amount of white. Twin: optics/transfer/lights.ts
struct Shade {
  vec3 diffuse;
  vec3 specular;
};

/// Distance in voxels from the nearest face of a box; negative outside. low: distances from its low faces.
float depthInBox(vec3 low, vec3 size) {
  vec3 depth = min(low, size - low);
  return min(min(depth.x, depth.y), depth.z);
}
