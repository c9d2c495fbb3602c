/// How surfaces of a value take light: ambient, diffuse, specular, shininess.
uniform vec4 uMaterial;

/// What comes of a colour: how much of it there is, and how much white. Twin: optics/lights.ts
struct Shade {
  vec3 diffuse;
  vec3 specular;
};
