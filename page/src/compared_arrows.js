// Draws the tip's velocity by a column of the right Jacobian and of a typed one.

import { Group } from "three";
import { norm, plus, scaled } from "../../judge/geometry/kinematics.js";
import { compareColumn } from "./compared_column.js";
import { Arrow } from "./shapes.js";

const LENGTH = 0.25; // of the longer arrow, as a share of the arm's reach
const THICKNESS = 0.007;
const NONE = [0, 0, 0];

/** Two arrows at the tip, which no longer show once there is nothing to compare. */
export class ComparedArrows extends Group {
  constructor(rightMaterial, typedMaterial) {
    super();
    this.add(new Arrow(rightMaterial), new Arrow(typedMaterial));
  }

  // Place the arrows and return their ends, or none if nothing is compared.
  place(tip, state, columns, size) {
    const compared = state.view === "jacobian" ? compareColumn(state, columns) : null;
    const vectors = compared ? [compared.right, compared.typed] : [NONE, NONE];
    const scale = (LENGTH * size) / Math.max(...vectors.map(norm), 1e-9);
    this.children.forEach((/** @type {any} */ arrow, i) =>
      arrow.placeAlong(tip, scaled(scale, vectors[i]), THICKNESS * size),
    );
    return compared ? vectors.map((vector) => plus(tip, scaled(scale, vector))) : [];
  }
}
