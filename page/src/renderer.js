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
import { clamp } from "../../judge/geometry/planar.js";
import { isSharedGeometry } from "./shapes.js";

let sharedRenderer = null;
let frameRequest = null;
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
    figures.forEach((figure) => figure.onContextChange(true)),
  );
  sharedRenderer.domElement.addEventListener("webglcontextrestored", () => {
    figures.forEach((figure) => {
      figure.onContextChange(false);
      figure.requestDrawing();
    });
  });
  return sharedRenderer;
}

// Return the renderer. Without WebGL, notify every figure and return null.
function getRendererIfAvailable() {
  try {
    return getRenderer();
  } catch {
    for (const figure of [...figures]) figure.onUnavailable();
    return null;
  }
}

/** Return GPU memory, draw calls of the last picture and number of figures, for tests. */
export const getUsage = () => ({
  ...sharedRenderer?.info.memory,
  calls: sharedRenderer?.info.render.calls,
  programs: sharedRenderer?.info.programs?.length,
  figures: figures.size,
});

/** Return the extension that loses the WebGL context, as a busy GPU may, for tests. */
export const getContextLoser = () =>
  sharedRenderer?.getContext().getExtension("WEBGL_lose_context");

const pendingSteps = new Set();

/**
 * Run a step once before the next drawing. A motion is then drawn in the frame that computed it.
 * @param {() => void} step
 */
export function runBeforeDrawing(step) {
  pendingSteps.add(step);
  frameRequest ??= requestAnimationFrame(drawChangedFigures);
}

// Cancel a pending step. Returns whether it was pending.
export const cancelStep = (step) => pendingSteps.delete(step);

function drawChangedFigures() {
  const steps = [...pendingSteps];
  pendingSteps.clear();
  try {
    steps.forEach((step) => step());
    const renderer = getRendererIfAvailable();
    if (!renderer || renderer.getContext().isContextLost()) return;
    for (const figure of figures)
      if (figure.needsDrawing && figure.isNearWindow && figure.width) figure.render(renderer);
  } finally {
    frameRequest = pendingSteps.size ? requestAnimationFrame(drawChangedFigures) : null;
  }
}

// Only pictures near the window are drawn.
const visibilityObserver =
  typeof IntersectionObserver === "undefined"
    ? null
    : new IntersectionObserver(
        (entries) => {
          for (const { target, isIntersecting } of entries) {
            const figure = target.figure;
            if (!figure) continue;
            figure.isNearWindow = isIntersecting;
            if (isIntersecting) figure.requestDrawing();
          }
        },
        { rootMargin: "200px" },
      );

// These two are reused, so that no frame allocates objects.
const scratchVector = new Vector3();
const raycaster = new Raycaster();

const VIEW_EDGE = 0.82; // share of half the picture within which the view keeps the tip

/** Direction from an arm to the camera, in the still picture too. */
export const INITIAL_VIEW = [0.687, -0.639, 0.344];

/**
 * A 3D picture in a host element, with its scene, lights and camera.
 *
 * It calls `onDraw(figure)` after each drawing, `onResize()` after each change of size before the
 * first drawing, `onContextChange(isLost)` when the WebGL context is lost or restored, and
 * `onUnavailable()` if WebGL turns out to be missing. It throws if that is known at once.
 */
