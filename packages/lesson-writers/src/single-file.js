// The script of a lesson in one file. The element's own scripts are texts of the page; each runs when the element asks for it: a part by
// its name in `volumeViewParts`, x3dom by its global.
{
  const own = document.currentScript;

  /** @param {HTMLScriptElement} text */
  const run = (text) => {
    const script = document.createElement('script');
    script.nonce = own?.nonce;
    script.textContent = text.textContent;
    document.head.append(script);
    script.remove();
  };

  /**
   * A property that is set when it is first read.
   * @param {any} holder
   * @param {string} name
   * @param {() => void} set
   */
  const provide = (holder, name, set) =>
    Object.defineProperty(holder, name, {
      configurable: true,
      get() {
        delete holder[name];
        set();
        return holder[name];
      },
    });

  const page = /** @type {any} */ (globalThis);
  const texts = /** @type {NodeListOf<HTMLScriptElement>} */ (document.querySelectorAll('script[data-part]'));
  page.volumeViewParts = {};
  for (const text of texts) provide(page.volumeViewParts, text.dataset.part ?? '', () => run(text));
  const x3dom = /** @type {HTMLScriptElement} */ (document.querySelector('script[data-x3dom]'));
  provide(page, 'x3dom', () => {
    run(x3dom);
    page.x3dom.debug.maxLinesToLog = -1; // Nobody reads what it writes into hidden elements.
  });
}
