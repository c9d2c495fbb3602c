// from-disk.html: makes a page that contains a volume, and so can be opened from disk.
(() => {
  /** Some browsers can't open the pages of larger files. */
  const MAX_BYTES = 64 * 2 ** 20;
  const [file, alt, save, status, place] = ['file', 'alt', 'save', 'status', 'view'].map((id) =>
    document.getElementById(id),
  );
  /** @type {{ name: string, url: string } | null} the file as a data: URL */
  let chosen = null;

  /** @param {Blob} blob @returns {Promise<string>} a data: URL without a type: the element looks at the bytes */
  const readAsUrl = (blob) =>
    new Promise((resolve, reject) => {
      const reader = new FileReader();
      reader.onload = () => resolve(reader.result);
      reader.onerror = () => reject(reader.error);
      reader.readAsDataURL(new Blob([blob], { type: 'application/octet-stream' }));
    });

  /** The tag, created in a document of its own or in this one. Attributes are set by methods, so no HTML text is composed. */
  const makeView = (owner) => {
    const view = owner.createElement('volume-view');
    view.setAttribute('controls', '');
    view.setAttribute('alt', alt.value || chosen.name);
    view.setAttribute('src', chosen.url);
    return view;
  };

  const writePage = () => {
    const page = document.implementation.createHTMLDocument(alt.value || chosen.name);
    const meta = page.createElement('meta');
    meta.setAttribute('charset', 'utf-8');
    const script = page.createElement('script');
    script.setAttribute('src', 'volume-view.iife.js');
    page.head.prepend(meta, script);
    page.body.append(makeView(page));
    return `<!doctype html>\n${page.documentElement.outerHTML}\n`;
  };

  const take = async (blob) => {
    chosen = null;
    save.disabled = true;
    place.replaceChildren();
    if (!blob) return;
    if (blob.size > MAX_BYTES) {
      status.textContent = `${blob.name} has ${Math.round(blob.size / 2 ** 20)} MiB; a page from disk can hold files of up to ${MAX_BYTES / 2 ** 20} MiB. Put this one on a web server.`;
      return;
    }
    try {
      chosen = { name: blob.name, url: await readAsUrl(blob) };
    } catch (error) {
      status.textContent = `${blob.name} can not be read: ${error.message}`;
      return;
    }
    status.textContent = `This is ${blob.name}:`;
    place.replaceChildren(makeView(document));
    save.disabled = false;
  };
  file.addEventListener('change', () => void take(file.files[0]));

  save.addEventListener('click', () => {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([writePage()], { type: 'text/html' }));
    link.download = `${chosen.name.replace(/(\.\w{1,5}){1,2}$/, '') || 'volume'}.html`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
    status.textContent = `${link.download} was saved. Move it into the folder of this page, and open it.`;
  });
})();
