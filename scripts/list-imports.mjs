// The imports of a file, from its syntax tree.
import { parseSync } from 'vite';

const IMPORTS = new Set([
  'ImportDeclaration',
  'ExportNamedDeclaration',
  'ExportAllDeclaration',
  'ImportExpression',
  'TSImportType',
]);

/**
 * What is imported: a text, and where it is in the code with its quotation marks.
 * @typedef {{ value: string, start: number, end: number, isLazy: boolean }} Import
 */

/** @param {any} node - of a syntax tree @returns {Import[]} */
function listIn(node) {
  if (node === null || typeof node !== 'object') return [];
  const isLazy = node.type === 'ImportExpression';
  const source =
    isLazy && node.source?.type === 'TemplateLiteral' ? node.source.quasis[0].value.cooked : node.source?.value;
  const own =
    IMPORTS.has(node.type) && typeof source === 'string'
      ? [{ value: source, start: node.source.start, end: node.source.end, isLazy }]
      : [];
  return [...own, ...Object.values(node).flatMap(listIn)];
}

/**
 * All imports of a file, in the order of the code. Those of types count, and so does `import('…')`, in code and in types.
 * @param {string} file - its name says the language
 * @param {string} code
 */
export function listImports(file, code) {
  const { program, errors } = parseSync(file, code);
  if (errors.length > 0) throw new Error(`${file} cannot be read: ${errors[0].message}`);
  return listIn(program);
}
