/** Millimetres of symbols. Their case counts: a millimetre is no megametre. Source: OME schema 2016-06, UnitsLength; NRRD, "space units" */
const symbols: ReadonlyMap<string, number> = new Map([
  ['\u00c5', 1e-7],
  ['pm', 1e-9],
  ['nm', 1e-6],
  ['um', 1e-3],
  ['mm', 1],
  ['cm', 10],
  ['dm', 100],
  ['m', 1e3],
  ['hm', 1e5],
  ['km', 1e6],
  ['in', 25.4],
  ['ft', 304.8],
  ['pt', 25.4 / 72],
]);

/** Millimetres of words, in lower case and in the singular. Source: OME-Zarr 0.5, "axes" metadata: UDUNITS-2 names */
const words: ReadonlyMap<string, number> = new Map([
  ['angstrom', 1e-7],
  ['picometer', 1e-9],
  ['nanometer', 1e-6],
  ['micrometer', 1e-3],
  ['micron', 1e-3],
  ['millimeter', 1],
  ['centimeter', 10],
  ['decimeter', 100],
  ['meter', 1e3],
  ['hectometer', 1e5],
  ['kilometer', 1e6],
  ['inch', 25.4],
  ['foot', 304.8],
  ['yard', 914.4],
  ['mile', 1_609_344],
]);

/** Millimetres of a unit of length, a symbol or a word; undefined for what is none that is known, such as a pixel. */
export function millimetresOf(unit: unknown): number | undefined {
  if (typeof unit !== 'string') return undefined;
  const name = unit.trim();
  const word = name
    .toLowerCase()
    .replace(/s$/, '')
    .replace(/metre$/, 'meter');
  // The sign for a millionth is the Greek letter or a sign of its own.
  return symbols.get(name.replace(/^[\u00b5\u03bc]/, 'u')) ?? words.get(word);
}
