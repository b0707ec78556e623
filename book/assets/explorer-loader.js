// Brings the live parts of a page to life when they are near; a judge at once where a link carries an answer. A page
// without one loads nothing.
{
  const folder = document.currentScript.src;
  const scripts = {};
  let ready;

  // They run in the order in which they are asked for; one that did not come is fetched anew when it is asked for again.
  const load = (name) =>
    (scripts[name] ??= new Promise((done, failed) => {
      const src = new URL(name, folder).href;
      document.head.append(Object.assign(document.createElement("script"), { src, async: false, onload: done, onerror: failed }));
    }).catch((problem) => {
      delete scripts[name];
      throw problem;
    }));
  const task = () => new Promise((go) => setTimeout(go));
  // The page answers between reading the script, asking for the graphics processor and building.
  const explorer = () => (ready ??= load("explorer.js").then(task).then(() => ArmExplorer.renderer()).then(task, () => {}));
  const wake = (stub) => {
    if (stub.matches(".arm-judge")) return load("judge.js");
    return explorer().then(() => ArmExplorer.mount(stub));
  };

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

  // The words come first.
  const painted = new Promise((done) => new PerformanceObserver(done).observe({ type: "paint", buffered: true }));
  document.addEventListener("DOMContentLoaded", () => {
    for (const stub of document.querySelectorAll(".arm-explorer, .arm-judge")) painted.then(() => near.observe(stub));
    if (/^#ask=/.test(location.hash)) for (const stub of document.querySelectorAll(".arm-judge")) wake(stub);
  });
}
