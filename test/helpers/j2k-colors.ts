/** 4 x 3 pixels of three colours as JPEG 2000, by OpenJPEG 2.5.4 with its reversible transformation of colours. */
const base64 =
  '/0//UQAvAAAAAAAEAAAAAwAAAAAAAAAAAAAABAAAAAMAAAAAAAAAAAADBwEBBwEBBwEB/1IADAAAAAEBAAQEAAH/XAAEQED/ZAAlAAFDcmVhdGVkIGJ5IE9wZW5KUEVHIHZlcnNpb24gMi41LjT/kAAKAAAAAABCAAH/k8+0NBiERlCFaeJ8Xoi2MO/fgHgPMd4RWJmapz7cR4DRK5ffgHgDDJJadN7TxemN12ui7UH/2Q==';

export const colorsInJ2k = {
  stream: Uint8Array.from(atob(base64), (sign) => sign.charCodeAt(0)),
  /** Their brightness: 0.2126 red + 0.7152 green + 0.0722 blue, in NumPy. */
  luma: [62, 60, 154, 74, 126, 149, 31, 193, 114, 77, 230, 85],
};
