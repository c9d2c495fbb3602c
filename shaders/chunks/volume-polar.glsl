/// Gates of all sweeps, as many whole radials of one sweep in a row as fit it: see radar/polar-layout.ts
uniform sampler2D uVolume;

/// Texels across; 1 / texels across and down.
uniform vec3 uGateTexels;

/// Where angles lie between sweeps and radials, and what sweeps are like: see radar/polar-table.ts
uniform sampler2D uPolarTable;

/// 1 / texels down the table.
uniform float uPolarTableRow;

/// First texel of the table's sweeps, radials and bins of azimuth.
uniform vec3 uTableBegins;

/// Bins per degree of elevation, and of azimuth; bins of azimuth of each sweep.
uniform vec3 uPolarBins;

/// Azimuth from which the table's turns are counted, degrees.
uniform float uTurnsFrom;

/// Elevations, degrees: where data begin, of the lowest and of the highest sweep, where data end.
uniform vec4 uElevations;

/// Low corner and edges of the unit cube, metres east, north and up of the antenna.
uniform vec3 uPolarLow;
uniform vec3 uPolarSize;

/// 1 / Earth radius, 1 / metres; 0 for straight beams over a flat ground.
uniform float uCurvature;

/// Stored values below this are no data.
uniform float uNoDataBelow;

/// Values more than this apart are on two sides of a fold.
uniform float uFoldFrom;

/// Texels across the table.
#define TABLE_WIDTH 512.0

/// Radials that begin in one bin of azimuth are at most twice as many.
#define MAX_HOPS 8

#if RADIAL_ELEVATIONS
/// Half the width of the beam, degrees.
uniform float uHalfBeam;

/// More sweeps can't be next to a place. Twin: radar/sweep-elevations.ts, sweepsAround
#define MAX_SWEEPS_AROUND 8
#endif

/// Gates of less weight take no part.
#define MIN_WEIGHT 1.0e-6

/// What has been gathered of the gates around a point.
struct GatesAround {
  float sum;
  float weights;
  float low;
  float high;
  float heaviest;
  float heaviestValue;
};

GatesAround nothingYet() {
  return GatesAround(0.0, 0.0, 3.0e38, -3.0e38, 0.0, 0.0);
}

#ifdef SECOND_MOMENT
/// Data value of another moment of the same gates, where theirs is; below -3e38 there is none. place: in the texture.
float fetchSecond(vec2 place);

/// What of it is around the place that `sampleVolume` was asked for last, by the same weights; whether it is gathered now.
GatesAround second;
bool gathersSecond = false;
#endif

/// Angle of a direction, radians; 0 for none. GLSL leaves open how good its own is.
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

/// How far a place is above the antenna's horizontal plane and along it; local: metres east, north and up of the antenna.
/// Twin: radar/polar-geometry.ts, climb. Sine and cosine as series, exact to float32 up to an eighth of the globe
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
  float row = floor((index + 0.5) / TABLE_WIDTH);
  return texture2D(uPolarTable, vec2((index - row * TABLE_WIDTH + 0.5) / TABLE_WIDTH, (row + 0.5) * uPolarTableRow));
}

/// Number of the lower neighbour of an angle, and how far it is from it to the next one, 0..1;
/// bin: number of a neighbour, its angle and those of the two after it.
vec2 locate(vec4 bin, float angle) {
  bool isSecond = angle >= bin.z;
  float from = isSecond ? bin.z : bin.y;
  float to = isSecond ? bin.w : bin.z;
  return vec2(bin.x + (isSecond ? 1.0 : 0.0), clamp((angle - from) / (to - from), 0.0, 1.0));
}

void addValue(float value, float weight, inout GatesAround gates) {
  gates.sum += weight * value;
  gates.weights += weight;
  gates.low = min(gates.low, value);
  gates.high = max(gates.high, value);
  if (weight > gates.heaviest) {
    gates.heaviest = weight;
    gates.heaviestValue = value;
  }
}

/// texel: the gate's middle.
void addGate(vec2 texel, float weight, inout GatesAround gates) {
  if (weight < MIN_WEIGHT) return;
  float value = decodeTexel(texture2D(uVolume, texel * uGateTexels.yz));
  if (value >= uNoDataBelow) addValue(value, weight, gates);
#ifdef SECOND_MOMENT
  if (!gathersSecond) return;
  float other = fetchSecond(texel * uGateTexels.yz);
  if (other > -3.0e38) addValue(other, weight, second);
#endif
}

/// Number of the radial of a sweep at or before an azimuth, and how far it is from it to the next one, 0..1.
vec2 locateRadial(float sweep, float azimuth) {
  float turn = azimuth - uTurnsFrom;
  if (turn < 0.0) turn += 360.0;
  float bin = min(floor(turn * uPolarBins.y), uPolarBins.z - 1.0);
  vec4 radials = fetchTable(uTableBegins.z + sweep * uPolarBins.z + bin);
  for (int i = 0; i < MAX_HOPS; i++) {
    if (turn < radials.w) break;
    radials = vec4(radials.x + 2.0, radials.w, fetchTable(uTableBegins.y + radials.x + 2.0).zw);
  }
  return locate(radials, turn);
}

