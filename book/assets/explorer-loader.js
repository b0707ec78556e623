// Brings the live parts of a page to life when they are near, a judge at once where a link carries an answer. A page
// without one loads nothing.
{
  const folder = document.currentScript.src;
  const scripts = {};

  const load = (name) =>
    (scripts[name] ??= new Promise((done) => {
      const src = new URL(name, folder).href;
      document.head.append(Object.assign(document.createElement("script"), { src, onload: done }));
    }));
  const wake = (stub) =>
    stub.matches(".arm-judge") ? load("judge.js") : load("explorer.js").then(() => ArmExplorer.mount(stub));

  const near = new IntersectionObserver(
    (entries) => {
      for (const { isIntersecting, target } of entries) {
        if (!isIntersecting) continue;
        near.unobserve(target);
        wake(target);
      }
    },
    { rootMargin: "500px" },
  );
  document.addEventListener("DOMContentLoaded", () => {
    for (const stub of document.querySelectorAll(".arm-explorer, .arm-judge")) near.observe(stub);
    if (location.hash.startsWith("#ask=")) document.querySelectorAll(".arm-judge").forEach(wake);
  });
}
