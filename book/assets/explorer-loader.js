// Load the script of a live part. A page without live parts loads nothing. The explorer's page loads
// at once, a judge when the page rests near it, or at once if the link carries an answer. Every other
// arm waits, as a still picture, for the first sign that a reader uses it: an event on its card, or
// a scrolled page that rests with the card in view. Readers who save data must touch it. A judge
// changes its height, so it waits for rest: the key End leads to where the end was when it was pressed.
{
  const folder = document.currentScript.src;
  const scripts = {};
  const REST_TIME = 200; // ms without scrolling after which the page rests
  const SIGNS = ["pointermove", "pointerdown", "touchstart", "wheel", "keydown", "focusin"];
  const TOUCHES = ["pointerdown", "touchstart", "keydown"];
  const savesData = navigator.connection?.saveData === true;

  const load = (name) =>
    (scripts[name] ??= new Promise((resolve) => {
      const src = new URL(name, folder).href;
      document.head.append(Object.assign(document.createElement("script"), { src, onload: resolve }));
    }));
  const bringToLife = (stub) =>
    stub.matches(".arm-judge") ? load("judge.js") : load("explorer.js").then(() => mount(stub));

  // Mount an explorer. A control that has the focus keeps it. WebKit first lays out the new parts
  // without their height, and would scroll up from the end of the page that is shorter then.
  function mount(stub) {
    const listControls = () => [...stub.shadowRoot.querySelectorAll("button, input, select")];
    const focused = listControls().indexOf(stub.shadowRoot.activeElement);
    stub.style.minHeight = `${stub.offsetHeight}px`;
    ArmExplorer.mount(stub);
    void stub.offsetHeight; // lays the page out
    stub.style.removeProperty("min-height");
    if (focused >= 0) listControls()[focused]?.focus();
  }

  const nearby = new Set(); // judges and explorers that start when the page rests
  const near = new IntersectionObserver(
    (entries) => {
      for (const { isIntersecting, target } of entries)
        if (isIntersecting) nearby.add(target);
        else nearby.delete(target);
      if (!timer) startNearby();
    },
    { rootMargin: "500px" },
  );

  function startNearby() {
    for (const part of nearby) {
      near.unobserve(part);
      bringToLife(part);
    }
    nearby.clear();
  }

  const waiting = new Map(); // from each arm that waits to whether it is in view
  const inView = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) waiting.set(target, isIntersecting);
  });

  function start(stub) {
    inView.unobserve(stub);
    if (waiting.delete(stub)) bringToLife(stub);
  }

  function waitForReader(stub) {
    waiting.set(stub, false);
    inView.observe(stub);
    for (const type of savesData ? TOUCHES : SIGNS)
      stub.addEventListener(type, () => start(stub), { once: true, passive: true });
  }

  let timer = null; // while the page scrolls
  const startAtRest = () => {
    timer = null;
    startNearby();
    if (!savesData) waiting.forEach((isInView, stub) => isInView && start(stub));
  };
  const restart = () => {
    clearTimeout(timer);
    timer = setTimeout(startAtRest, REST_TIME);
  };
  document.addEventListener("scroll", restart, { passive: true });

  document.addEventListener("DOMContentLoaded", () => {
    for (const stub of document.querySelectorAll(".arm-explorer, .arm-judge"))
      if (stub.matches(".arm-judge, .whole")) near.observe(stub);
      else waitForReader(stub);
    if (location.hash.startsWith("#ask=")) document.querySelectorAll(".arm-judge").forEach(bringToLife);
  });
}
