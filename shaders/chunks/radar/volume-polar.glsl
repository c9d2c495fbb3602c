/// The gates of all sweeps. A row has as many whole radials of one sweep as fit into it: see radar/polar-layout.ts
uniform sampler2D uVolume;

/// Texels across; 1 / texels across and down.
uniform vec3 uGateTexels;

/// A table to find the sweeps and radials around an angle, and the geometry of sweeps: see radar/polar-table.ts
uniform sampler2D uPolarTable;

/// 1 / texels down the table.
uniform float uPolarTableRow;

/// The first texels of the table's sweeps, radials and bins of azimuth.
uniform vec3 uTableBegins;

/// Bins per degree of elevation, and of azimuth; bins of azimuth of each sweep.
uniform vec3 uPolarBins;

/// The azimuth at which the table's turns begin, degrees.
uniform float uTurnsFrom;

/// Elevations in degrees: where data begin, the lowest sweep, the highest sweep, and where data end.
uniform vec4 uElevations;

/// Low corner and edges of the unit cube, metres east, north and up of the antenna.
uniform vec3 uPolarLow;
uniform vec3 uPolarSize;

/// 1 / Earth radius, in 1 / metres; 0 for straight beams over flat ground.
uniform float uCurvature;

/// Stored values below this mean no data.
uniform float uNoDataBelow;

#if FOLDS
/// Values that differ by more than this are on two sides of a fold.
uniform float uFoldFrom;
#endif

/// Texels across the table.
#define TABLE_WIDTH 512.0

#if CROWDS
/// At most twice this many radials begin in one bin of azimuth.
#define MAX_HOPS 8
#endif

/// Half the beam width, and the largest gap between two sweeps that is interpolated, degrees.
/// Twin: radar/sweep-elevations.ts, widestGap
uniform vec2 uBeamReach;

#if RADIAL_ELEVATIONS
/// The maximum number of sweeps next to a place. Twin: radar/sweep-elevations.ts, sweepsAround
#define MAX_SWEEPS_AROUND 8
#endif

/// Gates with less weight take no part.
#define MIN_WEIGHT 1.0e-6

#ifdef SECOND_MOMENT
/// Stored values of a sweep's gates, and data values of another moment: see overlay-polar.glsl.
vec4 fetchBoth(SweepGates gates, out vec4 second);

/// The values of the other moment around the last place of `sampleVolume`.
GateValues lastSecond;
#endif

/// The angle of a direction, in radians; 0 if there is no direction. GLSL does not specify the precision of its own function.
/// Source: Abramowitz and Stegun 1964, 4.4.49, within 2e-8
float arcTangent(float y, float x) {
  vec2 size = abs(vec2(x, y));
  float t = min(size.x, size.y) / max(max(size.x, size.y), 1.0e-30);
  float q = t * t;
  float high = -0.0752896400 + q * (0.0429096138 + q * (-0.0161657367 + q * 0.0028662257));
  float angle = t * (1.0 + q * (-0.3333314528 + q * (0.1999355085 + q * (-0.1420889944 + q * (0.1065626393 + q * high)))));
  if (size.y > size.x) angle = 1.5707963268 - angle;
  if (x < 0.0) angle = 3.1415926536 - angle;
  return y < 0.0 ? -angle : angle;
}

/// The distance of a place above the antenna's horizontal plane, and along it; local: metres east, north and up of the antenna.
/// Twin: radar/polar-geometry.ts, climb. Sine and cosine are series, exact to float32 up to an eighth of the globe
vec2 climb(vec3 local) {
  float arc = length(local.xy);
  float angle = arc * uCurvature;
  float q = angle * angle;
  float chord = arc * (1.0 - q * (1.0 / 24.0 - q * (1.0 / 1920.0 - q / 322560.0)));
  float stretch = 1.0 + local.z * uCurvature;
  float up = local.z - 0.5 * stretch * chord * chord * uCurvature;
  return vec2(up, stretch * chord * (1.0 - q * (0.125 - q * (1.0 / 384.0 - q / 46080.0))));
}

/// Range (metres), azimuth and elevation (degrees) of a place. Twin: radar/polar-geometry.ts, localToBeam
vec3 toBeam(vec3 local) {
  vec2 climbed = climb(local);
  float azimuth = degrees(arcTangent(local.x, local.y));
  return vec3(length(climbed), azimuth < 0.0 ? azimuth + 360.0 : azimuth, degrees(arcTangent(climbed.x, climbed.y)));
}

vec4 fetchTable(float index) {
  float row = floor((index + 0.5) * (1.0 / TABLE_WIDTH));
  return texture2D(uPolarTable, vec2((index - row * TABLE_WIDTH + 0.5) * (1.0 / TABLE_WIDTH), (row + 0.5) * uPolarTableRow));
}

