/// A vertex of the box, in -0.5..0.5, or the number of a quad. The box's front face covers the rectangle of the picture that can
/// show the volume; the GPU drops the other faces, because they are culled or have no area.
attribute vec3 position;

/// Not used here, but x3dom adds code that uses it.
uniform mat4 modelViewProjectionMatrix;

/// Left, bottom, right and top of that rectangle, in device coordinates.
uniform vec4 uBounds;

#if ADAPTIVE
/// Row of the first quad.
uniform float uFirstQuadRow;

/// A quad gets no rays if the curvature of the half picture around it is at most this, 0..1.
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
    // A quad that needs no rays goes outside of the picture, so that the GPU draws nothing.
    gl_Position = vec4(needsRays ? (2.0 * quad + 1.0) / uQuads - 1.0 : vec2(2.0), 0.0, 1.0);
  }
#endif
}
