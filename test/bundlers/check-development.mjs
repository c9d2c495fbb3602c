// The development server, which an author sees first: it bundles packages in another way than the build.
import { checkPicture, made, openUrl } from './open-app.mjs';

/** @param {string} root - of the app */
export async function checkDevelopment(root) {
  const { createServer } = await import('vite'); // Installed only now.
  const server = await createServer({
    root,
    logLevel: 'error',
    cacheDir: `${root}/cache`,
    server: { host: '127.0.0.1', port: 0 },
    plugins: [
      {
        name: 'volume',
        configureServer: ({ middlewares }) =>
          void middlewares.use((request, response, next) => {
            const bytes = made[/** @type {keyof typeof made} */ (request.url ?? '')]?.();
            if (bytes) response.end(bytes);
            else if (request.url === '/favicon.ico') response.writeHead(204).end();
            else next();
          }),
      },
    ],
  });
  await server.listen();
  try {
    return await openUrl(server.resolvedUrls?.local[0] ?? '', (app) =>
      checkPicture({
        ...app,
        get troubles() {
          return app.troubles.filter((text) => !text.includes('Lit is in dev mode'));
        },
      }),
    );
  } finally {
    await server.close();
  }
}
