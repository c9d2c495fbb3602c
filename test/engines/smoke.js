// The engine itself: WebGL 2 is there, and what it draws can be read back.
const passed = [];
const failed = [];

function check(name, condition) {
  (condition ? passed : failed).push(name);
}

const gl = document.createElement('canvas').getContext('webgl2');
check('WebGL 2 exists', gl !== null);
if (gl) {
  gl.clearColor(0.2, 0.4, 0.6, 1);
  gl.clear(gl.COLOR_BUFFER_BIT);
  const pixel = new Uint8Array(4);
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  check('a drawn colour reads back', pixel.join() === '51,102,153,255');
}
window.__smoke = { done: true, passed, failed };
