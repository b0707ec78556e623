// Light or dark, as the page around is: the book's switch, JupyterLab's and VS Code's themes, else
// the system's.

const system =
  typeof matchMedia === "undefined" ? null : matchMedia("(prefers-color-scheme: dark)");

function themeNow() {
  const { dataset } = document.documentElement;
  if (dataset.theme) return dataset.theme === "dark" ? "dark" : "light";
  const lab = document.body.dataset.jpThemeLight;
  if (lab) return lab === "true" ? "light" : "dark";
  const { classList } = document.body;
  if (classList.contains("vscode-dark") || classList.contains("vscode-high-contrast"))
    return "dark";
  if (classList.contains("vscode-light") || !system?.matches) return "light";
  return "dark";
}

// Call now, and again whenever the theme changes, until the signal is aborted.
export function watchTheme(tell, signal) {
  let before;
  const look = () => {
    const now = themeNow();
    if (now !== before) tell((before = now));
  };
  const observer = new MutationObserver(look);
  observer.observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme"] });
  observer.observe(document.body, {
    attributes: true,
    attributeFilter: ["class", "data-jp-theme-light"],
  });
  system?.addEventListener("change", look, { signal });
  signal.addEventListener("abort", () => observer.disconnect());
  look();
}
