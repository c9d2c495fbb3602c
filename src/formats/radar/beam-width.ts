/** Degrees: the usual width of weather radars, for files that do not give it. */
const commonBeamWidth = 1;

/** The beam width if it is plausible, else the usual one. */
export function checkBeamWidth(beamWidth: number | undefined): number {
  return beamWidth !== undefined && beamWidth > 0.01 && beamWidth < 20 ? beamWidth : commonBeamWidth;
}
