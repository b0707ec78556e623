// One WebGL renderer for all pictures of a page. Each figure is a 2D canvas that the rendered image
// is copied to, so twenty figures need one WebGL context, and every figure keeps its image when the
// context is lost.

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
import { waitForReader } from "./start.js";

let sharedRenderer = null;
let frameRequest = null;
let isDrawing = false; // whether the pictures are drawn; their still pictures stand until then
const figures = new Set();

// Return the renderer. Throws if the browser has no WebGL.
function getRenderer() {
  if (sharedRenderer) return sharedRenderer;
  sharedRenderer = new WebGLRenderer({
    antialias: true,
    alpha: true,
    powerPreference: "low-power",
  });
  sharedRenderer.setPixelRatio(1); // sizes below are in device pixels
  sharedRenderer.setScissorTest(true);
  sharedRenderer.shadowMap.enabled = true;
  sharedRenderer.shadowMap.type = PCFShadowMap;
  sharedRenderer.domElement.addEventListener("webglcontextlost", () =>
    figures.forEach((figure) => figure.onLost(true)),
  );
  sharedRenderer.domElement.addEventListener("webglcontextrestored", () => {
    figures.forEach((figure) => {
      figure.onLost(false);
      figure.request();
    });
  });
  return sharedRenderer;
}

// Return the renderer once drawing has begun; null without WebGL, which every figure is told.
function findRenderer() {
  if (!isDrawing) return null;
  try {
    return getRenderer();
  } catch {
    for (const figure of [...figures]) figure.onUnavailable();
    return null;
  }
}

/** Draw every picture near the window, now and from now on. */
export function startDrawing() {
  if (isDrawing) return;
  isDrawing = true;
  for (const figure of figures) figure.request();
}

// Return the GPU memory in use, the draw calls of the last picture and the number of figures; for
// tests.
export const inUse = () => ({
  ...sharedRenderer?.info.memory,
  calls: sharedRenderer?.info.render.calls,
  programs: sharedRenderer?.info.programs?.length,
  figures: figures.size,
});

/** Lose the WebGL context, as a busy GPU may; for tests. */
export const loseContext = () => sharedRenderer?.getContext().getExtension("WEBGL_lose_context");

const pendingSteps = new Set();

/**
 * Run a step once, right before the next pictures are drawn, so that a motion is drawn in the frame
 * in which it was computed.
 * @param {() => void} act
 */
export function beforeDrawing(act) {
  pendingSteps.add(act);
  frameRequest ??= requestAnimationFrame(drawDirty);
}

// Cancel a pending step. Returns whether it was pending.
export const cancelStep = (act) => pendingSteps.delete(act);

function drawDirty() {
  const now = [...pendingSteps];
  pendingSteps.clear();
  try {
    now.forEach((act) => act());
    const renderer = findRenderer();
    if (!renderer || renderer.getContext().isContextLost()) return;
    for (const figure of figures)
      if (figure.dirty && figure.visible && figure.width) figure.draw(renderer);
  } finally {
    frameRequest = pendingSteps.size ? requestAnimationFrame(drawDirty) : null;
  }
}

// Only pictures near the window are drawn; the others follow when they come near.
const visibilityObserver =
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

// Reused in every frame, so that none is allocated.
const scratchVector = new Vector3();
const raycaster = new Raycaster();

// Direction of the camera from an arm; the still picture uses the same.
export const INITIAL_VIEW = [0.687, -0.639, 0.344];

/**
 * A 3D picture in a host element: scene, lights, camera and pointer positions in pixels.
 * `onDraw(figure)` is called after each drawing, `onResize` after each change of size before the
 * first drawing, and `onUnavailable` if the browser turns out to have no WebGL. Throws if that is
 * known at once.
 */
