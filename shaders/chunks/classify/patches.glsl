/// Patches in the plane of value and gradient, a column for each: first boxes, with their low and high corners; then Gaussians, with their
/// middle and 1 / widths. Values are shares of the domain. The unit of gradients is the upper end of the patch with the smallest gradients.
uniform mat4 uPatchesA;
uniform mat4 uPatchesB;

/// Colour, and extinction per reference length.
uniform mat4 uPatchColorsA;
uniform mat4 uPatchColorsB;

/// The number of boxes, and the number of all patches.
uniform vec2 uPatchCounts;

/// From a gradient of `growsTowards` to this unit.
uniform float uPatchSteepness;

/// The end of the last segment, and its gradient: the next segment begins there.
vec3 steepPoint = vec3(-9.0);
float steepLast = 0.0;

/// Source: Abramowitz and Stegun 1964, 7.1.26, to 1.5e-7
float erfOf(float x) {
  float t = 1.0 / (1.0 + 0.3275911 * abs(x));
  float rest = t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
  return sign(x) * (1.0 - rest * exp(-x * x));
}

/// The share of a way in the plane that is inside a box. Twin: optics/transfer/patches.ts, meanOfBox
float meanOfBox(vec4 box, vec2 from, vec2 to) {
  vec2 way = to - from;
  // A way of length 0 becomes a tiny one, so that it is inside or far outside.
  way = mix(way, vec2(1.0e-12), vec2(lessThan(abs(way), vec2(1.0e-12))));
  vec2 a = (box.xy - from) / way;
  vec2 b = (box.zw - from) / way;
  vec2 begin = min(a, b);
  vec2 end = max(a, b);
  return max(0.0, min(1.0, min(end.x, end.y)) - max(0.0, max(begin.x, begin.y)));
}

/// The value of a Gaussian; place: in standard deviations from its middle.
float gaussianAt(vec2 place) {
  return GAUSSIAN_SCALE * max(0.0, exp(-0.5 * dot(place, place)) - GAUSSIAN_FLOOR);
}

/// The mean of a Gaussian over a way; from, to: in standard deviations from its middle.
/// Source: Kniss et al. 2003. Twin: optics/transfer/patches.ts, meanOfGaussian
float meanOfGaussian(vec2 from, vec2 to) {
  vec2 way = to - from;
  float wayLength = length(way);
  if (wayLength < SHORT_WAY) return (gaussianAt(from) + 4.0 * gaussianAt(0.5 * (from + to)) + gaussianAt(to)) / 6.0;
  vec2 along = way / wayLength;
  float start = dot(from, along);
  vec2 nearest = from - start * along;
  float off = dot(nearest, nearest);
  float reach = sqrt(max(0.0, GAUSSIAN_REACH * GAUSSIAN_REACH - off));
  float a = max(start, -reach);
  float b = min(start + wayLength, reach);
  if (b <= a) return 0.0;
  float integral = exp(-0.5 * off) * 1.2533141373 * (erfOf(b * 0.7071067812) - erfOf(a * 0.7071067812));
  return GAUSSIAN_SCALE * max(0.0, integral - GAUSSIAN_FLOOR * (b - a)) / wayLength;
}

/// The mean over a straight way through the plane. isOutline: by value only, with the maximum over all gradients.
vec4 meanOfPatches(vec2 from, vec2 to, bool isOutline) {
  vec4 mean = vec4(0.0);
  for (int group = 0; group < 2; group++) {
    mat4 places = uPatchesA;
    mat4 colors = uPatchColorsA;
    if (group == 1) {
      places = uPatchesB;
      colors = uPatchColorsB;
    }
    for (int i = 0; i < 4; i++) {
      float number = float(4 * group + i);
      if (number >= uPatchCounts.y) break;
      vec4 place = places[i];
      bool isBox = number < uPatchCounts.x;
      float middle = isBox ? 0.5 * (place.y + place.w) : place.y;
      vec2 a = isOutline ? vec2(from.x, middle) : from;
      vec2 b = isOutline ? vec2(to.x, middle) : to;
      float share = 0.0;
      if (isBox) share = meanOfBox(place, a, b);
      else share = meanOfGaussian((a - place.xy) * place.zw, (b - place.xy) * place.zw);
      vec4 look = colors[i];
      mean += share * look.a * vec4(look.rgb, 1.0);
    }
  }
  return mean;
}

/// Whether any patch shows some of the values between two values.
bool meetsPatches(float from, float to) {
  float low = min(from, to);
  float high = max(from, to);
  for (int group = 0; group < 2; group++) {
    mat4 places = uPatchesA;
    if (group == 1) places = uPatchesB;
    for (int i = 0; i < 4; i++) {
      float number = float(4 * group + i);
      if (number >= uPatchCounts.y) break;
      vec4 place = places[i];
      vec2 ends = place.xz;
      if (number >= uPatchCounts.x) ends = place.x + vec2(-1.0, 1.0) * (GAUSSIAN_REACH / place.z);
      if (high >= ends.x && low <= ends.y) return true;
    }
  }
  return false;
}

/// How steep a field is at a sample. Twin: optics/rays/patch-classify.ts
float steepnessOf(Sample known) {
  vec3 from = beginTaps(known.point);
  return uPatchSteepness * length(uNormalToWorld * growsTowards(known.point, from, changePerVoxel(known, from)));
}

/// Taps are taken only if a value may show.
vec4 meanOfSamples(Sample from, Sample to) {
  bool meets = meetsPatches(from.value, to.value);
  float near = steepLast;
  float far = steepLast;
  float first = !meets ? 2.0 : from.point == steepPoint ? 1.0 : 0.0;
  // A loop, so that the program has this code only once for both ends.
  for (int i = 0; i < 2; i++) {
    float end = first + float(i);
    if (end > 1.5) break;
    Sample here = to;
    if (end < 0.5) here = from;
    far = steepnessOf(here);
    if (end < 0.5) near = far;
    // End the loop at its bottom: see changePerVoxel.
    if (end > 0.5) break;
  }
  if (!meets) return vec4(0.0);
  steepPoint = to.point;
  steepLast = far;
  return meanOfPatches(vec2(from.value, near), vec2(to.value, far), false);
}

vec4 emissionAt(float value) {
  return meanOfPatches(vec2(value, 0.0), vec2(value, 0.0), true);
}
