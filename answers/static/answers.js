// Buttons that copy an answer, or all of them, as a block of LaTeX, Python or MATLAB. They work
// from a file, with no network.
(() => {
  const announced = Object.assign(document.createElement("span"), { className: "answer-said" });
  announced.setAttribute("role", "status");

  const blocks = JSON.parse(document.querySelector('script[type="application/json"]').textContent);

  async function copy(text) {
    try {
      await navigator.clipboard.writeText(text);
    } catch {
      // If the browser denies the page its clipboard, it may still copy a selection.
      const area = Object.assign(document.createElement("textarea"), { value: text });
      document.body.append(area);
      area.select();
      const copied = document.execCommand("copy");
      area.remove();
      if (!copied) throw new Error("The browser does not let the page copy.");
    }
  }

  function button(label, act) {
    const made = document.createElement("button");
    Object.assign(made, { type: "button", textContent: label });
    made.addEventListener("click", async () => {
      made.after(announced);
      announced.textContent = "…";
      announced.textContent = await act().catch((problem) => problem.message);
    });
    return made;
  }

  const answers = [...document.querySelectorAll(".answer")];
  const places = [...document.querySelectorAll(".answer-tools [data-language]")];
  const languages = places.map((place) => place.dataset.language);

  function copier(label, of, language) {
    return button(label, async () => {
      await copy(of.map(({ id }) => blocks[id][language]).join("\n\n"));
      return `${language} copied.`;
    });
  }

  for (const answer of answers) {
    const row = Object.assign(document.createElement("div"), { className: "answer-copy" });
    row.append(...languages.map((language) => copier(`Copy ${language}`, [answer], language)));
    answer.append(row);
  }

  for (const tools of document.querySelectorAll(".answer-tools")) {
    const fold = button("Open all answers", async () => {
      const open = fold.textContent.startsWith("Open");
      answers.forEach((answer) => { answer.open = open; });
      fold.textContent = open ? "Close all answers" : "Open all answers";
      return "";
    });
    const all = languages.map((name) => copier(`Copy all as ${name}`, answers, name));
    tools.replaceChildren(fold, ...all);
  }

  // Open all answers for printing, since a folded one would be an empty box on paper.
  let opened = [];
  addEventListener("beforeprint", () => {
    opened = answers.filter((answer) => !answer.open);
    opened.forEach((answer) => { answer.open = true; });
  });
  addEventListener("afterprint", () => opened.forEach((answer) => { answer.open = false; }));
})();
