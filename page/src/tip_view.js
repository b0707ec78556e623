// Keep the tip in view after a change of the arm or a motion.

import { movingRows } from "../../judge/geometry/kinematics.js";

const REST_TIME = 300; // ms without a change after which the arm counts as standing still

export class TipView {
  /** @param {any} picture the `ArmPicture` whose view is kept */
  constructor(picture) {
    this.picture = picture;
    this.isResting = false;
    this.wasInView = true; // when the arm last stood still
    this.timer = /** @type {any} */ (0);
  }

  isInView() {
    const { frames, figure } = this.picture;
    if (!frames || !figure.width || !figure.height) return true;
    const [x, y] = figure.projectToPixel(frames.at(-1).o);
    return x >= 0 && x <= figure.width && y >= 0 && y <= figure.height;
  }

  // Remember, before the first change after a rest, whether the tip is in view.
  beginMotion() {
    if (this.isResting) this.wasInView = this.isInView();
    this.isResting = false;
  }

  // Return whether the view must be fitted to an arm that replaces `previousArm`.
  needsFitAfter(previousArm) {
    const { arm } = this.picture;
    return movingRows(previousArm).length !== movingRows(arm).length || !this.isInView();
  }

  // Wait until the arm stands still, and fit the view if its tip has left it.
  waitForRest(store) {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      if (store.state.dragging || store.state.playing) return this.waitForRest(store);
      if (!this.isResting && this.wasInView && !this.isInView()) this.picture.fitView();
      this.isResting = true;
    }, REST_TIME);
  }

  dispose() {
    clearTimeout(this.timer);
  }
}