/// The number of the lower neighbour of an angle, and the place of the angle between it and the next neighbour, 0..1;
/// bin: the number of a neighbour, its angle, and the angles of the two after it.
vec2 locate(vec4 bin, float angle) {
  bool isSecond = angle >= bin.z;
  float from = isSecond ? bin.z : bin.y;
  float to = isSecond ? bin.w : bin.z;
  return vec2(bin.x + (isSecond ? 1.0 : 0.0), clamp((angle - from) / (to - from), 0.0, 1.0));
}

/// The number of a sweep's radial at or before an azimuth, and the place of the azimuth between it and the next radial, 0..1.
vec2 locateRadial(float sweep, float azimuth) {
  float turn = azimuth - uTurnsFrom;
  if (turn < 0.0) turn += 360.0;
  float bin = min(floor(turn * uPolarBins.y), uPolarBins.z - 1.0);
  vec4 radials = fetchTable(uTableBegins.z + sweep * uPolarBins.z + bin);
#if CROWDS
  for (int i = 0; i < MAX_HOPS; i++) {
    if (turn < radials.w) break;
    radials = vec4(radials.x + 2.0, radials.w, fetchTable(uTableBegins.y + radials.x + 2.0).zw);
  }
#endif
  return locate(radials, turn);
}

/// Range of a sweep's first gate, 1 / gate length, gates, rows to add: see radar/polar-table.ts
vec4 recordOf(float sweep) {
  return fetchTable(uTableBegins.x + sweep);
}

/// The middle of the texel of a radial's first gate; number: of the radial; record: of its sweep, see recordOf.
vec2 findRadial(float number, float radialsPerRow, vec4 record) {
  float row = floor((number + 0.5) / radialsPerRow);
  return vec2((number - row * radialsPerRow) * record.z, row + record.w) + 0.5;
}

/// The gates of a sweep around a place; record: of the sweep; radial: see locateRadial; range: metres; weight: of the sweep.
SweepGates gatesOfRadials(vec4 record, vec2 radial, float range, float weight) {
  float place = (range - record.x) * record.y;
  float inside = clamp(place, 0.0, record.z - 1.0);
  float low = floor(inside);
  float high = min(low + 1.0, record.z - 1.0);
  vec2 along = vec2(1.0 - (inside - low), inside - low);
  float radialsPerRow = floor((uGateTexels.x + 0.5) / record.z);
  vec2 before = findRadial(radial.x, radialsPerRow, record);
  vec2 after = findRadial(radial.x + 1.0, radialsPerRow, record);
  vec4 weights = vec4(weight * (1.0 - radial.y) * along, weight * radial.y * along);
  float hasGates = place >= -0.5 && place <= record.z - 0.5 ? 1.0 : 0.0;
  return SweepGates(vec4(before.x + low, before.x + high, after.x + low, after.x + high) * uGateTexels.y, vec2(before.y, after.y) * uGateTexels.z, weights * hasGates * step(MIN_WEIGHT, weights));
}

/// The same at an azimuth; beam: range, azimuth, elevation.
SweepGates gatesOfSweep(float sweep, vec3 beam, float weight) {
  return gatesOfRadials(recordOf(sweep), locateRadial(sweep, beam.y), beam.x, weight);
}

/// 1 if there may be data at an elevation, 0 below and above.
float isScanned(float elevation) {
  return elevation >= uElevations.x && elevation <= uElevations.w ? 1.0 : 0.0;
}

/// The weights of the sweeps below and above a place: linear between the two sweeps; a sweep alone reaches up to half a beam;
/// below, above: the distances to them, degrees. Twin: radar/interpolate-polar.ts, weighSweeps
vec2 weighSweeps(float below, float above) {
  float gap = below + above;
  if (gap > uBeamReach.y) return step(vec2(below, above), uBeamReach.xx);
  float share = clamp(below / gap, 0.0, 1.0);
  return vec2(1.0 - share, share);
}

#if RADIAL_ELEVATIONS
/// Elevation of a sweep between two of its radials, degrees; radial: see locateRadial. Twin: radar/sweep-elevations.ts, elevationAt
float elevationBetween(vec2 radial) {
  vec4 pair = fetchTable(uTableBegins.y + radial.x);
  return pair.x + radial.y * (pair.y - pair.x);
}

