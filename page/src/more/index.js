// The small figures of the chapters, by the names that the pages call them, and the instrument's
// views along a path.

import * as kinds from "./kinds.js";
import { swing } from "./swing.js";
import { register } from "../figures.js";
import * as homework from "../views/homework.js";
import * as trace from "../views/trace.js";

const { columns, ellipsoid, hand, loads, matrix, row, triangles, ways, winds } = kinds;
register({ columns, ellipsoid, hand, loads, matrix, row, swing, triangles, ways, winds });
register({ homework, trace });
