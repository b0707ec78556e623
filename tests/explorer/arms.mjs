// Arms for the tests of the explorer's sources.

const row = (kind, a, alpha, d, theta, more = {}) => ({
  kind, a, alpha, d, theta, lower: null, upper: null, speed: null, effort: null, ...more,
}); // prettier-ignore
const H = Math.PI / 2;
const within = (lower, upper, effort) => ({ lower, upper, effort, speed: 2, body: [1, 0, 0, 0] });

export const ELBOW = {
  name: "Elbow arm",
  home: [0, 0.8, -1.5],
  rows: [row("revolute", 0, H, 0.5, 0), row("revolute", 0.4, 0, 0, 0), row("revolute", 0.3, 0, 0, 0)],
};
export const STANFORD = {
  name: "Stanford arm",
  home: [0, 0, 0.5, 0, 0, 0],
  rows: [
    row("revolute", 0, -H, 0.412, 0), row("revolute", 0, H, 0.154, 0), row("prismatic", 0, 0, 0, -H),
    row("revolute", 0, -H, 0, 0), row("revolute", 0, H, 0, 0), row("revolute", 0, 0, 0.263, 0),
  ],
}; // prettier-ignore
export const PANDA = {
  name: "Panda",
  home: [0, 0, 0, H, 0, Math.PI, 0],
  rows: [
    row("revolute", 0, H, 0.333, 0, within(-2.9, 2.9, 87)), row("revolute", 0, -H, 0, 0, within(-1.76, 1.76, 87)),
    row("revolute", 0.0825, -H, 0.316, 0, within(-2.9, 2.9, 87)), row("revolute", -0.0825, H, 0, 0, within(0.07, 3.07, 87)),
    row("revolute", 0, H, 0.384, 0, within(-2.9, 2.9, 12)), row("revolute", 0.088, -H, 0, 0, within(-0.02, 3.75, 12)),
    row("revolute", 0, 0, 0.207, 0, within(-2.9, 2.9, 12)),
  ],
}; // prettier-ignore
export const ARMS = [PANDA, STANFORD, ELBOW];
