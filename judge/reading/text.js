// Lines, and what is cut from their ends.

export const lines = (text) => {
  const found = text.split(/\r\n|[\n\r\v\f\x1c-\x1e\x85\u2028\u2029]/);
  if (found.at(-1) === "") found.pop();
  return found;
};

export const stripped = (text, signs) => {
  let [from, to] = [0, text.length];
  while (from < to && signs.includes(text[from])) from++;
  while (to > from && signs.includes(text[to - 1])) to--;
  return text.slice(from, to);
};

export const strippedEnd = (text, signs) => {
  let to = text.length;
  while (to > 0 && signs.includes(text[to - 1])) to--;
  return text.slice(0, to);
};
