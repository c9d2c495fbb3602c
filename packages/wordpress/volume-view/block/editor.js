/**
 * The block "Volume" in the editor. Its panel has a field for each attribute of the element, by the table that the server writes; the picture is
 * the element itself. Plain JavaScript: nothing builds this file.
 *
 * @license MIT
 */
(() => {
  const { createElement: el, Fragment, useEffect, useRef, useState } = window.wp.element;
  const { InspectorControls, MediaUpload, MediaUploadCheck, RichText, useBlockProps } = window.wp.blockEditor;
  const { Button, Notice, PanelBody, Placeholder, SelectControl, TextControl, TextareaControl, ToggleControl } =
    window.wp.components;
  const { decodeEntities } = window.wp.htmlEntities;
  const { __ } = window.wp.i18n;
  const { kinds, choices, descriptions, companions } = window.volumeViewTable;

  /** What the attributes that most authors need are called; the others have their own names. */
  const labels = {
    alt: __('What the picture shows, in words', 'volume-view'),
    poster: __('Image that is shown first', 'volume-view'),
    look: __('Look', 'volume-view'),
    'transfer-function': __('Colours and opacities', 'volume-view'),
    'value-window': __('Range of values (window)', 'volume-view'),
    shading: __('Light', 'volume-view'),
    projection: __('Projection', 'volume-view'),
    'light-factor': __('Brightness, a factor', 'volume-view'),
    'opacity-factor': __('Opacity, a factor', 'volume-view'),
    'camera-orbit': __('Position of the camera', 'volume-view'),
    'camera-target': __('What the camera looks at', 'volume-view'),
    'field-of-view': __('Angle of view', 'volume-view'),
    'auto-rotate': __('Turns by itself', 'volume-view'),
    controls: __('Buttons over the picture', 'volume-view'),
    width: __('Width, in pixels or percent', 'volume-view'),
    height: __('Height, in pixels', 'volume-view'),
    legend: __('Legend of the colours', 'volume-view'),
    readout: __('Value at the pointer', 'volume-view'),
    timeline: __('Timeline of several scans', 'volume-view'),
  };

  /** What words of attributes mean; the others stand as they are. */
  const words = {
    textbook: __('Textbook', 'volume-view'),
    flat: __('Thin and flat', 'volume-view'),
    mip: __('Brightest values', 'volume-view'),
    xray: __('X-ray', 'volume-view'),
    skin: __('Skin', 'volume-view'),
    bone: __('Bone (CT)', 'volume-view'),
    vessels: __('Vessels (CT)', 'volume-view'),
    gray: __('Grey', 'volume-view'),
    'ct-bone': __('CT, bone', 'volume-view'),
    'ct-soft-tissue': __('CT, soft tissue', 'volume-view'),
    'ct-angio': __('CT, vessels', 'volume-view'),
    'ct-lung': __('CT, lung', 'volume-view'),
    'radar-dbz': __('Radar, dBZ', 'volume-view'),
    'radar-velocity': __('Radar, velocity', 'volume-view'),
    diverging: __('Blue and red', 'volume-view'),
    lit: __('By a light at the eye', 'volume-view'),
    'ambient-occlusion': __('With soft shadows', 'volume-view'),
    unlit: __('Without light', 'volume-view'),
    max: __('Largest value', 'volume-view'),
    min: __('Smallest value', 'volume-view'),
    average: __('Mean value', 'volume-view'),
  };

  const sourceNames = ['src', 'alt', 'poster'];
  const lookNames = [
    'look',
    'transfer-function',
    'value-window',
    'shading',
    'projection',
    'light-factor',
    'opacity-factor',
  ];
  const cameraNames = ['camera-orbit', 'camera-target', 'field-of-view'];
  const sizeNames = ['width', 'height', 'controls', ...companions];
  const named = new Set([...sourceNames, ...lookNames, ...cameraNames, 'auto-rotate', ...sizeNames]);
  const otherNames = Object.keys(kinds).filter((name) => !named.has(name));

  /** Both are how WordPress draws fields from some version on; older ones take no notice. */
  const modern = { __nextHasNoMarginBottom: true, __next40pxDefaultSize: true };

  /** A text as the author wrote it: of one who may write no HTML, WordPress keeps `&amp;` for `&`. */
  const plain = (value) => (typeof value === 'string' ? decodeEntities(value) : value);

  /** The whole address; null for what is none yet, such as `https://`: authors type it letter by letter. */
  function readAddress(text) {
    try {
      return new URL(text, window.location.origin).href;
    } catch {
      return null;
    }
  }

  /** As the server takes them, see includes/addresses.php. */
  const isAddress = (text) => /^(?:https?:\/\/|\/)/i.test(text) && readAddress(text) !== null;
  const areAddresses = (text) => text.trim().split(/\s+/).every(isAddress);

  /** What the preview has; a relative address counts from the site, since the frame of the editor has no address of its own. */
  function attributesOfTag(attributes) {
    const absolute = (text) => text.trim().split(/\s+/).map(readAddress).join(' ');
    return Object.entries(kinds).flatMap(([name, kind]) => {
      const value = plain(attributes[name]);
      if (kind === 'flag') return value ? [[name, '']] : [];
      const text = (value ?? '').trim();
      if (text === '') return [];
      if (kind === 'address' || kind === 'addresses') return areAddresses(text) ? [[name, absolute(text)]] : [];
      if (kind === 'flag-or-text' && text.toLowerCase() === 'false') return [];
      return [[name, kind === 'flag-or-text' && text.toLowerCase() === 'true' ? '' : text]];
    });
  }

  /** The volume as a reader sees it. While an author writes, it waits for a pause. */
  function Preview({ attributes, view }) {
    const wanted = attributesOfTag(attributes);
    const [shown, setShown] = useState(wanted);
    const text = JSON.stringify(wanted);
    useEffect(() => {
      const timer = setTimeout(() => setShown(JSON.parse(text)), 400);
      return () => clearTimeout(timer);
    }, [text]);
    useEffect(() => {
      const here = view.current;
      const texts = new Map(shown);
      for (const name of Object.keys(kinds)) {
        if (!texts.has(name)) here.removeAttribute(name);
        else if (here.getAttribute(name) !== texts.get(name)) here.setAttribute(name, texts.get(name));
      }
    }, [shown]);
    return el('volume-view', { ref: view });
  }

  /** What stands in place of the picture until there is a file. */
  function Start({ library, onAddress }) {
    const [draft, setDraft] = useState('');
    const keep = (event) => {
      event.preventDefault();
      onAddress(draft.trim());
    };
    return el(
      Placeholder,
      {
        icon: 'visibility',
        label: __('Volume', 'volume-view'),
        instructions: __('A CT, an MRI, a radar scan: choose a file, or write its address.', 'volume-view'),
      },
      library,
      el(
        'form',
        { onSubmit: keep, style: { display: 'flex', gap: '8px', alignItems: 'end' } },
        el(TextControl, {
          ...modern,
          label: __('Address of the file', 'volume-view'),
          placeholder: 'https://',
          value: draft,
          onChange: setDraft,
        }),
        el(
          Button,
          { variant: 'secondary', type: 'submit', disabled: !areAddresses(draft) },
          __('Use this address', 'volume-view'),
        ),
      ),
    );
  }

  function Edit({ attributes, setAttributes, isSelected }) {
    const view = useRef(null);
    const set = (name) => (value) => setAttributes({ [name]: value });
    const source = plain(attributes.src).trim();

    const field = (name) => {
      const kind = kinds[name] ?? 'flag';
      const label = labels[name] ?? name;
      const help = descriptions[name];
      const value = plain(attributes[name]);
      if (kind === 'flag')
        return el(ToggleControl, { ...modern, key: name, label, help, checked: Boolean(value), onChange: set(name) });
      if (name === 'alt') return el(TextareaControl, { ...modern, key: name, label, value, onChange: set(name) });
      const text = el(TextControl, { ...modern, key: name, label, help, value, onChange: set(name) });
      const list = choices[name];
      if (!list) return text;
      const isOwn = value !== '' && !list.includes(value);
      const options = [
        { value: '', label: __('As the data suggest', 'volume-view') },
        ...list.map((word) => ({ value: word, label: words[word] ?? word })),
        ...(isOwn ? [{ value, label: __('As written below', 'volume-view') }] : []),
      ];
      const select = el(SelectControl, { ...modern, key: name, label, value, options, onChange: set(name) });
      if (kind === 'choice' || name === 'look') return select;
      return el(
        Fragment,
        { key: name },
        select,
        el(TextControl, {
          ...modern,
          label: __('Or in words of your own', 'volume-view'),
          help,
          value,
          onChange: set(name),
        }),
      );
    };

    /** The uploaded file: of a large image, WordPress shows a smaller copy, in which a mosaic has other values. */
    const choose = (name) => (file) => {
      const more = name === 'src' && attributes.alt === '' && file.alt ? { alt: file.alt } : {};
      setAttributes({ [name]: (name === 'src' && file.originalImageURL) || file.url, ...more });
    };
    const library = (name, words) =>
      el(
        MediaUploadCheck,
        { key: `${name}-library` },
        el(MediaUpload, {
          onSelect: choose(name),
          ...(name === 'poster' ? { allowedTypes: ['image'] } : {}),
          render: ({ open }) => el(Button, { variant: 'secondary', onClick: open }, words),
        }),
      );
    const address = el(TextControl, {
      ...modern,
      key: 'src',
      type: 'text',
      label: __('Address of the file', 'volume-view'),
      placeholder: 'https://',
      value: plain(attributes.src),
      onChange: set('src'),
    });
    const wrong =
      source !== '' &&
      !areAddresses(source) &&
      el(
        Notice,
        { key: 'wrong', status: 'warning', isDismissible: false },
        __('An address has to begin with https://, http:// or /.', 'volume-view'),
      );

    /** The view that the author has turned the picture to. */
    const keepView = () => {
      const seen = view.current?.getView?.() ?? {};
      setAttributes(Object.fromEntries(cameraNames.flatMap((name) => (name in seen ? [[name, seen[name]]] : []))));
    };
    const resetView = () => setAttributes(Object.fromEntries(cameraNames.map((name) => [name, ''])));

    const sidePanel = el(
      InspectorControls,
      null,
      el(
        PanelBody,
        { title: __('Volume', 'volume-view') },
        address,
        wrong,
        library('src', __('Choose from the media library', 'volume-view')),
        el(
          'p',
          { style: { marginTop: '8px' } },
          __(
            'A rendered head shows a face, and files may hold names of persons. Publish only what you may publish.',
            'volume-view',
          ),
        ),
        field('alt'),
        field('poster'),
        library('poster', __('Choose an image', 'volume-view')),
      ),
      el(PanelBody, { title: __('Look', 'volume-view') }, ...lookNames.map(field)),
      el(
        PanelBody,
        { title: __('Camera', 'volume-view') },
        el('p', null, __('Turn the picture, then keep the view for your readers.', 'volume-view')),
        el(
          'p',
          null,
          el(
            Button,
            { variant: 'secondary', disabled: source === '', onClick: keepView },
            __('Start from this view', 'volume-view'),
          ),
          ' ',
          el(Button, { variant: 'tertiary', onClick: resetView }, __('Reset', 'volume-view')),
        ),
        ...[...cameraNames, 'auto-rotate'].map(field),
      ),
      el(PanelBody, { title: __('Size and buttons', 'volume-view'), initialOpen: false }, ...sizeNames.map(field)),
      el(PanelBody, { title: __('All other attributes', 'volume-view'), initialOpen: false }, ...otherNames.map(field)),
    );

    if (source === '' || wrong) {
      return el(
        'figure',
        useBlockProps(),
        sidePanel,
        el(Start, {
          library: library('src', __('Choose from the media library', 'volume-view')),
          onAddress: set('src'),
        }),
      );
    }
    return el(
      'figure',
      useBlockProps(),
      sidePanel,
      el(Preview, { attributes, view }),
      (isSelected || attributes.caption !== '') &&
        el(RichText, {
          tagName: 'figcaption',
          className: 'wp-element-caption',
          placeholder: __('Add a caption', 'volume-view'),
          value: attributes.caption,
          allowedFormats: ['core/bold', 'core/italic', 'core/link', 'core/subscript', 'core/superscript'],
          onChange: set('caption'),
        }),
    );
  }

  window.wp.blocks.registerBlockType('volume-view/volume', { edit: Edit, save: () => null });
})();
