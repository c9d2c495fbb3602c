/// Lights of the scene, a column for each: place, relative to the volume's centre, and radius; direction, and kind: 0 none,
/// 1 directional, 2 point, 3 spot; colour and intensity; attenuation and ambient intensity; beam width and cut-off angle of a spot,
/// in radians.
uniform mat4 uLightPlaces;
uniform mat4 uLightDirections;
uniform mat4 uLightColors;
uniform mat4 uLightFades;
uniform mat4 uLightBeams;

/// Light on both sides of a surface: the side that faces the eye counts; front: the share of the front side.
float lightSides(float x, float front, float power) {
  return front * pow(max(1.0e-6, x), power) + (1.0 - front) * pow(max(1.0e-6, -x), power);
}

/// Add the light of the scene's lights. place: relative to the volume's centre; all in world directions; material: see uMaterial.
/// Twin: optics/transfer/lights.ts, shadeSurface
Shade shadeByLights(vec3 place, vec3 normal, vec3 toEye, vec4 material, Shade shade) {
  float front = clamp(0.5 + 0.5 * dot(normal, toEye) / SOFT_FACING, 0.0, 1.0);
  for (int i = 0; i < 4; i++) {
    vec4 towards = uLightDirections[i];
    if (towards.w < 0.5) break;
    vec4 fade = uLightFades[i];
    vec3 offset = uLightPlaces[i].xyz - place;
    float away = max(length(offset), 1.0e-12);
    bool isFar = towards.w > 1.5;
    vec3 toLight = isFar ? offset / away : -towards.xyz;
    float reach = isFar ? step(away, uLightPlaces[i].w) / max(1.0, fade.x + away * (fade.y + away * fade.z)) : 1.0;
    vec2 beam = uLightBeams[i].xy;
    float angle = acos(clamp(-dot(toLight, towards.xyz), -1.0, 1.0));
    if (towards.w > 2.5) reach *= clamp((beam.y - angle) / max(1.0e-4, beam.y - min(beam.x, beam.y)), 0.0, 1.0);
    float seen = lightSides(dot(normal, toLight), front, 1.0);
    float glint = lightSides(dot(normal, normalize(toLight + toEye)), front, material.w) * clamp(seen / SOFT_SPECULAR, 0.0, 1.0);
    vec4 color = uLightColors[i];
    shade.diffuse += color.rgb * (reach * (fade.w * material.x + color.a * material.y * seen));
    shade.specular += color.rgb * (reach * color.a * material.z * glint);
  }
  return shade;
}
