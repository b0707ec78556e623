// The small figures of the chapters, by the names that the pages call them, and the instrument's
// views along a path.

import { columns, ellipsoid, hand, loads, matrix, row, triangles, ways, winds } from "./kinds.js";
import { swing } from "./swing.js";
import { registerFigure, registerView } from "../figures.js";
import * as homework from "../views/homework.js";
import * as trace from "../views/trace.js";

const KINDS = {
  columns,
  ellipsoid,
  hand,
  loads,
  matrix,
  row,
  swing,
  triangles,
  ways,
  winds,
};
for (const [name, make] of Object.entries(KINDS)) registerFigure(name, make);
registerView("homework", homework);
registerView("trace", trace);
