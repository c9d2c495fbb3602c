// GLSL ES 1.00 (WebGL 1).
precision highp float;
precision highp int;
#define FRAGMENT_COLOR gl_FragColor
