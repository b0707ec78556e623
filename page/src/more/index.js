// The small figures of the chapters, by the names that the pages call them, and the instrument's
// largest view.

import { answer } from "./answer.js";
import {
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
} from "./kinds.js";
import { trainer } from "./trainer.js";
import { registerFigure, registerView } from "../figures.js";
import * as homework from "../views/homework.js";

const KINDS = {
  answer,
  columns,
  ellipsoid,
  hand,
  loads,
  matrix,
  row,
  swing,
  trainer,
  triangles,
  ways,
  winds,
};
for (const [name, make] of Object.entries(KINDS)) registerFigure(name, make);
registerView("homework", homework);
