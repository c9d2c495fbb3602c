/// One row: premultiplied colour and opacity of one full step.
uniform sampler2D uTransferFunction;

/// Stored value to texels of the table: scale, offset; and the table's width.
uniform vec3 uTable;

/// What one full step of a stored value emits and hides. Twin: optics/table.ts
vec4 classify(float value) {
  float texel = clamp(value * uTable.x + uTable.y, 0.0, uTable.z - 1.0);
#if TABLE_IN_SHADER
  float low = floor(texel);
  vec4 from = texture2D(uTransferFunction, vec2((low + 0.5) / uTable.z, 0.5));
  vec4 to = texture2D(uTransferFunction, vec2((min(low + 1.0, uTable.z - 1.0) + 0.5) / uTable.z, 0.5));
  return mix(from, to, texel - low);
#else
  return texture2D(uTransferFunction, vec2((texel + 0.5) / uTable.z, 0.5));
#endif
}

/// The same over a part of a step; part: 0..1. Twin: optics/opacity.ts, correctOpacity
vec4 classifyPart(float value, float part) {
  vec4 full = classify(value);
  float alpha = full.a < 1.0 ? 1.0 - pow(1.0 - full.a, part) : 1.0;
  return full.a > 0.0 ? vec4(full.rgb * (alpha / full.a), alpha) : vec4(0.0);
}
