/// Box vertex in -0.5..0.5, or the number of a quad. The box's front face covers the rectangle of the picture that can show
/// the volume; culling and zero areas drop the other faces.
attribute vec3 position;

/// Not used here, but x3dom adds text that names it.
uniform mat4 modelViewProjectionMatrix;

/// Left, bottom, right and top of that rectangle, in device coordinates.
uniform vec4 uBounds;

#if ADAPTIVE
/// Row of the first quad.
uniform float uFirstQuadRow;

/// The largest curvature of the half picture around a quad that gets no rays, 0..1.
uniform float uMaxCurvature;
#endif

void main() {
  gl_Position = vec4(mix(uBounds.xy, uBounds.zw, position.xy + 0.5), 0.0, 1.0);
#if ADAPTIVE
  if (uQuads.x > 0.5) {
    float row = floor((position.x + 0.5) / uQuads.x);
    vec2 quad = vec2(position.x - row * uQuads.x, uFirstQuadRow + row);
    Surroundings around = lookAround(quad);
    bool needsRays = curvatureOf(around) > uMaxCurvature;
#ifdef NEEDS_RAYS
    QuadPlace place = placeOf(quad);
    needsRays = needsRays || NEEDS_RAYS;
#endif
    gl_PointSize = 2.0;
    // Outside of the picture, where nothing of it is drawn.
    gl_Position = vec4(needsRays ? (2.0 * quad + 1.0) / uQuads - 1.0 : vec2(2.0), 0.0, 1.0);
  }
#endif
}
