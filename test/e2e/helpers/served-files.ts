import type { Page } from '@playwright/test';

/**
 * Have a page find files at an address that has none; another name there is 404.
 * @param files - by their names
 * @returns the paths that the page asks for from now on, of whatever files
 */
export async function serveFiles(
  page: Page,
  folder: string,
  files: Readonly<Record<string, Buffer>>,
): Promise<readonly string[]> {
  const asked: string[] = [];
  page.on('request', (request) => asked.push(new URL(request.url()).pathname));
  await page.route(`**${folder}/*`, (route) => {
    const body = files[new URL(route.request().url()).pathname.split('/').at(-1)!];
    return body ? route.fulfill({ body }) : route.fulfill({ status: 404 });
  });
  return asked;
}
