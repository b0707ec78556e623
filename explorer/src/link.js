// The explorer's state in the fragment of a link, and back.

const KINDS = { R: "revolute", P: "prismatic", F: "fixed" };
const numbers = (text) => (text ? text.split(",").map(Number) : []);
const written = (values) => values.map((v) => Number(v.toFixed(6)) + 0).join(",");

export function toFragment({ arm, reference, q, wrench, unit, view, frames }) {
  const fields = { arm: reference.name, q: written(q), view, unit, frames };
  if (wrench.some(Boolean)) fields.wrench = written(wrench);
  if (arm !== reference) fields.rows = arm.rows.map((r) => `${r.kind[0].toUpperCase()},${written([r.a, r.alpha, r.d, r.theta])}`).join(";");
  return `#${new URLSearchParams(fields)}`;
}

// The fields that a fragment holds; anything that makes no sense is left out.
export function fromFragment(fragment, arms, views) {
  const fields = new URLSearchParams(fragment.replace(/^#/, ""));
  const reference = arms.find((arm) => arm.name === fields.get("arm"));
  if (!reference) return {};
  const arm = typedArm(fields.get("rows"), reference) ?? reference;
  const state = { arm, reference };
  const moving = arm.rows.filter((row) => row.kind !== "fixed").length;
  const [q, wrench] = [numbers(fields.get("q")), numbers(fields.get("wrench"))];
  state.q = good(q, moving) ? q : arm === reference ? [...arm.home] : Array(moving).fill(0);
  if (good(wrench, 6)) state.wrench = wrench;
  if (views.includes(fields.get("view"))) state.view = fields.get("view");
  if (["deg", "rad"].includes(fields.get("unit"))) state.unit = fields.get("unit");
  if (["all", "ends"].includes(fields.get("frames"))) state.frames = fields.get("frames");
  return state;
}

const good = (values, length) => values.length === length && values.every(Number.isFinite);

function typedArm(text, reference) {
  if (!text) return null;
  const rows = text.split(";").map((line, i) => {
    const [letter, ...entries] = line.split(",");
    const [a, alpha, d, theta] = entries.map(Number);
    const same = reference.rows[i]?.kind === KINDS[letter] ? reference.rows[i] : {};
    return { lower: null, upper: null, speed: null, effort: null, ...same, kind: KINDS[letter], a, alpha, d, theta };
  });
  const whole = rows.every((row) => row.kind && [row.a, row.alpha, row.d, row.theta].every(Number.isFinite));
  return whole ? { ...reference, rows } : null;
}

// Keep the page's own address in step with the state, and copy it.
export function keepLink(store, arms, views) {
  const read = () => store.set(fromFragment(location.hash, arms, views), "link");
  read();
  addEventListener("hashchange", read);
  let timer;
  store.listen((changed, by) => {
    clearTimeout(timer);
    if (by !== "link") timer = setTimeout(() => history.replaceState(null, "", toFragment(store.state)), 400);
  });
  return {
    async copy(button) {
      history.replaceState(null, "", toFragment(store.state));
      const copied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
      button.textContent = copied ? "Copied" : "In the address bar";
      setTimeout(() => (button.textContent = "Copy link"), 1600);
    },
  };
}
