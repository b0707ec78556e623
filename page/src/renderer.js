// One renderer for all pictures of a page. Each figure is a 2D canvas into which the renderer's
// picture is copied, so that twenty of them need one WebGL context, and a lost context leaves every
// picture standing.

import {
  DirectionalLight,
  HemisphereLight,
  PCFShadowMap,
  PerspectiveCamera,
  Plane,
  Raycaster,
  Scene,
} from "three";
import { Box3, Vector2, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { isShared } from "./shapes.js";

let shared = null;
let frame = null;
const figures = new Set();

// Throws where the browser has no WebGL.
function renderer() {
  if (shared) return shared;
  shared = new WebGLRenderer({
    antialias: true,
    alpha: true,
    powerPreference: "low-power",
  });
  shared.setPixelRatio(1); // the sizes below are device pixels
  shared.setScissorTest(true);
  shared.shadowMap.enabled = true;
  shared.shadowMap.type = PCFShadowMap;
  shared.domElement.addEventListener("webglcontextlost", () =>
    figures.forEach((figure) => figure.onLost(true)),
  );
  shared.domElement.addEventListener("webglcontextrestored", () => {
    figures.forEach((figure) => {
      figure.onLost(false);
      figure.request();
    });
  });
  return shared;
}

// For the tests: what the renderer holds on the graphics processor, the calls that drew the last
// picture, figures.
export const inUse = () => ({
  ...shared?.info.memory,
  calls: shared?.info.render.calls,
  programs: shared?.info.programs?.length,
  figures: figures.size,
});

/** Take the context away, as a busy graphics processor may; for the tests. */
export const loseContext = () => shared?.getContext().getExtension("WEBGL_lose_context");

const steps = new Set();

/**
 * Act once, right before the next pictures are drawn, so that a motion is seen in the frame in
 * which it was computed.
 * @param {() => void} act
 */
export function beforeDrawing(act) {
  steps.add(act);
  frame ??= requestAnimationFrame(drawDirty);
}

// Whether it was still to come, and no longer does.
export const forget = (act) => steps.delete(act);

function drawDirty() {
  const now = [...steps];
  steps.clear();
  try {
    now.forEach((act) => act());
    if (!shared || shared.getContext().isContextLost()) return;
    for (const figure of figures)
      if (figure.dirty && figure.visible && figure.width) figure.draw(shared);
  } finally {
    frame = steps.size ? requestAnimationFrame(drawDirty) : null;
  }
}

// Pictures near the window are drawn, the others when they come near.
const near =
  typeof IntersectionObserver === "undefined"
    ? null
    : new IntersectionObserver(
        (seen) => {
          for (const { target, isIntersecting } of seen) {
            const figure = target.figure;
            if (!figure) continue;
            figure.visible = isIntersecting;
            if (isIntersecting) figure.request();
          }
        },
        { rootMargin: "200px" },
      );

// Used again and again, so that a frame leaves nothing behind.
const SPOT = new Vector3();
const SIGHT = new Raycaster();

// Where the camera stands first, seen from the arm; the still picture's too.
const VIEW = new Vector3(0.687, -0.639, 0.344);

/**
 * A picture in 3D in a host element: scene, lights, a camera that can be turned, and pointers in
 * pixels. `onDraw(figure)` is called after each drawing, for labels. Throws where the browser has
 * no WebGL.
 */
export class Figure {
  constructor(host, { onDraw, onLost = (_) => {} }) {
    renderer();
    this.host = host;
    this.size = 1;
    this.onDraw = onDraw;
    this.onLost = onLost;
    this.dirty = true;
    this.visible = true;
    this.abort = new AbortController();
    this.points = null;
    this.width = 0; // the host's size, kept: asking for it lays the page out
    this.height = 0;
    this.foot = () => 0; // how high (CSS pixels) the buttons at the picture's foot stand
    this.canvas = document.createElement("canvas");
    this.canvas.figure = this;
    this.context = this.canvas.getContext("2d");
    host.prepend(this.canvas);
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(32, 1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener("change", () => this.request());
    // until the picture has the focus, so that a page scrolls past it
    this.controls.enableZoom = false;
    this.controls.enablePan = false;
    this.canvas.style.touchAction = "pan-y"; // after OrbitControls, which writes "none"
    this.listen(host, "focusin", () => (this.controls.enableZoom = true));
    this.listen(host, "focusout", () => (this.controls.enableZoom = false));
    this.lights();
    figures.add(this);
    near?.observe(this.canvas);
    this.resizes = new ResizeObserver(() => this.resize());
    this.resizes.observe(host);
  }

  get signal() {
    return this.abort.signal;
  }

  listen(target, type, act, options = {}) {
    target.addEventListener(type, act, { ...options, signal: this.signal });
  }

  lights() {
    this.sky = new HemisphereLight("#ffffff", "#8d95a1", 2);
    this.sky.position.set(0, 0, 1);
    this.sun = new DirectionalLight("#ffffff", 2);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(1024, 1024);
    this.sun.shadow.radius = 5;
    this.sun.shadow.bias = -0.002;
    this.scene.add(this.sky, this.sun, this.sun.target);
    this.resetLights();
  }

  // Lights and shadows for things of this size (m).
  resetLights({ size = this.size, sky = 2.1, sun = 1.5 } = {}) {
    this.size = size;
    this.sky.intensity = sky;
    this.sun.intensity = sun;
    this.sun.position.set(0.55 * size, -0.75 * size, 2 * size);
    const { camera } = this.sun.shadow;
    Object.assign(camera, {
      left: -size,
      right: size,
      top: size,
      bottom: -size,
      near: 0.05 * size,
      far: 4 * size,
    });
    camera.updateProjectionMatrix();
  }

  request() {
    this.dirty = true;
    frame ??= requestAnimationFrame(drawDirty);
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.host;
    Object.assign(this, { width, height });
    if (!width || !height) return;
    const ratio = Math.min(devicePixelRatio, 2);
    const [wide, high] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (this.canvas.width === wide && this.canvas.height === high) return;
    Object.assign(this.canvas, { width: wide, height: high });
    Object.assign(this.canvas.style, { width: `${width}px`, height: `${height}px` });
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.points && !(Math.abs(this.fitted - this.camera.aspect) < 0.01)) this.fit(this.points);
    this.dirty = true;
    // At once: a canvas of another size is blank.
    if (shared && !shared.getContext().isContextLost()) this.draw(shared);
    else this.request();
  }

  // By the renderer, then from its own picture into this one, before another figure is drawn there.
  draw(gl) {
    const { width, height } = this.canvas;
    const size = gl.getSize(new Vector2());
    if (width > size.x || height > size.y)
      gl.setSize(Math.max(width, size.x), Math.max(height, size.y), false);
    gl.setViewport(0, 0, width, height);
    gl.setScissor(0, 0, width, height);
    gl.render(this.scene, this.camera);
    this.dirty = false;
    this.context.clearRect(0, 0, width, height);
    const top = gl.domElement.height - height;
    this.context.drawImage(gl.domElement, 0, top, width, height, 0, 0, width, height);
    this.onDraw(this);
  }

  // Stand where all these points are in view, above the buttons at the picture's foot.
  fit(points) {
    this.points = points;
    if (!this.height) return; // until it has a size
    const { camera, controls, size } = this;
    this.fitted = camera.aspect;
    const foot = Math.min(0.3, this.foot() / this.height);
    const held = points.map((p) => new Vector3(...p));
    new Box3().setFromPoints(held).getCenter(controls.target);
    camera.position.copy(controls.target).addScaledVector(VIEW, 3 * size);
    Object.assign(camera, { near: size / 50, far: size * 40 });
    camera.updateProjectionMatrix();
    for (let step = 0; step < 4; step++) {
      controls.update();
      camera.updateMatrixWorld();
      const { min, max } = new Box3().setFromPoints(held.map((p) => p.clone().project(camera)));
      const away = camera.position.clone().sub(controls.target);
      const lift = Math.max(0, Math.min(foot, (max.y - min.y) / 2 - 1 + 2 * foot));
      const half = away.length() * Math.tan((camera.fov * Math.PI) / 360);
      const [right, up] = [0, 1].map((i) =>
        new Vector3().setFromMatrixColumn(camera.matrixWorld, i),
      );
      controls.target.addScaledVector(right, ((min.x + max.x) / 2) * half * camera.aspect);
      controls.target.addScaledVector(up, ((min.y + max.y) / 2 - lift) * half);
      const [wide, high] = [
        (max.x - min.x) / 2 / 0.81,
        (max.y - min.y) / 2 / Math.min(0.81, 0.96 - foot),
      ];
      away.multiplyScalar(Math.max(wide, high));
      camera.position.copy(controls.target).add(away);
    }
    controls.update();
    this.request();
  }

  // Turn the camera by angles (rad) and bring it nearer by a factor.
  orbit(turn, tilt, nearer = 1) {
    this.controls.rotateLeft(-turn);
    this.controls.rotateUp(-tilt);
    this.controls.dollyIn(nearer);
  }

  // A point of the world in CSS pixels from the picture's top left corner.
  pixel(point) {
    const p = SPOT.fromArray(point).project(this.camera);
    return [((p.x + 1) * this.width) / 2, ((1 - p.y) * this.height) / 2];
  }

  // Where a pointer is, in the same pixels.
  place({ clientX, clientY }) {
    const box = this.canvas.getBoundingClientRect();
    return [clientX - box.left, clientY - box.top];
  }

  // The point under a pixel on the plane through `through` that faces the camera.
  onFacingPlane([x, y], through) {
    const place = new Vector2((2 * x) / this.width - 1, 1 - (2 * y) / this.height);
    SIGHT.setFromCamera(place, this.camera);
    const normal = this.camera.getWorldDirection(new Vector3());
    const plane = new Plane().setFromNormalAndCoplanarPoint(normal, new Vector3(...through));
    return SIGHT.ray.intersectPlane(plane, new Vector3())?.toArray() ?? null;
  }

  dispose() {
    this.abort.abort();
    near?.unobserve(this.canvas);
    this.resizes.disconnect();
    this.controls.dispose();
    freed(this.scene);
    this.sun.dispose();
    this.sky.dispose();
    this.canvas.figure = null;
    this.canvas.remove();
    figures.delete(this);
    if (figures.size || !shared) return;
    cancelAnimationFrame(frame);
    frame = null;
    shared.dispose();
    shared.forceContextLoss();
    shared = null;
  }
}

// Take an object out of its scene and give back what it alone holds on the graphics processor.
export function freed(object) {
  object.traverse((part) => {
    part.material?.dispose();
    if (part.isInstancedMesh) part.dispose();
    if (part.geometry && !isShared(part.geometry)) part.geometry.dispose();
  });
  object.removeFromParent();
}

export const emptied = (group) => [...group.children].forEach(freed);
