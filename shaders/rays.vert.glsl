/// Box vertex in -0.5..0.5. Its front face is drawn over what of the picture the volume can be in; culling and zero areas
/// drop the others.
attribute vec3 position;

/// Not used here: what x3dom adds to this text names it.
uniform mat4 modelViewProjectionMatrix;

/// Left, bottom, right and top of that, in device coordinates.
uniform vec4 uBounds;

/// The ray of a pixel in the unit cube, linear in device coordinates: see optics/rays.ts.
uniform vec3 uPoint;
uniform vec3 uPointX;
uniform vec3 uPointY;
uniform vec3 uDirection;
uniform vec3 uDirectionX;
uniform vec3 uDirectionY;

varying vec3 vPoint;
varying vec3 vDirection;

void main() {
  vec2 device = mix(uBounds.xy, uBounds.zw, position.xy + 0.5);
  vPoint = uPoint + uPointX * device.x + uPointY * device.y;
  vDirection = uDirection + uDirectionX * device.x + uDirectionY * device.y;
  gl_Position = vec4(device, 0.0, 1.0);
}
