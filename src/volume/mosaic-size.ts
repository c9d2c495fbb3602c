/** Tiles per row and column from 'COLUMNSxROWS' ('10x10', '4 × 2'), or null if the text is anything else. */
export function parseMosaicSize(text: string): { columns: number; rows: number } | null {
  const match = /^\s*([1-9]\d{0,4})\s*[x×]\s*([1-9]\d{0,4})\s*$/i.exec(text);
  return match && { columns: Number(match[1]), rows: Number(match[2]) };
}
