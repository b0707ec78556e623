// A document with just enough of the DOM for the page's script to build live figures as HTML.
// tools/stills.py writes that HTML into the book, to be shown until the script has loaded.

const ENTITIES = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" };
const escapeHtml = (text) => String(text).replace(/[&<>"]/g, (character) => ENTITIES[character]);
const toKebabCase = (name) => name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
const doNothing = () => {};

class Text {
  constructor(text) {
    this.textContent = String(text);
  }
  get outerHTML() {
    return escapeHtml(this.textContent);
  }
}

class Style {
  setProperty(name, value) {
    this[name] = value;
  }
}

class Element {
  constructor(tag) {
    this.tag = tag;
    this.attributes = new Map();
    this.childNodes = [];
    this.style = new Style();
    this.dataset = new Proxy(this, {
      get: (_, name) => this.getAttribute(`data-${toKebabCase(name)}`) ?? undefined,
      set: (_, name, value) => (this.setAttribute(`data-${toKebabCase(name)}`, value), true),
    });
    this.classList = {
      contains: (name) => this.className.split(" ").includes(name),
      add: (name) => this.classList.toggle(name, true),
      toggle: (name, on) => {
        const rest = this.className.split(" ").filter((other) => other && other !== name);
        this.className = [...rest, ...(on ? [name] : [])].join(" ");
      },
    };
  }
  setAttribute(name, value) {
    this.attributes.set(name, String(value));
  }
  getAttribute(name) {
    return this.attributes.get(name) ?? null;
  }
  removeAttribute(name) {
    this.attributes.delete(name);
  }
  get children() {
    return this.childNodes.filter((node) => node instanceof Element);
  }
  #toNodes(nodes) {
    return nodes.map((node) => (node instanceof Element || node instanceof Text ? node : new Text(node)));
  }
  append(...nodes) {
    this.childNodes.push(...this.#toNodes(nodes));
  }
  prepend(...nodes) {
    this.childNodes.unshift(...this.#toNodes(nodes));
  }
  replaceChildren(...nodes) {
    this.childNodes = [];
    this.append(...nodes);
  }
  get textContent() {
    return this.childNodes.map((node) => node.textContent).join("");
  }
  set textContent(text) {
    this.replaceChildren(...(text === "" ? [] : [new Text(text)]));
  }
  get options() {
    return this.querySelectorAll("option");
  }
  set selectedIndex(index) {
    this.options.forEach((option, i) => (option.selected = i === index));
  }
  set value(text) {
    if (this.tag !== "select") this.setAttribute("value", text);
    else for (const option of this.options) option.selected = option.getAttribute("value") === text;
  }
  /** Find descendants by a tag, a class, or both ("svg.still"). */
  querySelectorAll(selector) {
    const matches = (node) => {
      const [tag, name] = selector.split(".");
      return (!tag || node.tag === tag) && (!name || node.classList.contains(name));
    };
    return this.children.flatMap((node) => [
      ...(matches(node) ? [node] : []),
      ...node.querySelectorAll(selector),
    ]);
  }
  querySelector(selector) {
    return this.querySelectorAll(selector)[0] ?? null;
  }
  attachShadow() {
    this.shadowRoot = new Element("template");
    this.shadowRoot.setAttribute("shadowrootmode", "open");
    return this.shadowRoot;
  }
  getRootNode() {
    return { activeElement: null };
  }
  contains() {
    return false;
  }
  get innerHTML() {
    return this.childNodes
      .map((node) => (this.tag === "style" ? node.textContent : node.outerHTML))
      .join("");
  }
  get outerHTML() {
    const style = Object.entries(this.style).map(
      ([name, value]) => `${toKebabCase(name)}:${value}`,
    );
    const pairs = [...this.attributes, ...(style.length ? [["style", style.join(";")]] : [])];
    const start = [
      this.tag,
      ...pairs.map(([name, value]) => (value ? `${name}="${escapeHtml(value)}"` : name)),
    ];
    const end = this.tag === "input" ? "" : `${this.innerHTML}</${this.tag}>`;
    return `<${start.join(" ")}>${end}`;
  }
}

for (const name of ["hidden", "selected", "open"])
  Object.defineProperty(Element.prototype, name, {
    get() {
      return this.attributes.has(name);
    },
    set(is) {
      if (is) this.setAttribute(name, "");
      else this.removeAttribute(name);
    },
  });
for (const name of ["className", "tabIndex", "type"]) {
  const attribute = { className: "class", tabIndex: "tabindex" }[name] ?? name;
  Object.defineProperty(Element.prototype, name, {
    get() {
      return this.getAttribute(attribute) ?? "";
    },
    set(value) {
      this.setAttribute(attribute, value);
    },
  });
}
Element.prototype.addEventListener = doNothing;

Object.assign(globalThis, {
  document: {
    documentElement: new Element("html"),
    body: new Element("body"),
    createElement: (tag) => new Element(tag),
    createElementNS: (_, tag) => new Element(tag),
  },
  location: { hash: "", href: "" },
  matchMedia: () => ({ matches: false, addEventListener: doNothing }),
  MutationObserver: class {
    observe() {}
  },
  AbortController: class {
    signal = { aborted: false, addEventListener: doNothing };
  },
  addEventListener: doNothing,
  clearTimeout: doNothing,
});
