// The barrier that stops a dragged tip.

import { Group, MeshBasicMaterial, Vector3 } from "three";
import { minus } from "../../judge/geometry/kinematics.js";
import { makeBall, makePaneMaterial, makeRod, makeSquare, placeRod } from "./shapes.js";

/** A wall at the tip, with a rod and a ball that show the missing distance to the target. */
export class Barrier extends Group {
  /**
   * @param {number} size reach of the arm in m
   * @param {{ bad: string }} look colour of the barrier
   */
  constructor(size, look) {
    super();
    this.size = size;
    const material = new MeshBasicMaterial({ color: look.bad });
    this.wall = makeSquare(0.16 * size, makePaneMaterial(look.bad, 0.3));
    this.rod = makeRod(material);
    this.ball = makeBall(material);
    this.ball.scale.setScalar(0.01 * size);
    this.visible = false;
    this.add(this.wall, this.rod, this.ball);
  }

  /** @param {number[]} tip @param {number[]} target of the drag */
  placeBetween(tip, target) {
    const direction = new Vector3(...minus(target, tip)).normalize();
    placeRod(this.rod, tip, target, 0.002 * this.size);
    this.ball.position.fromArray(target);
    this.wall.position.fromArray(tip).addScaledVector(direction, 0.006 * this.size);
    this.wall.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), direction);
  }
}
