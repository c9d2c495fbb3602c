import type { Messages } from './messages.ts';

/** The languages of the package, and their files. */
const files: Readonly<Record<string, () => Promise<{ readonly messages: Messages }>>> = {
  ar: () => import('./locales/ar.ts'),
  de: () => import('./locales/de.ts'),
  es: () => import('./locales/es.ts'),
  fr: () => import('./locales/fr.ts'),
  ja: () => import('./locales/ja.ts'),
  pt: () => import('./locales/pt.ts'),
  zh: () => import('./locales/zh.ts'),
};

/**
 * The messages of a language of the package.
 * @param code - BCP 47, like `de-AT`
 * @returns null where the package has none; its Chinese is in simplified characters only
 */
export async function loadLanguage(code: string): Promise<Messages | null> {
  const { language, script } = new Intl.Locale(code).maximize();
  if (!Object.hasOwn(files, language) || script === 'Hant') return null;
  return (await files[language]()).messages;
}
