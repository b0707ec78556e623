// Light or dark theme of the surrounding page: the book's switch, JupyterLab's or VS Code's theme,
// else the system's.

const darkPreference =
  typeof matchMedia === "undefined" ? null : matchMedia("(prefers-color-scheme: dark)");

function readTheme() {
  const { dataset } = document.documentElement;
  if (dataset.theme) return dataset.theme === "dark" ? "dark" : "light";
  const lab = document.body.dataset.jpThemeLight;
  if (lab) return lab === "true" ? "light" : "dark";
  const { classList } = document.body;
  if (classList.contains("vscode-dark") || classList.contains("vscode-high-contrast"))
    return "dark";
  if (classList.contains("vscode-light") || !darkPreference?.matches) return "light";
  return "dark";
}

// Call `onChange` now and whenever the theme changes, until the signal is aborted.
export function watchTheme(onChange, signal) {
  let previous;
  const check = () => {
    const theme = readTheme();
    if (theme !== previous) onChange((previous = theme));
  };
  const observer = new MutationObserver(check);
  observer.observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme"] });
  observer.observe(document.body, {
    attributes: true,
    attributeFilter: ["class", "data-jp-theme-light"],
  });
  darkPreference?.addEventListener("change", check, { signal });
  signal.addEventListener("abort", () => observer.disconnect());
  check();
}
