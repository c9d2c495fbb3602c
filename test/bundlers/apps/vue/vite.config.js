import vue from '@vitejs/plugin-vue';

const isCustomElement = (tag) => tag.startsWith('volume-');

export default { plugins: [vue({ template: { compilerOptions: { isCustomElement } } })] };
