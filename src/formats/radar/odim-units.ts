/** The unit of a quantity, '' if unknown. @param inMetres - see `isInMetres`: heights (HGHT) were in km before */
export function odimUnit(quantity: string, inMetres: boolean): string {
  const unit = odimUnits.get(quantity) ?? '';
  return unit === 'km' && inMetres ? 'm' : unit;
}

/**
 * Units of ODIM_H5's quantities, which its files do not contain. Source: ODIM_H5 2.4, table 16; radial winds that are
 * unfolded (VRADDH, VRADDV) from 2.3.
 */
const odimUnits: ReadonlyMap<string, string> = new Map(
  Object.entries({
    dBZ: ['TH', 'TV', 'TX', 'DBZ', 'DBZH', 'DBZV', 'DBZX', 'DBZH_CLEAN', 'UDBZH', 'UDBZV'],
    dB: ['ZDR', 'UZDR', 'LDR', 'ULDR', 'SNR', 'SNRH', 'SNRV', 'SNRHC', 'SNRVC', 'CCOR', 'CCORH', 'CCORV', 'PIA'],
    dBm: ['NPH', 'NPV'],
    'm/s': [
      'VRAD',
      'VRADH',
      'VRADV',
      'VRADDH',
      'VRADDV',
      'WRAD',
      'WRADH',
      'WRADV',
      'UVRADH',
      'UVRADV',
      'UWRADH',
      'UWRADV',
    ],
    degrees: ['PHIDP', 'UPHIDP'],
    'degrees/km': ['KDP', 'UKDP'],
    'mm/h': ['RATE'],
    mm: ['ACRR'],
    km: ['HGHT'],
  }).flatMap(([unit, quantities]) => quantities.map((quantity) => [quantity, unit] as const)),
);
