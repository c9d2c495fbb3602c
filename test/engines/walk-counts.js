// Loaded before the package, as a classic script: counts what it holds of the page, and can end or deafen its workers.
(() => {
  const contexts = new Set();
  const workers = new Set();
  /** Those that have an order. */
  const busy = new Set();
  const urls = new Set();
  const listeners = new Map();
  const counts = {
    /** The workers of the next loads hear nothing: loads that stall. */
    deaf: 0,
    busy,
    read: () => ({
      contexts: [...contexts].filter((context) => context.deref()?.isContextLost() === false).length,
      workers: workers.size,
      blobs: urls.size,
      listeners: [...listeners.values()].reduce((sum, all) => sum + all.size, 0),
      nodes: document.querySelectorAll('*').length,
    }),
    listeners: () => [...listeners].map(([name, all]) => `${name} ${all.size}`).join(', '),
  };
  window.__counts = counts;

  const getContext = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (...args) {
    const context = getContext.apply(this, args);
    if (context instanceof WebGLRenderingContext || context instanceof WebGL2RenderingContext)
      contexts.add(new WeakRef(context)); // Held, it would hold its scene.
    return context;
  };

  const OwnWorker = window.Worker;
  window.Worker = class extends OwnWorker {
    #deaf = false;
    constructor(...args) {
      super(...args);
      workers.add(this);
      this.addEventListener('message', ({ data }) => {
        if (['done', 'failed', 'needs-main-thread', 'stopped'].includes(data.type)) busy.delete(this);
      });
    }
    postMessage(...args) {
      if (args[0].request) {
        busy.add(this);
        this.#deaf ||= counts.deaf > 0 && counts.deaf-- > 0;
      }
      if (!this.#deaf) super.postMessage(...args);
    }
    terminate() {
      workers.delete(this);
      busy.delete(this);
      super.terminate();
    }
  };

  const { createObjectURL, revokeObjectURL } = URL;
  URL.createObjectURL = (...args) => {
    const url = createObjectURL.apply(URL, args);
    urls.add(url);
    return url;
  };
  URL.revokeObjectURL = (url) => {
    urls.delete(url);
    revokeObjectURL.call(URL, url);
  };

  for (const target of [window, document]) {
    const name = target === window ? 'window' : 'document';
    const { addEventListener, removeEventListener } = target;
    const keyOf = (type, options) =>
      `${name} ${type} ${(typeof options === 'object' ? options?.capture : options) === true}`;
    target.addEventListener = (type, listener, options) => {
      const key = keyOf(type, options);
      if (!listeners.has(key)) listeners.set(key, new Set());
      listeners.get(key).add(listener);
      const forget = () => listeners.get(key).delete(listener);
      options?.signal?.addEventListener('abort', forget);
      if (options?.once) addEventListener.call(target, type, forget, options);
      addEventListener.call(target, type, listener, options);
    };
    target.removeEventListener = (type, listener, options) => {
      listeners.get(keyOf(type, options))?.delete(listener);
      removeEventListener.call(target, type, listener, options);
    };
  }
})();