export class Figure {
  constructor(host, { onDraw, onResize, onLost = (_) => {}, onUnavailable = () => {} }) {
    if (typeof WebGL2RenderingContext === "undefined") throw new Error("no WebGL");
    this.host = host;
    this.size = 1;
    this.onDraw = onDraw;
    this.onResize = onResize;
    this.onLost = onLost;
    this.onUnavailable = onUnavailable;
    this.dirty = true;
    this.visible = true;
    this.abort = new AbortController();
    this.points = null;
    this.view = INITIAL_VIEW;
    this.width = 0; // size of the host, stored because reading it forces a layout
    this.height = 0;
    this.foot = () => 0; // height in CSS pixels of the buttons at the bottom of the picture
    this.canvas = document.createElement("canvas");
    this.canvas.figure = this;
    this.context = this.canvas.getContext("2d");
    host.prepend(this.canvas);
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(32, 1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener("change", () => this.request());
    // Zooming waits until the picture has the focus, so that the page can scroll past it.
    this.controls.enableZoom = false;
    this.controls.enablePan = false;
    this.canvas.style.touchAction = "pan-y"; // set after OrbitControls, which sets "none"
    this.listen(host, "focusin", () => (this.controls.enableZoom = true));
    this.listen(host, "focusout", () => (this.controls.enableZoom = false));
    this.lights();
    figures.add(this);
    visibilityObserver?.observe(this.canvas);
    waitForReader(host, () => this.visible, startDrawing, this.signal);
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

  // Set lights and shadows for objects of a size (m).
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
    frameRequest ??= requestAnimationFrame(drawDirty);
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
    // Draw at once, because a resized canvas is blank.
    if (sharedRenderer && !sharedRenderer.getContext().isContextLost()) this.draw(sharedRenderer);
    else this.request();
    if (!isDrawing) this.onResize();
  }

  // Render the scene and copy the image to this figure's canvas.
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

  // Move the camera until all points are in view, above the buttons at the bottom. `view` is the
  // direction from the arm to the camera.
  fit(points, view = this.view) {
    this.points = points;
    this.view = view;
    if (!this.height) return; // the host has no size yet
    const { camera, controls, size } = this;
    this.fitted = camera.aspect;
    const foot = Math.min(0.3, this.foot() / this.height);
    const vectors = points.map((p) => new Vector3(...p));
    new Box3().setFromPoints(vectors).getCenter(controls.target);
    camera.position.copy(controls.target).addScaledVector(new Vector3(...view), 3 * size);
    Object.assign(camera, { near: size / 50, far: size * 40 });
    camera.updateProjectionMatrix();
    for (let step = 0; step < 4; step++) {
      controls.update();
      camera.updateMatrixWorld();
      const { min, max } = new Box3().setFromPoints(vectors.map((p) => p.clone().project(camera)));
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
    camera.updateMatrixWorld(); // for points that are projected before the next drawing
    this.request();
  }

  // Turn the camera by angles (rad) and move it nearer by a factor.
  orbit(turn, tilt, nearer = 1) {
    this.controls.rotateLeft(-turn);
    this.controls.rotateUp(-tilt);
    this.controls.dollyIn(nearer);
  }

  // Return the CSS pixels of a point, from the picture's top left corner.
  pixel(point) {
    const p = scratchVector.fromArray(point).project(this.camera);
    return [((p.x + 1) * this.width) / 2, ((1 - p.y) * this.height) / 2];
  }

  // Return how many pixels a length in metres has at a point.
  measurePixels(length, point) {
    const distance = this.camera.position.distanceTo(scratchVector.fromArray(point));
    const half = distance * Math.tan((this.camera.fov * Math.PI) / 360);
    return (length * this.height) / (2 * half);
  }

  /**
   * Return the position of a pointer in the same pixels.
   * @returns {[number, number]}
   */
  place({ clientX, clientY }) {
    const box = this.canvas.getBoundingClientRect();
    return [clientX - box.left, clientY - box.top];
  }

  // Return the point under a pixel on the plane through `through` that faces the camera.
  onFacingPlane([x, y], through) {
    const place = new Vector2((2 * x) / this.width - 1, 1 - (2 * y) / this.height);
    raycaster.setFromCamera(place, this.camera);
    const normal = this.camera.getWorldDirection(new Vector3());
    const plane = new Plane().setFromNormalAndCoplanarPoint(normal, new Vector3(...through));
    return raycaster.ray.intersectPlane(plane, new Vector3())?.toArray() ?? null;
  }

  dispose() {
    this.abort.abort();
    visibilityObserver?.unobserve(this.canvas);
    this.resizes.disconnect();
    this.controls.dispose();
    removeAndDispose(this.scene);
    this.sun.dispose();
    this.sky.dispose();
    this.canvas.figure = null;
    this.canvas.remove();
    figures.delete(this);
    if (figures.size || !sharedRenderer) return;
    cancelAnimationFrame(frameRequest);
    frameRequest = null;
    sharedRenderer.dispose();
    sharedRenderer.forceContextLoss();
    sharedRenderer = null;
  }
}

// Remove an object from its scene and dispose its materials and geometries, except shared ones.
export function removeAndDispose(object) {
  object.traverse((part) => {
    part.material?.dispose();
    if (part.isInstancedMesh) part.dispose();
    if (part.geometry && !isShared(part.geometry)) part.geometry.dispose();
  });
  object.removeFromParent();
}

export const disposeChildren = (group) => [...group.children].forEach(removeAndDispose);
