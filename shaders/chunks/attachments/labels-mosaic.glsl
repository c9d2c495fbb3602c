/// The number of each voxel's label, in one byte or in two; slices are stored as tiles.
uniform sampler2D uLabels;

/// Columns and rows of tiles; texels across and down.
uniform vec4 uLabelMosaic;

vec4 fetchLabelTexel(vec3 index) {
  float row = floor((index.z + 0.5) / uLabelMosaic.x);
  vec2 origin = vec2(index.z - row * uLabelMosaic.x, row) * uDimensions.xy;
  return texture2D(uLabels, (origin + index.xy + 0.5) / uLabelMosaic.zw);
}
