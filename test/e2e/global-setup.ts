import { startStaticServer } from '../../scripts/static-server.mjs';

/** Serve the checkout for the run; specs read VOLUME_VIEW_URL (as baseURL) and VOLUME_VIEW_CROSS_URL. */
export default async function setUp() {
  const server = await startStaticServer({ takesPages: true });
  process.env.VOLUME_VIEW_URL = server.url;
  process.env.VOLUME_VIEW_CROSS_URL = server.crossUrl;
  return () => server.close();
}
