export { injectScript } from './page/inject-script.ts';
export { scriptUrl } from './page/script-url.ts';
export * as VolumeView from './index.ts';
