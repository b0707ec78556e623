// Load the script of a live part when the part is near the window; a judge at once if the link
// carries an answer. A page without live parts loads nothing.
{
  const folder = document.currentScript.src;
  const scripts = {};

  const load = (name) =>
    (scripts[name] ??= new Promise((resolve) => {
      const src = new URL(name, folder).href;
      document.head.append(Object.assign(document.createElement("script"), { src, onload: resolve }));
    }));
  const bringToLife = (stub) =>
    stub.matches(".arm-judge") ? load("judge.js") : load("explorer.js").then(() => ArmExplorer.mount(stub));

  const observer = new IntersectionObserver(
    (entries) => {
      for (const { isIntersecting, target } of entries) {
        if (!isIntersecting) continue;
        observer.unobserve(target);
        bringToLife(target);
      }
    },
    { rootMargin: "500px" },
  );
  document.addEventListener("DOMContentLoaded", () => {
    for (const stub of document.querySelectorAll(".arm-explorer, .arm-judge")) observer.observe(stub);
    if (location.hash.startsWith("#ask=")) document.querySelectorAll(".arm-judge").forEach(bringToLife);
  });
}
