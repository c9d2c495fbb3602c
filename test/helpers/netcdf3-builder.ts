/** A variable of a NetCDF-3 file. */
export interface Netcdf3Variable {
  readonly name: string;
  readonly dimensions: readonly number[];
  /** An array with one number for each value: doubles, shorts, or bytes. */
  readonly data: Float64Array | Int16Array | Uint8Array;
  /** Whether the bytes are characters. */
  readonly isText?: boolean;
  /** Numbers are stored as doubles. */
  readonly attributes?: Readonly<Record<string, string | readonly number[]>>;
}

const be32 = (value: number): number[] => [24, 16, 8, 0].map((shift) => (value >>> shift) & 0xff);
const padded = (bytes: readonly number[]): number[] => [
  ...bytes,
  ...Array.from({ length: (4 - (bytes.length % 4)) % 4 }, () => 0),
];
const text = (value: string): number[] => [...be32(value.length), ...padded([...new TextEncoder().encode(value)])];

/** A classic NetCDF-3 file. @param dimensions - their lengths; 0 marks the record dimension, whose variables take no space in this file */
export function buildNetcdf3(
  dimensions: readonly number[],
  variables: readonly Netcdf3Variable[],
  records = 0,
): Uint8Array<ArrayBuffer> {
  const valueOf = (value: string | readonly number[]): number[] => {
    if (typeof value === 'string') return [...be32(2), ...text(value)];
    const view = new DataView(new ArrayBuffer(8 * value.length));
    value.forEach((number, i) => view.setFloat64(8 * i, number));
    return [...be32(6), ...be32(value.length), ...new Uint8Array(view.buffer)];
  };
  const attributesOf = (attributes: Netcdf3Variable['attributes'] = {}): number[] => {
    const entries = Object.entries(attributes);
    return entries.length === 0
      ? [...be32(0), ...be32(0)]
      : [
          ...be32(12),
          ...be32(entries.length),
          ...entries.flatMap(([name, value]) => [...text(name), ...valueOf(value)]),
        ];
  };
  const header = (begins: readonly number[]): number[] => [
    ...[0x43, 0x44, 0x46, 1],
    ...be32(records),
    ...[
      ...be32(10),
      ...be32(dimensions.length),
      ...dimensions.flatMap((length, i) => [...text(`d${i}`), ...be32(length)]),
    ],
    ...attributesOf(),
    ...[...be32(11), ...be32(variables.length)],
    ...variables.flatMap(({ name, dimensions: along, data, isText, attributes }, i) => [
      ...text(name),
      ...be32(along.length),
      ...along.flatMap(be32),
      ...attributesOf(attributes),
      ...be32(isText ? 2 : data instanceof Uint8Array ? 1 : data instanceof Int16Array ? 3 : 6),
      ...be32(0),
      ...be32(begins[i]),
    ]),
  ];
  const sizes = variables.map(({ data }) => Math.ceil(data.byteLength / 4) * 4);
  const start = header(sizes).length;
  const begins = sizes.map((_, i) => start + sizes.slice(0, i).reduce((sum, size) => sum + size, 0));
  const bytes = new Uint8Array(start + sizes.reduce((sum, size) => sum + size, 0));
  bytes.set(header(begins));
  const view = new DataView(bytes.buffer);
  variables.forEach(({ data }, i) => {
    if (data instanceof Uint8Array) bytes.set(data, begins[i]);
    else if (data instanceof Int16Array) data.forEach((value, at) => view.setInt16(begins[i] + 2 * at, value));
    else data.forEach((value, at) => view.setFloat64(begins[i] + 8 * at, value));
  });
  return bytes;
}
