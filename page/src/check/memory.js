// The reader's last answer to each question about each arm, kept in the browser's storage until the
// reader clears it.

/** @typedef {import("./question.js").Question} Question */

const PREFIX = "judge:";
const CLEARED = `${PREFIX}cleared`; // time of the last clearing; other tabs watch it
const MAX_KEPT_LENGTH = 200_000; // characters; longer answers, such as files, are not kept

/** Stores the answers of a form. `scope` distinguishes the forms of the book. */
export class AnswerMemory {
  /** @param {string} scope */
  constructor(scope) {
    this.scope = `${PREFIX}${scope}:`;
  }

  /**
   * Store a question as the last question of this form, or forget one in which nothing is typed.
   * @param {Question} question
   * @param {boolean} isTyped whether the reader typed into one of its fields
   */
  save(question, isTyped) {
    const key = this.#keyOf(question);
    const isKept = isTyped && question.answer.length <= MAX_KEPT_LENGTH;
    useStorage((storage) => {
      if (!isKept) return storage.removeItem(key);
      storage.setItem(key, JSON.stringify(question));
      return storage.setItem(`${this.scope}last`, key);
    });
  }

  /**
   * Return the kept question of a kind and arm, or null.
   * @param {{ ask: string, arm: string }} question
   * @returns {Partial<Question> | null}
   */
  load(question) {
    return this.#read(this.#keyOf(question));
  }

  /** Return the question that was kept last, or null. */
  loadLast() {
    return this.#read(useStorage((storage) => storage.getItem(`${this.scope}last`)));
  }

  /**
   * Call a function when another tab clears all answers.
   * @param {() => void} listener
   */
  onClear(listener) {
    globalThis.addEventListener?.("storage", ({ key, newValue }) => {
      if (key === null || (key === CLEARED && newValue)) listener();
    });
  }

  #keyOf({ ask, arm }) {
    return `${this.scope}${ask}:${arm}`;
  }

  #read(key) {
    const text = key && useStorage((storage) => storage.getItem(key));
    try {
      return text ? JSON.parse(text) : null;
    } catch {
      return null;
    }
  }
}

/** Forget the answers of all forms of the book, and notify the other tabs. */
export function clearAnswers() {
  useStorage((storage) => {
    const keys = Array.from({ length: storage.length }, (_, i) => storage.key(i));
    for (const key of keys.filter((name) => name.startsWith(PREFIX))) storage.removeItem(key);
    storage.setItem(CLEARED, String(Date.now()));
  });
}

// Use the browser's storage; null where it is refused or full, as in some private windows.
function useStorage(act) {
  try {
    return act(globalThis.localStorage) ?? null;
  } catch {
    return null;
  }
}
