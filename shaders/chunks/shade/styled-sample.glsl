/// Applies X3D's rendering styles at a place. Twin: optics/rays/styled.ts, stylesAt

/// As in lit.glsl: 1 / the change from voxel to voxel, as a share of the domain, below which a field is flat.
uniform float uPerFlat;

/// A row for each function of one number; a chain of styles has four functions. Twin: optics/transfer/volume-styles.ts, buildStyleTable
uniform sampler2D uStyleTable;

/// For two chains: their share of the picture, their factor of the opacity at flat places, and whether they are lit.
uniform vec2 uStyleWeights;
uniform vec2 uStyleFlat;
uniform vec2 uStyleLit;

/// From the change along a reference length to a share of the range of factors by gradient; 0 if there are no such factors.
/// Twin: optics/rays/styled.ts, perGradientReach
uniform vec2 uStylePerReach;

/// As uMaterial, for styled places.
uniform vec4 uStyleMaterial;

/// Factors of diffuse and specular light, and the light that is added.
uniform vec3 uStyleDiffuse;
uniform vec3 uStyleSpecular;
uniform vec3 uStyleEmissive;

/// From flat changes per world unit to the change along a reference length. Twin: optics/rays/styled.ts, perReferenceLength
uniform float uStyleChange;

/// How styles change a colour c (gain c + more), and the opacity of a reference length.
struct Styled {
  vec3 gain;
  vec3 more;
  float opacity;
};

/// Reads a row of the table, with linear interpolation between its entries.
vec4 styleRow(float row, float share) {
  float at = clamp(share, 0.0, 1.0) * (STYLE_COLUMNS - 1.0);
  float low = min(STYLE_COLUMNS - 2.0, floor(at));
  float y = (row + 0.5) / (2.0 * STYLE_ROWS);
  vec4 first = texture2D(uStyleTable, vec2((low + 0.5) / STYLE_COLUMNS, y));
  return mix(first, texture2D(uStyleTable, vec2((low + 1.5) / STYLE_COLUMNS, y)), at - low);
}

/// The mean of n . l of all lights, weighted by intensity, for the side that faces the eye. Twin: optics/rays/styled.ts, towardsLights
float towardsLights(vec3 place, vec3 normal, float facing) {
  float sum = uHeadlight * abs(facing);
  float weights = uHeadlight;
#if LIT_LIGHTS
  float side = clamp(facing / SOFT_FACING, -1.0, 1.0);
  for (int i = 0; i < 4; i++) {
    vec4 towards = uLightDirections[i];
    if (towards.w < 0.5) break;
    vec3 offset = uLightPlaces[i].xyz - place;
    vec3 toLight = towards.w > 1.5 ? offset / max(length(offset), 1.0e-12) : -towards.xyz;
    sum += uLightColors[i].a * side * dot(normal, toLight);
    weights += uLightColors[i].a;
  }
#endif
  return sum / max(weights, 1.0e-6);
}

Styled styleSample(Sample known) {
  vec3 from = beginTaps(known.point);
  vec3 perVoxel = changePerVoxel(known, from) * uPerFlat;
  float weight = fadeAtCuts(known.point) * (1.0 - 1.0 / (1.0 + dot(perVoxel, perVoxel)));
  vec3 grows = uNormalToWorld * growsTowards(known.point, from, perVoxel);
  float steepness = length(grows);
  vec3 normal = grows / max(steepness, 1.0e-30);
  vec3 toEye = -normalize(uUnitToWorld * rayOfPixel().direction);
  vec3 place = uUnitToWorld * (known.point - 0.5);
  float facing = dot(normal, toEye);
  float towards = towardsLights(place, normal, facing);
  float change = uStyleChange * steepness;
  float share = STYLE_CHANGES * (change / (1.0 + change));
  facing = abs(facing);
  Shade shade = Shade(vec3(uStyleMaterial.x + uHeadlight * uStyleMaterial.y * facing), vec3(uHeadlight * uStyleMaterial.z * pow(max(1.0e-6, facing), uStyleMaterial.w)));
#if LIT_LIGHTS
  if (uStyleLit.x + uStyleLit.y > 0.5) shade = shadeByLights(place, normal, toEye, uStyleMaterial, shade);
#endif
  shade.diffuse = 1.0 + weight * (shade.diffuse * uStyleDiffuse - 1.0);
  shade.specular = weight * (shade.specular * uStyleSpecular + uStyleEmissive);
  Styled sum = Styled(vec3(0.0), vec3(0.0), 0.0);
  for (int chain = 0; chain < 2; chain++) {
    bool isSecond = chain == 1;
    float part = isSecond ? uStyleWeights.y : uStyleWeights.x;
    if (part <= 0.0) continue;
    float first = isSecond ? STYLE_ROWS : 0.0;
    vec4 row = styleRow(first, 0.5 + 0.5 * towards);
    vec3 gain = vec3(1.0 + weight * (row.a - 1.0));
    vec3 more = weight * row.rgb;
    for (int side = 1; side < 3; side++) {
      row = styleRow(first + float(side), facing);
      float kept = 1.0 + weight * (row.a - 1.0);
      gain *= kept;
      more = more * kept + weight * row.rgb;
      if (side == 1 && (isSecond ? uStyleLit.y : uStyleLit.x) > 0.5) {
        gain *= shade.diffuse;
        more = more * shade.diffuse + shade.specular;
      }
    }
    float flatOpacity = isSecond ? uStyleFlat.y : uStyleFlat.x;
    float opacity = mix(flatOpacity, styleRow(first + 3.0, facing).x, weight) * styleRow(first + 3.0, share).y;
    float perReach = isSecond ? uStylePerReach.y : uStylePerReach.x;
    if (perReach > 0.0) opacity *= styleRow(first + 3.0, change * perReach).z;
    sum = Styled(sum.gain + part * gain, sum.more + part * more, sum.opacity + part * opacity);
  }
  return sum;
}
