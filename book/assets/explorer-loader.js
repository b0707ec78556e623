// Brings the arm explorers of a page to life when they are near and a reader is there, and the judge of answers at once; a page
// without one loads nothing.
{
  const source = new URL("explorer.js", document.currentScript.src).href;
  let bundle;

  const load = () =>
    (bundle ??= new Promise((done, failed) => {
      const script = Object.assign(document.createElement("script"), { src: source, onload: done, onerror: failed });
      document.head.append(script);
    }));

  const judge = new URL("judge.js", document.currentScript.src).href;

  const near = new IntersectionObserver(
    (entries) => {
      for (const { isIntersecting, target } of entries) {
        if (!isIntersecting) continue;
        near.unobserve(target);
        reader.then(load).then(() => ArmExplorer.mount(target));
      }
    },
    { rootMargin: "500px" },
  );

  document.addEventListener("DOMContentLoaded", () => {
    for (const stub of document.querySelectorAll(".arm-explorer")) near.observe(stub);
    if (document.querySelector(".arm-judge"))
      document.head.append(Object.assign(document.createElement("script"), { src: judge }));
  });
}
