/// What a sample's value emits, and the integral up to there: from the nearer edge of its column, so that no digits of
/// what lies between two samples in different columns are lost. Twin: optics/columns.ts, locateShare
Sample columnsField(vec3 p, Sample known) {
#ifdef FUNCTIONS
  whichFunction = known.group;
#endif
  known.place = (known.stored - uColumnDomain.y) * uColumnDomain.x;
  vec3 column = findColumn(known.place);
  vec4 start = fetchColumn(column.x, 0.0);
  vec4 end = fetchColumn(column.x, 1.0);
  float t = (known.place - column.y) / (column.z - column.y);
  bool isNearEnd = t > 0.5;
  float row = isNearEnd ? 4.0 : 2.0;
  float beside = known.place - (isNearEnd ? column.z : column.y);
  known.column = column.x;
  known.emission = start + t * (end - start);
  known.sum = fetchColumn(column.x, row);
  known.sumRest = fetchColumn(column.x, row + 1.0) + 0.5 * beside * (known.emission + (isNearEnd ? end : start));
  return known;
}
