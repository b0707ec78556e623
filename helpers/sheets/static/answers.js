// Buttons that copy an answer, or all of them, as a block of LaTeX, Python or MATLAB. They work
// from a file, with no network.
(() => {
  const announced = Object.assign(document.createElement("span"), { className: "answer-said" });
  announced.setAttribute("role", "status");

  async function copy(text) {
    try {
      await navigator.clipboard.writeText(text);
    } catch {
      // Where a page may not use the clipboard by itself, a selection can still be copied.
      const area = Object.assign(document.createElement("textarea"), { value: text });
      document.body.append(area);
      area.select();
      const copied = document.execCommand("copy");
      area.remove();
      if (!copied) throw new Error("not copied");
    }
  }

  function button(label, act) {
    const made = document.createElement("button");
    Object.assign(made, { type: "button", textContent: label });
    made.addEventListener("click", async () => {
      made.after(announced);
      announced.textContent = "";
      try {
        announced.textContent = await act();
      } catch {
        announced.textContent = "The browser does not let the page copy.";
      }
    });
    return made;
  }

  const text = (block) => block.textContent.trim();
  const answers = [...document.querySelectorAll(".answer")];
  const blocks = (of, language) => [...of.querySelectorAll(`script[data-language="${language}"]`)];
  const found = document.querySelectorAll(".answer script[data-language]");
  const languages = [...new Set([...found].map((block) => block.dataset.language))];

  const copier = (label, of, language) => button(label, async () => {
    await copy(blocks(of, language).map(text).join("\n\n"));
    return `${language} copied.`;
  });

  for (const answer of answers) {
    const row = Object.assign(document.createElement("div"), { className: "answer-copy" });
    row.append(...languages.map((language) => copier(`Copy ${language}`, answer, language)));
    answer.append(row);
  }

  for (const tools of document.querySelectorAll(".answer-tools")) {
    const fold = button("Open all answers", () => {
      const open = fold.textContent.startsWith("Open");
      answers.forEach((answer) => { answer.open = open; });
      fold.textContent = open ? "Close all answers" : "Open all answers";
      return "";
    });
    const all = languages.map((name) => copier(`Copy all as ${name}`, document, name));
    tools.replaceChildren(fold, ...all);
  }

  // What is folded would be an empty box on paper.
  let opened = [];
  addEventListener("beforeprint", () => {
    opened = answers.filter((answer) => !answer.open);
    opened.forEach((answer) => { answer.open = true; });
  });
  addEventListener("afterprint", () => opened.forEach((answer) => { answer.open = false; }));
})();
