/// Columns of a transfer function; in each column emission is linear. Rows: 0, 1: extinction times colour, and extinction, at the
/// begin and at the end of the columns; 2, 3: the integral up to their begin, and the rest that this float lacks; 4, 5: the same for
/// their end; 6: where they begin and end. Twin: optics/transfer/columns.ts
uniform sampler2D uColumns;

/// Number of columns; columns in a line of texels, and 1 / that; lines of texels for each row.
uniform vec4 uColumnTexels;

/// From a stored value to a share of the part of the domain that is in the data: the scale, and the stored value of its low end.
uniform vec2 uColumnDomain;

#ifdef FUNCTIONS
/// The number of the current transfer function, if there are several: their columns, bins and tables of substeps are one below another.
float whichFunction = 0.0;
#endif

vec4 fetchColumn(float column, float row) {
  float rows = 7.0;
#ifdef FUNCTIONS
  row += rows * whichFunction;
  rows *= FUNCTIONS;
#endif
  float line = floor((column + 0.5) * uColumnTexels.z);
  return texture2D(uColumns, vec2((column - line * uColumnTexels.y + 0.5) * uColumnTexels.z, (row * uColumnTexels.w + line + 0.5) / (rows * uColumnTexels.w)));
}

