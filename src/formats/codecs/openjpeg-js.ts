// The same library in plain JavaScript: larger, and 10 to 25 times as slow.
export { default as startOpenJpeg } from '@cornerstonejs/codec-openjpeg/decode';
