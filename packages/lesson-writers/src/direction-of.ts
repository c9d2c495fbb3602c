// Languages that are written from right to left, in the script that is usual for them (CLDR 47, scriptMetadata.txt and likelySubtags.xml).
const rightToLeft = new Set([
  'ar',
  'arc',
  'ckb',
  'dv',
  'fa',
  'he',
  'iw',
  'ji',
  'ks',
  'ps',
  'sd',
  'syr',
  'ug',
  'ur',
  'yi',
]);
const scripts = new Set(['adlm', 'arab', 'hebr', 'mand', 'nkoo', 'rohg', 'samr', 'syrc', 'thaa']);

/** The direction in which a language is written; its script counts where the tag names one. @param language - as in the attribute `lang` of HTML */
export function directionOf(language: string): 'ltr' | 'rtl' {
  const [own, ...rest] = language.toLowerCase().split('-');
  const script = rest.find((part) => /^[a-z]{4}$/.test(part));
  return (script ? scripts.has(script) : rightToLeft.has(own)) ? 'rtl' : 'ltr';
}
