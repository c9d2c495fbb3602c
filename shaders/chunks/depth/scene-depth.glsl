/// Depth buffer of the scene's opaque shapes.
uniform sampler2D uSceneDepth;

/// From a pixel to its place in the depth buffer: factors and shifts.
uniform vec4 uPixelToDepth;

/// Projection matrix, third and fourth row, columns z and w.
uniform vec4 uDepthTerms;

/// The depth of t = 0, and the depth of one unit of t, in world units.
uniform vec2 uDepthToT;

/// The depth as stored in the buffer; 1 if there is no shape. pixel: its centre.
float depthAt(vec2 pixel) {
  return texture2D(uSceneDepth, pixel * uPixelToDepth.xy + uPixelToDepth.zw).r;
}

/// t of a depth that is stored in the buffer.
float depthToT(float stored) {
  float device = stored * 2.0 - 1.0;
  if (device >= 1.0) return 1.0e30;
  float depth = (uDepthTerms.y - device * uDepthTerms.w) / (uDepthTerms.x - device * uDepthTerms.z);
  return (depth - uDepthToT.x) / uDepthToT.y;
}

/// The shift from the middle of a pixel to its ray, in pixels.
uniform vec2 uRayShift;

/// How much the stored depth changes from pixel to pixel, across and up. Twin: optics/rays/depth-slope.ts
vec2 depthSlope(vec2 before, float here, vec2 after) {
  vec2 a = here - before;
  vec2 b = after - here;
  return a * b * (a + b) / max(a * a + b * b, 1.0e-30);
}

/// t of the nearest opaque shape. The shift uses that stored depths are linear in the pixel along a plane.
float surfaceT() {
  vec2 pixel = gl_FragCoord.xy;
  vec2 right = vec2(1.0, 0.0);
  float stored = depthAt(pixel);
  vec2 before = vec2(depthAt(pixel - right), depthAt(pixel - right.yx));
  vec2 after = vec2(depthAt(pixel + right), depthAt(pixel + right.yx));
  return depthToT(stored < 1.0 ? stored + dot(uRayShift, depthSlope(before, stored, after)) : stored);
}

/// An opaque shape ends a ray; x3dom has drawn it. Twin: optics/rays/ray-intervals.ts, shapeInterval
Interval sceneDepthInterval(Ray ray, Interval interval) {
  interval.exit = min(interval.exit, surfaceT());
  return interval;
}
