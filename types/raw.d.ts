// `import text from './chunk.glsl?raw'` is the file's text, in vite, in the test runner and in the build.
declare module '*?raw' {
  const text: string;
  export default text;
}
