import type { FuzzCase } from './fuzz-case.ts';

export const namedCases: Readonly<Record<string, () => FuzzCase>> = {};
