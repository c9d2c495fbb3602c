// The method of the 2011 paper with its errors, for the accuracy study only. paper.md lists the errors and their corrections;
// ray-caster.frag.glsl has the corrections.

/// t at the eye.
uniform float uEyeT;

/// Steps on every ray, whatever its length: s of the paper.
uniform float uSteps;

/// O_f and L_f of the paper.
uniform float uOpacityFactor;
uniform float uLightFactor;

/// Straight colour and opacity by stored value, 8 bits per channel.
uniform sampler2D uTransferFunction;

/// A point, rounded as in a picture of the colour cube; p: unit cube. Source: the paper's figure 2
vec3 roundToByte(vec3 p) {
  return floor(clamp(p, 0.0, 1.0) * 255.0 + 0.5) / 255.0;
}

/// Stored value, with slice k at k / S, which is its lower face instead of its middle; p: unit cube. Source: equations 5 and 17
float sampleAtCorners(vec3 p) {
  return filterVolume(vec3(p.xy, p.z + 0.5 / uDimensions.z));
}

void main() {
  Ray ray = rayOfPixel();
  vec2 span = intersectUnitCube(ray.point, ray.direction);
  float start = max(span.x, uEyeT);
  vec4 accumulated = vec4(0.0);
  if (span.y > start) {
    vec3 entry = roundToByte(ray.point + ray.direction * start);
    vec3 stride = (roundToByte(ray.point + ray.direction * span.y) - entry) / uSteps;
    for (int i = 0; i < MAX_SAMPLES; i++) {
      float number = float(i);
      if (number >= uSteps || accumulated.a >= 1.0) break;
      vec4 classified = texture2D(uTransferFunction, vec2(sampleAtCorners(entry + stride * number), 0.5));
      float opacity = classified.a * uOpacityFactor * (1.0 / uSteps); // Equation 1
      vec3 color = classified.rgb * opacity * uLightFactor; // Equation 2
      accumulated.rgb += (1.0 - accumulated.a) * color; // Equation 3
      accumulated.a += opacity; // Equation 4
    }
  }
  FRAGMENT_COLOR = min(accumulated, 1.0);
}
