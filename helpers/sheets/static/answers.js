// Buttons that copy an answer, or all of them, as a block of LaTeX, Python or MATLAB. They work from a file, with no network.
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
    const made = Object.assign(document.createElement("button"), { type: "button", textContent: label });
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

  const text = (template) => template.content.textContent;
  const said = (language) => `${language} copied.`;

  document.querySelectorAll(".answer").forEach((answer) => {
    const row = Object.assign(document.createElement("div"), { className: "answer-copy" });
    row.append(...[...answer.querySelectorAll("template")].map((template) => {
      const { language } = template.dataset;
      const made = button(`Copy ${language}`, async () => {
        await copy(text(template));
        return said(language);
      });
      return made;
    }));
    answer.append(row);
  });

  document.querySelectorAll(".answer-tools").forEach((tools) => {
    const answers = [...document.querySelectorAll(".answer")];
    const fold = button("Open all answers", () => {
      const open = fold.textContent.startsWith("Open");
      answers.forEach((answer) => { answer.open = open; });
      fold.textContent = open ? "Close all answers" : "Open all answers";
      return "";
    });
    const languages = [...new Set([...document.querySelectorAll(".answer template")].map((t) => t.dataset.language))];
    tools.replaceChildren(fold, ...languages.map((language) => button(`Copy all as ${language}`, async () => {
      const blocks = document.querySelectorAll(`.answer template[data-language="${language}"]`);
      await copy([...blocks].map(text).join("\n\n"));
      return said(language);
    })));
  });
})();
