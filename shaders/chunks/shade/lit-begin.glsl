/// How surfaces of a value take light: ambient, diffuse, specular, shininess.
uniform vec4 uMaterial;

/// What comes of a colour: how much of it there is, and how much white. Twin: optics/lights.ts
struct Shade {
  vec3 diffuse;
  vec3 specular;
};

/// Voxels from the nearest face of a box; negative outside. low: from its low faces.
float depthInBox(vec3 low, vec3 size) {
  vec3 depth = min(low, size - low);
  return min(min(depth.x, depth.y), depth.z);
}
