// Colours of the picture for the light and the dark theme, and colours of solution branches.

export const PALETTES = {
  light: {
    highlight: "#E69F00",
    link: "#e9edf2",
    joint: "#34506b",
    grid: "#8793a3",
    gridStrength: 0.34,
    shadow: 0.16,
    sky: 2.1,
    sun: 1.5,
    path: "#D55E00",
    wantedPath: "#7a8290",
    force: "#C77E00",
    ghost: "#0072B2",
    ellipsoid: "#9a4f86",
    bad: "#c0392b",
  },
  dark: {
    highlight: "#F0B429",
    link: "#c3ccd8",
    joint: "#5f86ad",
    grid: "#93a1b5",
    gridStrength: 0.26,
    shadow: 0.28,
    sky: 1.15,
    sun: 1.7,
    path: "#F58A3C",
    wantedPath: "#a3adba",
    force: "#F0B429",
    ghost: "#56B4E9",
    ellipsoid: "#d79bc3",
    bad: "#ff8a6b",
  },
};
export const AXIS_COLOURS = {
  light: { x: "#D55E00", y: "#009E73", z: "#0072B2" },
  dark: { x: "#F58A3C", y: "#3CC79B", z: "#5AB4EC" },
};
const BRANCH_COLOURS = [
  "#0072B2",
  "#D55E00",
  "#009E73",
  "#E69F00",
  "#CC79A7",
  "#56B4E9",
  "#882255",
  "#7a8290",
];
export const getBranchColour = (i) => BRANCH_COLOURS[i % BRANCH_COLOURS.length];