/// Middle of the texel of a radial's first gate; number: of the radial; record: of its sweep.
vec2 findRadial(float number, float radialsPerRow, vec4 record) {
  float row = floor((number + 0.5) / radialsPerRow);
  return vec2((number - row * radialsPerRow) * record.z, row + record.w) + 0.5;
}

/// The four gates of a sweep around a place; radial: see locateRadial; range: metres.
void addGates(float sweep, vec2 radial, float range, float weight, inout GatesAround gates) {
  // Range of the first gate, 1 / gate length, gates, rows to add: see radar/polar-table.ts
  vec4 record = fetchTable(uTableBegins.x + sweep);
  float place = (range - record.x) * record.y;
  if (place < -0.5 || place > record.z - 0.5) return;
  float inside = clamp(place, 0.0, record.z - 1.0);
  float low = floor(inside);
  float high = min(low + 1.0, record.z - 1.0);
  float along = inside - low;
  float radialsPerRow = floor((uGateTexels.x + 0.5) / record.z);
  vec2 before = findRadial(radial.x, radialsPerRow, record);
  vec2 after = findRadial(radial.x + 1.0, radialsPerRow, record);
  addGate(vec2(before.x + low, before.y), weight * (1.0 - radial.y) * (1.0 - along), gates);
  addGate(vec2(before.x + high, before.y), weight * (1.0 - radial.y) * along, gates);
  addGate(vec2(after.x + low, after.y), weight * radial.y * (1.0 - along), gates);
  addGate(vec2(after.x + high, after.y), weight * radial.y * along, gates);
}

/// The same where the sweep has any weight; beam: range, azimuth, elevation.
void addSweep(float sweep, vec3 beam, float weight, inout GatesAround gates) {
  if (weight >= MIN_WEIGHT) addGates(sweep, locateRadial(sweep, beam.y), beam.x, weight, gates);
}

#if RADIAL_ELEVATIONS
/// Elevation of a sweep between two of its radials, degrees; radial: see locateRadial. Twin: radar/sweep-elevations.ts, elevationAt
float elevationBetween(vec2 radial) {
  vec4 pair = fetchTable(uTableBegins.y + radial.x);
  return pair.x + radial.y * (pair.y - pair.x);
}

/// The gates of the nearest sweeps below and above a place, by the elevations that they have at its azimuth.
/// Twin: radar/interpolate-polar.ts, weighSweeps
void addSweepsAround(vec3 beam, inout GatesAround gates) {
  // Number of a sweep, its radial, its elevation.
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
  bool hasBoth = below.x >= 0.0 && above.x >= 0.0;
  float share = hasBoth ? (beam.z - below.w) / (above.w - below.w) : below.x < 0.0 ? 1.0 : 0.0;
  if (!hasBoth && min(beam.z - below.w, above.w - beam.z) > uHalfBeam) return;
  if (share < 1.0 - MIN_WEIGHT) addGates(below.x, below.yz, beam.x, 1.0 - share, gates);
  if (share >= MIN_WEIGHT) addGates(above.x, above.yz, beam.x, share, gates);
}
#else
/// The gates of the sweeps below and above a place. Twin: radar/interpolate-polar.ts, weighSweeps
void addSweepsAround(vec3 beam, inout GatesAround gates) {
  float elevation = clamp(beam.z, uElevations.y, uElevations.z);
  vec2 sweep = locate(fetchTable(floor((elevation - uElevations.y) * uPolarBins.x)), elevation);
  addSweep(sweep.x, beam, 1.0 - sweep.y, gates);
  addSweep(sweep.x + 1.0, beam, sweep.y, gates);
}
#endif

/// Stored value of what has been gathered. False where there is no data.
bool blend(GatesAround gates, float foldFrom, out float value) {
  bool isFold = gates.high - gates.low > foldFrom;
  value = isFold ? gates.heaviestValue : gates.sum / max(gates.weights, 0.5);
  return gates.weights >= 0.5;
}

/// Stored value at a range, an azimuth and an elevation. False where there is no data.
/// Twin: radar/interpolate-polar.ts, interpolateBeam
bool sampleBeam(vec3 beam, out float value) {
  value = 0.0;
  if (beam.z < uElevations.x || beam.z > uElevations.w) return false;
  GatesAround gates = nothingYet();
  addSweepsAround(beam, gates);
  return blend(gates, uFoldFrom, value);
}

/// Stored value at a range and an azimuth of one sweep. False where there is no data.
/// Twin: radar/interpolate-polar.ts, interpolateSweep
bool sampleSweep(float sweep, vec3 beam, out float value) {
  GatesAround gates = nothingYet();
  addSweep(sweep, beam, 1.0, gates);
  return blend(gates, uFoldFrom, value);
}

/// Whether a velocity folds between two shares of the domain. Twin: radar/polar-field.ts, polarField
bool isFolded(float from, float to) {
  return abs(to - from) > uFoldFrom * abs(uTableDomain.x);
}

/// Stored value at a point; p: unit cube. False where there is no data. Twin: radar/interpolate-polar.ts
bool sampleVolume(vec3 p, out float value) {
#ifdef SECOND_MOMENT
  second = nothingYet();
  gathersSecond = true;
#endif
  bool valid = sampleBeam(toBeam(uPolarLow + p * uPolarSize), value);
#ifdef SECOND_MOMENT
  gathersSecond = false;
#endif
  return valid;
}
