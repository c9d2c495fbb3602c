/// Columns of a transfer function, in which emission is a straight line. Rows: extinction times colour, and extinction, where
/// columns begin, and where they end; the integral up to where they begin, and what that number lacks; the same where they
/// end; where they begin and end. Twin: optics/columns.ts
uniform sampler2D uColumns;

/// Columns; columns side by side, and 1 / that; how many lines of them a row has.
uniform vec4 uColumnTexels;

/// Stored value to share of what is in the data of the domain: scale, and what is stored for its low end.
uniform vec2 uColumnDomain;

#ifdef FUNCTIONS
/// Which of several transfer functions is meant, of which the columns, the bins and the tables of substeps lie one below another.
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

