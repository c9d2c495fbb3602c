// Loaded first, as a classic script: what the page says on the console, or fails to catch, in every engine.
window.__messages = [];
window.addEventListener(
  'error',
  (event) => {
    if (event instanceof CustomEvent) return; // An element's own, which the page expects.
    const target = event.target;
    const what = event.message || `${target?.localName} did not load ${target?.src ?? target?.href}`;
    window.__messages.push(`error: ${what}`);
  },
  true,
);
window.addEventListener('unhandledrejection', (event) => {
  window.__messages.push(`unhandled rejection: ${event.reason?.message ?? event.reason}`);
});
for (const level of ['log', 'info', 'warn', 'error', 'debug']) {
  const original = console[level];
  console[level] = (...args) => {
    window.__messages.push(`${level}: ${args.map(String).join(' ')}`);
    original.apply(console, args);
  };
}