/// The gates of the nearest sweeps below and above a place, by the sweeps' elevations at its azimuth.
GatesAround gatesAround(vec3 beam) {
  // The number of a sweep, its radial (two numbers), its elevation.
  vec4 below = vec4(-1.0, 0.0, 0.0, -1000.0);
  vec4 above = vec4(-1.0, 0.0, 0.0, 1000.0);
  vec4 around = fetchTable(floor((clamp(beam.z, uElevations.y, uElevations.z) - uElevations.y) * uPolarBins.x));
  for (int i = 0; i < MAX_SWEEPS_AROUND; i++) {
    float sweep = around.x + float(i);
    if (sweep > around.y + 0.5) break;
    vec2 radial = locateRadial(sweep, beam.y);
    float elevation = elevationBetween(radial);
    if (elevation <= beam.z && elevation >= below.w) below = vec4(sweep, radial, elevation);
    if (elevation > beam.z && elevation < above.w) above = vec4(sweep, radial, elevation);
  }
  // A missing sweep is so far away that the gap is too wide to interpolate.
  vec2 weights = weighSweeps(beam.z - below.w, above.w - beam.z) * isScanned(beam.z);
  return GatesAround(gatesOfRadials(recordOf(max(below.x, 0.0)), below.yz, beam.x, weights.x), gatesOfRadials(recordOf(max(above.x, 0.0)), above.yz, beam.x, weights.y));
}
#else
/// Numbers of the sweeps below and above an elevation, and their weights.
vec4 locateSweeps(float elevation) {
  float inside = clamp(elevation, uElevations.y, uElevations.z);
  vec4 sweeps = fetchTable(floor((inside - uElevations.y) * uPolarBins.x));
  if (inside >= sweeps.z) sweeps = vec4(sweeps.x + 1.0, sweeps.zww);
  float last = uTableBegins.y - uTableBegins.x - 1.0;
  return vec4(sweeps.x, min(sweeps.x + 1.0, last), weighSweeps(inside - sweeps.y, sweeps.z - inside) * isScanned(elevation));
}

/// The gates of the sweeps below and above a place. Independent look-ups are next to each other, so that the GPU can do them in parallel.
GatesAround gatesAround(vec3 beam) {
  vec4 sweeps = locateSweeps(beam.z);
  vec4 below = recordOf(sweeps.x);
  vec4 above = recordOf(sweeps.y);
  vec2 radialBelow = locateRadial(sweeps.x, beam.y);
  vec2 radialAbove = locateRadial(sweeps.y, beam.y);
  return GatesAround(gatesOfRadials(below, radialBelow, beam.x, sweeps.z), gatesOfRadials(above, radialAbove, beam.x, sweeps.w));
}
#endif

/// The stored value of a gate; place: in the texture.
float fetchGate(vec2 place) {
  return decodeTexel(texture2D(uVolume, place));
}

vec4 fetchGates(SweepGates gates) {
  vec4 columns = gates.columns;
  vec2 rows = gates.rows;
  return vec4(fetchGate(vec2(columns.x, rows.x)), fetchGate(vec2(columns.y, rows.x)), fetchGate(vec2(columns.z, rows.y)), fetchGate(vec2(columns.w, rows.y)));
}

#if FOLDS
/// Whether a velocity folds between two shares of the domain. Twin: radar/polar-field.ts, polarField
bool isFolded(float from, float to) {
  return abs(to - from) > uFoldFrom * abs(uTableDomain.x);
}
#endif

bool joinGates(GateValues known, out float value) {
#if FOLDS
  return blendAtFold(known, uFoldFrom, value);
#else
  return blend(known, value);
#endif
}

/// The stored value of the gates around a place. False if there is no data.
bool valueOf(GatesAround gates, out float value) {
  return joinGates(valuesOfGates(gates, fetchGates(gates.below), fetchGates(gates.above), uNoDataBelow), value);
}

/// The stored value at a range, an azimuth and an elevation. False if there is no data.
/// Twin: radar/interpolate-polar.ts, interpolateBeam
bool sampleBeam(vec3 beam, out float value) {
  return valueOf(gatesAround(beam), value);
}

/// The stored value at a range and an azimuth of one sweep. False if there is no data.
/// Twin: radar/interpolate-polar.ts, interpolateSweep
bool sampleSweep(float sweep, vec3 beam, out float value) {
  SweepGates gates = gatesOfSweep(sweep, beam, 1.0);
  return valueOf(GatesAround(gates, SweepGates(gates.columns, gates.rows, vec4(0.0))), value);
}

/// The stored value at a point; p: unit cube. False if there is no data. Twin: radar/interpolate-polar.ts
bool sampleVolume(vec3 p, out float value) {
  GatesAround gates = gatesAround(toBeam(uPolarLow + p * uPolarSize));
#ifdef SECOND_MOMENT
  vec4 secondBelow;
  vec4 secondAbove;
  vec4 below = fetchBoth(gates.below, secondBelow);
  vec4 above = fetchBoth(gates.above, secondAbove);
  lastSecond = valuesOfGates(gates, secondBelow, secondAbove, -3.0e38);
  return joinGates(valuesOfGates(gates, below, above, uNoDataBelow), value);
#else
  return valueOf(gates, value);
#endif
}
