/// The ray of a pixel in the unit cube, linear in device coordinates: see optics/rays/rays.ts.
uniform vec3 uPoint;
uniform vec3 uPointX;
uniform vec3 uPointY;
uniform vec3 uDirection;
uniform vec3 uDirectionX;
uniform vec3 uDirectionY;

/// 2 / pixels across and down.
uniform vec2 uDevicePerPixel;

/// point + t direction, in the unit cube.
struct Ray {
  vec3 point;
  vec3 direction;
};

/// pixel: its centre.
Ray rayAt(vec2 pixel) {
  vec2 device = pixel * uDevicePerPixel - 1.0;
  return Ray(
    uPoint + uPointX * device.x + uPointY * device.y,
    uDirection + uDirectionX * device.x + uDirectionY * device.y
  );
}

/// The ray of this pixel.
Ray rayOfPixel() {
  return rayAt(gl_FragCoord.xy);
}
