// The same library in plain JavaScript: larger, and about ten times as slow.
export { default as startOpenJpeg } from '@cornerstonejs/codec-openjpeg/decode';
