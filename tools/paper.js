// A document that knows just enough for the page's own code to build its parts in it, so that they
// stand in the book as HTML before their script has come (stills.py).

const ENTITIES = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" };
const safe = (text) => String(text).replace(/[&<>"]/g, (sign) => ENTITIES[sign]);
const kebab = (name) => name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
const nothing = () => {};

class Text {
  constructor(text) {
    this.textContent = String(text);
  }
  get outerHTML() {
    return safe(this.textContent);
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
      get: (_, name) => this.getAttribute(`data-${kebab(name)}`) ?? undefined,
      set: (_, name, value) => (this.setAttribute(`data-${kebab(name)}`, value), true),
    });
    this.classList = {
      contains: (name) => this.className.split(" ").includes(name),
      add: (name) => this.classList.toggle(name, true),
      toggle: (name, on) => {
        const rest = this.className.split(" ").filter((one) => one && one !== name);
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
  get firstChild() {
    return this.childNodes[0] ?? null;
  }
  // A node stands in one place only.
  #taken(nodes) {
    return nodes.map((node) => {
      if (!(node instanceof Element)) return node instanceof Text ? node : new Text(node);
      node.parent?.childNodes.splice(node.parent.childNodes.indexOf(node), 1);
      node.parent = this;
      return node;
    });
  }
  append(...nodes) {
    this.childNodes.push(...this.#taken(nodes));
  }
  prepend(...nodes) {
    this.childNodes.unshift(...this.#taken(nodes));
  }
  replaceChildren(...nodes) {
    for (const node of this.childNodes) node.parent = null;
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
  get selectedOptions() {
    const chosen = this.options.filter((option) => option.selected);
    return chosen.length ? chosen : this.options.slice(0, 1);
  }
  set selectedIndex(index) {
    this.options.forEach((option, i) => (option.selected = i === index));
  }
  get value() {
    if (this.tag === "textarea") return this.textContent;
    if (this.tag !== "select") return this.getAttribute("value") ?? "";
    return this.selectedOptions[0]?.getAttribute("value") ?? "";
  }
  set value(text) {
    if (this.tag === "textarea") this.textContent = String(text);
    else if (this.tag !== "select") this.setAttribute("value", text);
    else for (const one of this.options) one.selected = one.getAttribute("value") === text;
  }
  // A tag, a class, or both.
  querySelectorAll(selector) {
    const [tag, name] = selector.split(".");
    const is = (one) => (!tag || one.tag === tag) && (!name || one.classList.contains(name));
    return this.children.flatMap((one) => [...(is(one) ? [one] : []), ...one.querySelectorAll(selector)]);
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
    return this.childNodes.map((node) => (this.tag === "style" ? node.textContent : node.outerHTML)).join("");
  }
  get outerHTML() {
    const style = Object.entries(this.style).map(([name, value]) => `${kebab(name)}:${value}`);
    const all = [...this.attributes, ...(style.length ? [["style", style.join(";")]] : [])];
    const start = [this.tag, ...all.map(([name, value]) => (value ? `${name}="${safe(value)}"` : name))];
    const end = this.tag === "input" ? "" : `${this.innerHTML}</${this.tag}>`;
    return `<${start.join(" ")}>${end}`;
  }
}

for (const name of ["hidden", "disabled", "selected", "open"])
  Object.defineProperty(Element.prototype, name, {
    get() {
      return this.attributes.has(name);
    },
    set(is) {
      if (is) this.setAttribute(name, "");
      else this.removeAttribute(name);
    },
  });
for (const name of ["className", "tabIndex", "id", "type", "title", "href", "placeholder"]) {
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
for (const name of ["addEventListener", "scrollIntoView", "focus"]) Element.prototype[name] = nothing;

Object.assign(globalThis, {
  document: {
    documentElement: new Element("html"),
    body: new Element("body"),
    createElement: (tag) => new Element(tag),
    createElementNS: (_, tag) => new Element(tag),
  },
  location: { hash: "", href: "" },
  console: { error: nothing, warn: nothing, log: nothing },
  matchMedia: () => ({ matches: false, addEventListener: nothing }),
  MutationObserver: class {
    observe() {}
  },
  AbortController: class {
    signal = { aborted: false, addEventListener: nothing };
  },
  URL: class {
    constructor(path) {
      this.href = path;
    }
  },
  URLSearchParams: class {
    constructor(fields) {
      this.fields = Array.isArray(fields) ? fields : Object.entries(fields);
    }
    toString() {
      return this.fields.map((pair) => pair.map(encodeURIComponent).join("=")).join("&");
    }
  },
  addEventListener: nothing,
  setTimeout: nothing,
  clearTimeout: nothing,
  requestAnimationFrame: nothing,
  cancelAnimationFrame: nothing,
});
