import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import { files } from './helpers/data.ts';

for (const [name, bytes] of Object.entries(files)) {
  test(`pages/data/${name} is what helpers/data.ts makes`, () => {
    const path = join(import.meta.dirname, 'pages/data', name);
    if (process.env.WRITE_DATA) writeFileSync(path, bytes);
    // Compared as one text: a list of bytes that differ helps nobody.
    expect(readFileSync(path).equals(bytes), 'WRITE_DATA=1 writes it anew').toBe(true);
  });
}
