/// Where a sample is: what the shading of a piece of a ray needs of its ends. Twin: optics/lit.ts, pointField
Sample pointsField(vec3 p, Sample known) {
  known.point = p;
  return known;
}
