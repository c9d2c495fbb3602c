/// For bins of equal width: the column at a bin's begin, where this column begins and ends, and where the next column ends.
uniform sampler2D uColumnBins;

/// Number of all bins; bins in a row; 1 / texels across and down.
uniform vec4 uBinTexels;

/// The column of a share, and where the column begins and ends. Twin: optics/transfer/column-bins.ts
vec3 findColumn(float share) {
  float bin = floor(clamp(share * uBinTexels.x, 0.0, uBinTexels.x - 1.0));
  float row = floor((bin + 0.5) / uBinTexels.y);
  float below = row;
#ifdef FUNCTIONS
  below += whichFunction * ceil(uBinTexels.x / uBinTexels.y);
#endif
  vec4 found = texture2D(uColumnBins, (vec2(bin - row * uBinTexels.y, below) + 0.5) * uBinTexels.zw);
  return share < found.z ? found.xyz : vec3(found.x + 1.0, found.zw);
}
