// GLSL ES 3.00 (WebGL 2). x3dom adds lines in GLSL ES 1.00, hence the defines.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler3D;
#define texture2D texture
#ifdef VERTEX_STAGE
#define attribute in
#define varying out
#else
#define varying in
out vec4 fragmentColor;
#define FRAGMENT_COLOR fragmentColor
#endif
