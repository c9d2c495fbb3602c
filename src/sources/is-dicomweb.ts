/** Whether an address is that of a series, or of one of its instances, on a DICOMweb server. Source: DICOM PS3.18, 10.4.1 */
export const isDicomWeb = (url: string): boolean =>
  /\/studies\/[\d.]+\/series\/[\d.]+(\/instances\/[\d.]+)?(\?|$)/.test(url);