export class Figure {
  constructor(host, { onDraw, onResize, onContextChange, onUnavailable }) {
    if (typeof WebGL2RenderingContext === "undefined") throw new Error("no WebGL");
    this.host = host;
    this.size = 1; // of the objects, in m
    this.onDraw = onDraw;
    this.onResize = onResize;
    this.onContextChange = onContextChange;
    this.onUnavailable = onUnavailable;
    this.needsDrawing = true;
    this.isNearWindow = true;
    this.abortController = new AbortController();
    this.fittedPoints = null;
    this.viewDirection = INITIAL_VIEW;
    this.width = 0; // size of the host, stored because reading it forces a layout
    this.height = 0;
    this.getFootHeight = () => 0; // CSS pixels that buttons cover at the bottom
    this.canvas = document.createElement("canvas");
    this.canvas.figure = this;
    this.context = this.canvas.getContext("2d");
    host.prepend(this.canvas);
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(32, 1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener("change", () => this.requestDrawing());
    // Zooming waits until the picture has the focus, so that the page can scroll past it.
    this.controls.enableZoom = false;
    this.controls.enablePan = false;
    this.canvas.style.touchAction = "pan-y"; // set after OrbitControls, which sets "none"
    this.addListener(host, "focusin", () => (this.controls.enableZoom = true));
    this.addListener(host, "focusout", () => (this.controls.enableZoom = false));
    this.addLights();
    figures.add(this);
    visibilityObserver?.observe(this.canvas);
    this.resizeObserver = new ResizeObserver(() => this.fitCanvasToHost());
    this.resizeObserver.observe(host);
  }

  get signal() {
    return this.abortController.signal;
  }

  // Listen to an event until the figure is disposed.
  addListener(target, type, handler, options = {}) {
    target.addEventListener(type, handler, { ...options, signal: this.signal });
  }

  addLights() {
    this.sky = new HemisphereLight("#ffffff", "#8d95a1");
    this.sky.position.set(0, 0, 1);
    this.sun = new DirectionalLight("#ffffff");
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(1024, 1024);
    this.sun.shadow.radius = 5;
    this.sun.shadow.bias = -0.002;
    this.scene.add(this.sky, this.sun, this.sun.target);
  }

  // Set lights and shadows for objects of a size (m).
  setLights(size, { sky, sun }) {
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

  requestDrawing() {
    this.needsDrawing = true;
    frameRequest ??= requestAnimationFrame(drawChangedFigures);
  }

  // Give the canvas the size of its host.
  fitCanvasToHost() {
    const { clientWidth: width, clientHeight: height } = this.host;
    Object.assign(this, { width, height });
    if (!width || !height) return;
    const ratio = Math.min(devicePixelRatio, 2);
    const [canvasWidth, canvasHeight] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (this.canvas.width === canvasWidth && this.canvas.height === canvasHeight) return;
    Object.assign(this.canvas, { width: canvasWidth, height: canvasHeight });
    Object.assign(this.canvas.style, { width: `${width}px`, height: `${height}px` });
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.fittedPoints && !(Math.abs(this.fittedAspect - this.camera.aspect) < 0.01))
      this.fitView(this.fittedPoints);
    this.needsDrawing = true;
    // Draw at once, because a resized canvas is blank.
    if (sharedRenderer && !sharedRenderer.getContext().isContextLost()) this.render(sharedRenderer);
    else {
      this.requestDrawing();
      this.onResize();
    }
  }

  // Render the scene and copy the image to this figure's canvas.
  render(renderer) {
    const { width, height } = this.canvas;
    const size = renderer.getSize(new Vector2());
    if (width > size.x || height > size.y)
      renderer.setSize(Math.max(width, size.x), Math.max(height, size.y), false);
    renderer.setViewport(0, 0, width, height);
    renderer.setScissor(0, 0, width, height);
    renderer.render(this.scene, this.camera);
    this.needsDrawing = false;
    this.context.clearRect(0, 0, width, height);
    const top = renderer.domElement.height - height;
    this.context.drawImage(renderer.domElement, 0, top, width, height, 0, 0, width, height);
    this.onDraw(this);
  }

  // Move the camera until all points are in view, above the buttons at the bottom. `direction`
  // points from the arm to the camera.
  fitView(points, direction = this.viewDirection) {
    this.fittedPoints = points;
    this.viewDirection = direction;
    if (!this.height) return; // the host has no size yet
    const { camera, controls, size } = this;
    this.fittedAspect = camera.aspect;
    const foot = Math.min(0.3, this.getFootHeight() / this.height);
    const vectors = points.map((p) => new Vector3(...p));
    new Box3().setFromPoints(vectors).getCenter(controls.target);
    camera.position.copy(controls.target).addScaledVector(new Vector3(...direction), 3 * size);
    Object.assign(camera, { near: size / 50, far: size * 40 });
    camera.updateProjectionMatrix();
    for (let step = 0; step < 4; step++) {
      controls.update();
      camera.updateMatrixWorld();
      const { min, max } = new Box3().setFromPoints(vectors.map((p) => p.clone().project(camera)));
      const lift = Math.max(0, Math.min(foot, (max.y - min.y) / 2 - 1 + 2 * foot));
      const [widthShare, heightShare] = [
        (max.x - min.x) / 2 / 0.81,
        (max.y - min.y) / 2 / Math.min(0.81, 0.96 - foot),
      ];
      const [right, up] = [(min.x + max.x) / 2, (min.y + max.y) / 2 - lift];
      this.moveView(right, up, Math.max(widthShare, heightShare));
    }
    this.requestDrawing();
  }

  // Widen the view until a point is in it. All that was in view stays in view.
  widenView(point) {
    if (!this.height) return; // the host has no size yet
    for (let step = 0; step < 8; step++) {
      const { x, y } = new Vector3(...point).project(this.camera);
      const beyond = [x, y].map((share) => share - clamp(share, -VIEW_EDGE, VIEW_EDGE));
      const [right, up] = beyond.map((share) => clamp(share / 2, -0.5, 0.5));
      if (!right && !up) return;
      this.moveView(right, up, 1 + Math.max(Math.abs(right), Math.abs(up)));
    }
  }

  // Move the view by shares of half its width and height, and the camera away by a factor.
  moveView(rightShare, upShare, factor) {
    const { camera, controls } = this;
    const away = camera.position.clone().sub(controls.target);
    const half = away.length() * Math.tan((camera.fov * Math.PI) / 360);
    const [right, up] = [0, 1].map((i) => new Vector3().setFromMatrixColumn(camera.matrixWorld, i));
    controls.target.addScaledVector(right, rightShare * half * camera.aspect);
    controls.target.addScaledVector(up, upShare * half);
    camera.position.copy(controls.target).addScaledVector(away, factor);
    controls.update();
    camera.updateMatrixWorld(); // for points that are projected before the next drawing
  }

  isInView(point) {
    const [x, y] = this.projectToPixel(point);
    return x >= 0 && x <= this.width && y >= 0 && y <= this.height;
  }

  // Turn the camera by angles (rad) and move it nearer by a factor.
  turnView(turn, tilt, nearer = 1) {
    this.controls.rotateLeft(-turn);
    this.controls.rotateUp(-tilt);
    this.controls.dollyIn(nearer);
  }

  // Project a point to CSS pixels from the picture's top left corner.
  projectToPixel(point) {
    const p = scratchVector.fromArray(point).project(this.camera);
    return [((p.x + 1) * this.width) / 2, ((1 - p.y) * this.height) / 2];
  }

  // Return the size in pixels of a length (m) at a point.
  measurePixels(length, point) {
    const distance = this.camera.position.distanceTo(scratchVector.fromArray(point));
    const half = distance * Math.tan((this.camera.fov * Math.PI) / 360);
    return (length * this.height) / (2 * half);
  }

  /**
   * Return the position of a pointer in CSS pixels from the picture's top left corner.
   * @returns {[number, number]}
   */
  getPointerPixel({ clientX, clientY }) {
    const box = this.canvas.getBoundingClientRect();
    return [clientX - box.left, clientY - box.top];
  }

  // Project a pixel onto the plane through a point that faces the camera.
  projectToFacingPlane([x, y], point) {
    const position = new Vector2((2 * x) / this.width - 1, 1 - (2 * y) / this.height);
    raycaster.setFromCamera(position, this.camera);
    const normal = this.camera.getWorldDirection(new Vector3());
    const plane = new Plane().setFromNormalAndCoplanarPoint(normal, new Vector3(...point));
    return raycaster.ray.intersectPlane(plane, new Vector3())?.toArray() ?? null;
  }

  dispose() {
    this.abortController.abort();
    visibilityObserver?.unobserve(this.canvas);
    this.resizeObserver.disconnect();
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

/** Remove an object from its scene and dispose its materials and unshared geometries. */
export function removeAndDispose(object) {
  object.traverse((part) => {
    part.material?.dispose();
    if (part.isInstancedMesh) part.dispose();
    if (part.geometry && !isSharedGeometry(part.geometry)) part.geometry.dispose();
  });
  object.removeFromParent();
}

export const disposeChildren = (group) => [...group.children].forEach(removeAndDispose);
