/// A corner of the picture, in -0.5..0.5: all pixels are drawn.
attribute vec3 position;

void main() {
  gl_Position = vec4(2.0 * position.xy, 0.0, 1.0);
}
