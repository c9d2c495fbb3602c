/// Box vertex in -0.5..0.5, or a quad's number. The box's front face is drawn over what of the picture the volume can be
/// in; culling and zero areas drop the others.
attribute vec3 position;

/// Not used here: what x3dom adds to this text names it.
uniform mat4 modelViewProjectionMatrix;

/// Left, bottom, right and top of that, in device coordinates.
uniform vec4 uBounds;

#if ADAPTIVE
/// Quads of 2 x 2 pixels across and down. Each is drawn as a point, where it needs rays; no quads where the box is drawn.
uniform vec2 uQuads;

/// Row of the first.
uniform float uFirstQuadRow;

/// How much the half picture may bend around a quad that gets no rays, 0..1.
uniform float uMaxCurvature;
#endif

void main() {
  gl_Position = vec4(mix(uBounds.xy, uBounds.zw, position.xy + 0.5), 0.0, 1.0);
#if ADAPTIVE
  if (uQuads.x > 0.5) {
    float row = floor((position.x + 0.5) / uQuads.x);
    vec2 quad = vec2(position.x - row * uQuads.x, uFirstQuadRow + row);
    bool needsRays = curvatureOf(lookAround(quad)) > uMaxCurvature;
    gl_PointSize = 2.0;
    // Off the picture, where nothing is drawn of it.
    gl_Position = vec4(needsRays ? (2.0 * quad + 1.0) / uQuads - 1.0 : vec2(2.0), 0.0, 1.0);
  }
#endif
}
