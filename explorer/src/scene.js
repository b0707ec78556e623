// The 3D view: draws the state when it has changed, and turns what a pointer does into what the reader means.

import {
  Box3, CylinderGeometry, DirectionalLight, Group, HemisphereLight, Mesh, MeshBasicMaterial, MeshStandardMaterial, PCFShadowMap, PerspectiveCamera,
  Plane, PlaneGeometry, Raycaster, Scene, ShadowMaterial, SphereGeometry, Spherical, Vector2, Vector3, WebGLRenderer, DoubleSide,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { isThere } from "./motion.js";
import { linkFrames, minus, norm, plus, scaled } from "./kinematics.js";
import { along, ArmShape, Arrow, Ellipsoid, Triad, floor, ghostMaterial, reachOf, tube, wall } from "./shapes.js";

const LOOK = {
  light: { lit: "#E69F00", link: "#e9edf2", joint: "#34506b", grid: "#8793a3", gridStrength: 0.34, shadow: 0.16, sky: 2.1, sun: 1.5, path: "#D55E00", force: "#C77E00", ghost: "#0072B2", ellipsoid: "#9a4f86" },
  dark: { lit: "#F0B429", link: "#c3ccd8", joint: "#5f86ad", grid: "#93a1b5", gridStrength: 0.26, shadow: 0.28, sky: 1.15, sun: 1.7, path: "#F58A3C", force: "#F0B429", ghost: "#56B4E9", ellipsoid: "#d79bc3" },
};
const BRANCH_COLOURS = ["#0072B2", "#D55E00", "#009E73", "#E69F00", "#CC79A7", "#56B4E9", "#882255", "#7a8290"];
export const branchColour = (i) => BRANCH_COLOURS[i % BRANCH_COLOURS.length];

const VIEW = new Vector3(0.687, -0.639, 0.344); // where the camera stands first, seen from the arm; the still picture's too

const FORCE_HALF = 10; // N: drawn half as long as the longest arrow,
const FORCE_LONGEST = 0.36; // which is this share of the arm

export class Stage {
  constructor(host, labels, { onForce, onBranch }) {
    Object.assign(this, { host, labels, onForce, onBranch });
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true, powerPreference: "low-power" });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.canvas = this.renderer.domElement;
    host.prepend(this.canvas);
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(32, 1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener("change", () => this.request());
    this.controls.enableZoom = false; // until the view has the focus, so that a page scrolls past it
    this.controls.enablePan = false;
    this.canvas.style.touchAction = "pan-y";
    this.lights();
    this.listen();
    new ResizeObserver(() => this.resize()).observe(host);
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
  }

  // Build everything that does not move with the joints.
  build(arm, dark) {
    this.dark = dark;
    this.look = LOOK[dark ? "dark" : "light"];
    if (this.world) dispose(this.world);
    this.arm = arm;
    this.size = reachOf(arm);
    this.world = new Group();
    this.scene.add(this.world);
    const { look, size } = this;
    const link = new MeshStandardMaterial({ color: look.link, roughness: 0.45, metalness: 0.02 });
    const joint = new MeshStandardMaterial({ color: look.joint, roughness: 0.4, metalness: 0.1 });
    this.body = new ArmShape(arm, { link, joint });
    this.lit = joint.clone();
    this.lit.color.set(look.lit);
    this.axis = new Mesh(new CylinderGeometry(1, 1, 1, 12), new MeshBasicMaterial({ color: look.lit, transparent: true, opacity: 0.75 }));
    this.shade = new Mesh(new PlaneGeometry(4 * size, 4 * size), new ShadowMaterial({ opacity: look.shadow }));
    this.shade.receiveShadow = true;
    this.shade.position.z = -0.001 * size;
    this.triads = Array.from({ length: arm.rows.length + 1 }, () => new Triad(dark));
    this.ellipsoid = new Ellipsoid(look.ellipsoid);
    const force = new MeshBasicMaterial({ color: look.force });
    this.force = new Arrow(force);
    this.handle = new Mesh(new SphereGeometry(0.022 * size, 20, 14), force);
    [this.path, this.ghosts, this.reference] = [new Group(), new Group(), new Group()];
    this.world.add(this.body, floor(1.0 * size, look.grid, look.gridStrength), this.shade, ...this.triads, this.axis, this.ellipsoid, this.force, this.handle, this.path, this.ghosts, this.reference);
    this.sky.intensity = look.sky;
    this.sun.intensity = look.sun;
    this.sun.position.set(0.55 * size, -0.75 * size, 2 * size);
    Object.assign(this.sun.shadow.camera, { left: -size, right: size, top: size, bottom: -size, near: 0.05 * size, far: 4 * size });
    this.sun.shadow.camera.updateProjectionMatrix();
    this.shown = {};
  }

  // Bring the view up to date with the state; only what changed is built anew.
  draw(state, derived, theme) {
    const dark = theme === "dark";
    const first = !this.body;
    if (this.arm !== state.arm || this.dark !== dark) this.build(state.arm, dark);
    const { frames } = derived;
    this.frames = frames;
    this.body.pose(frames);
    this.body.light(state.lit, this.lit);
    this.drawAxis(frames[state.lit]);
    this.drawFrames(frames, state.frames);
    this.ellipsoid.visible = state.view === "jacobian";
    this.ellipsoidScale = (0.15 * this.size) / Math.max(derived.linear.values[0], 1e-6);
    if (this.ellipsoid.visible) this.ellipsoid.pose(frames.at(-1).o, derived.linear, this.ellipsoidScale, 0.003 * this.size);
    this.drawForce(frames.at(-1).o, state);
    this.drawPath(state);
    this.drawGhosts(state);
    this.drawReference(state);
    if (first) this.fit();
    this.request();
  }

  // The axis about or along which the joint under the reader's hand moves.
  drawAxis(frame) {
    const half = frame ? scaled(0.16 * this.size, frame.z) : [0, 0, 0];
    const [start, end] = frame ? [minus(frame.o, half), plus(frame.o, half)] : [half, half];
    along(this.axis, start, end, 0.0025 * this.size);
  }

  drawFrames(frames, which) {
    const length = 0.1 * this.size;
    const shared = new Map();
    this.triads.forEach((triad, i) => {
      triad.visible = which === "all" || i === 0 || i === frames.length - 1;
      if (!triad.visible) return;
      triad.pose(frames[i], length);
      for (const axis of ["x", "z"]) {
        const tip = plus(frames[i].o, scaled(1.22 * length, frames[i][axis]));
        const key = axis + tip.map((v) => Math.round(v / this.size * 500)).join();
        shared.set(key, { axis, tip, indices: [...(shared.get(key)?.indices ?? []), i] });
      }
    });
    this.tags = [...shared.values()];
    this.labels.replaceChildren(...this.tags.map(({ axis, indices }) => {
      const span = document.createElement("span");
      span.className = `axis-${axis}`;
      span.innerHTML = `<i>${axis}</i><sub>${indices.join(",")}</sub>`;
      return span;
    }));
  }

  drawForce(tip, { view, wrench }) {
    const force = wrench.slice(0, 3);
    const shown = view === "torque";
    const size = norm(force);
    const way = size ? scaled((FORCE_LONGEST * this.size) / (size + FORCE_HALF), force) : [0, 0, 0];
    this.force.point(minus(tip, way), way, 0.007 * this.size);
    this.force.visible &&= shown;
    this.handle.visible = shown;
    this.handle.position.set(...minus(tip, way));
    this.tip = tip;
    if (shown && !this.shown.force) this.fit();
    this.shown.force = shown;
  }

  // The force whose arrow comes from a point.
  forceFrom(point) {
    const way = minus(this.tip, point);
    const length = Math.min(norm(way), FORCE_LONGEST * this.size * (100 / (100 + FORCE_HALF)));
    if (length < 0.015 * this.size) return [0, 0, 0];
    const size = (FORCE_HALF * length) / (FORCE_LONGEST * this.size - length);
    return scaled(size / norm(way), way);
  }

  drawPath({ view, trace, arm }) {
    const wanted = ["trace", "torque"].includes(view) ? trace : null;
    if (this.shown.path === wanted) return;
    this.shown.path = wanted;
    clear(this.path);
    if (!wanted) return;
    const points = wanted.map((q) => linkFrames(arm, q).at(-1).o);
    const pane = new MeshBasicMaterial({ color: this.look.ghost, transparent: true, opacity: this.dark ? 0.16 : 0.1, side: DoubleSide, depthWrite: false });
    const square = wall(points, pane);
    this.path.add(tube(points, 0.0035 * this.size, this.look.path), ...(square ? [square] : []));
  }

  drawGhosts({ view, ways, arm, q, highlighted }) {
    const wanted = view === "branches" ? ways : null;
    if (this.shown.ways !== wanted) {
      clear(this.ghosts);
      (wanted ?? []).forEach(({ q }, i) => {
        const material = ghostMaterial(branchColour(i), 0.3);
        const shape = new ArmShape(arm, { link: material, joint: material, ghost: true });
        shape.pose(linkFrames(arm, q));
        shape.userData.way = i;
        this.ghosts.add(shape);
      });
      this.shown.ways = wanted;
      if (wanted) this.fit();
    }
    for (const shape of this.ghosts.children) {
      const way = ways[shape.userData.way].q;
      shape.visible = !isThere(way, q);
      shape.children[0].material.opacity = highlighted === shape.userData.way ? 0.75 : highlighted == null ? 0.3 : 0.14;
    }
  }

  drawReference({ view, reference, q, arm }) {
    const differs = view === "table" && reference && reference !== arm;
    clear(this.reference);
    if (!differs || reference.rows.filter((row) => row.kind !== "fixed").length !== q.length) return;
    const material = ghostMaterial(this.look.ghost, 0.26);
    const shape = new ArmShape(reference, { link: material, joint: material, ghost: true });
    shape.pose(linkFrames(reference, q));
    this.reference.add(shape);
  }

  // Stand where the whole arm is in view, with the tips of its frames.
  fit() {
    const ends = this.frames.flatMap(({ x, z, o }) => [o, ...[x, z].map((axis) => plus(o, scaled(0.13 * this.size, axis)))]);
    const ghosts = (this.shown.ways ?? []).flatMap(({ q }) => linkFrames(this.arm, q).map((frame) => frame.o));
    const handle = this.handle.visible ? [this.handle.position.toArray()] : [];
    const points = [...ends, ...ghosts, ...handle, [0, 0, 0], [0, 0, 0.3 * this.size]].map((p) => new Vector3(...p));
    const { camera, controls } = this;
    new Box3().setFromPoints(points).getCenter(controls.target);
    camera.position.copy(controls.target).addScaledVector(VIEW, 3 * this.size);
    Object.assign(camera, { near: this.size / 50, far: this.size * 40 });
    camera.updateProjectionMatrix();
    for (let step = 0; step < 4; step++) {
      controls.update();
      camera.updateMatrixWorld();
      const { min, max } = new Box3().setFromPoints(points.map((p) => p.clone().project(camera)));
      const away = camera.position.clone().sub(controls.target);
      const half = away.length() * Math.tan((camera.fov * Math.PI) / 360);
      const [right, up] = [0, 1].map((i) => new Vector3().setFromMatrixColumn(camera.matrixWorld, i));
      controls.target.addScaledVector(right, ((min.x + max.x) / 2) * half * camera.aspect);
      controls.target.addScaledVector(up, ((min.y + max.y) / 2) * half);
      away.multiplyScalar(Math.max((max.x - min.x) / 2, (max.y - min.y) / 2) / 0.84);
      camera.position.copy(controls.target).add(away);
    }
    controls.update();
    this.request();
  }

  // Turn the camera by angles (rad) and bring it nearer by a factor.
  orbit(turn, tilt, nearer = 1) {
    const away = this.camera.position.clone().sub(this.controls.target);
    const place = new Spherical().setFromVector3(new Vector3(away.y, away.z, away.x));
    place.theta += turn;
    place.phi = Math.min(3.1, Math.max(0.05, place.phi + tilt));
    place.radius *= nearer;
    const turned = new Vector3().setFromSpherical(place);
    this.camera.position.copy(this.controls.target).add(new Vector3(turned.z, turned.x, turned.y));
    this.controls.update();
  }

  listen() {
    const { canvas, controls } = this;
    const ray = new Raycaster();
    let [drag, down] = [null, null];
    const aim = (event) => {
      const box = canvas.getBoundingClientRect();
      const x = ((event.clientX - box.left) / box.width) * 2 - 1;
      ray.setFromCamera(new Vector2(x, 1 - ((event.clientY - box.top) / box.height) * 2), this.camera);
      return ray;
    };
    const onHandle = (event) => this.handle?.visible && aim(event).ray.distanceToPoint(this.handle.position) < 0.045 * this.size;
    canvas.addEventListener("pointerdown", (event) => {
      down = [event.clientX, event.clientY];
      if (!onHandle(event)) return;
      event.stopImmediatePropagation();
      controls.enabled = false;
      canvas.setPointerCapture(event.pointerId);
      drag = new Plane().setFromNormalAndCoplanarPoint(this.camera.getWorldDirection(new Vector3()), this.handle.position);
    }, true);
    canvas.addEventListener("pointermove", (event) => {
      if (!drag) return (canvas.style.cursor = onHandle(event) || this.wayAt(aim(event)) !== null ? "pointer" : "grab");
      const point = aim(event).ray.intersectPlane(drag, new Vector3());
      if (point) this.onForce(this.forceFrom(point.toArray()));
    });
    const release = (event) => {
      const still = down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4;
      if (still && !drag) {
        const way = this.wayAt(aim(event));
        if (way !== null) this.onBranch(way);
      }
      [drag, down] = [null, null];
      controls.enabled = true;
    };
    canvas.addEventListener("pointerup", release);
    canvas.addEventListener("pointercancel", release);
    this.host.addEventListener("focusin", () => (controls.enableZoom = true));
    this.host.addEventListener("focusout", () => (controls.enableZoom = false));
  }

  wayAt(ray) {
    const seen = (this.ghosts?.children ?? []).filter((shape) => shape.visible).flatMap((shape) => shape.children.filter((part) => part.visible));
    const hit = ray.intersectObjects(seen, false)[0];
    return hit?.object.parent.userData.way ?? null;
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height);
    const before = this.camera.aspect;
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.frames && Math.abs(before - this.camera.aspect) > 0.01) this.fit();
    this.render(); // at once: a canvas of another size is blank
  }

  request() {
    this.pending ||= requestAnimationFrame(() => {
      this.pending = null;
      this.render();
    });
  }

  render() {
    if (!this.world || !this.host.clientWidth) return;
    this.renderer.render(this.scene, this.camera);
    const { clientWidth: width, clientHeight: height } = this.host;
    this.tags?.forEach(({ tip }, i) => {
      const p = new Vector3(...tip).project(this.camera);
      this.labels.children[i].style.transform = `translate(${((p.x + 1) * width) / 2}px, ${((1 - p.y) * height) / 2}px) translate(-50%, -50%)`;
    });
  }
}

function clear(group) {
  for (const child of [...group.children]) dispose(child);
}

function dispose(object) {
  object.traverse((part) => {
    part.material?.dispose();
    if (part.geometry?.type === "TubeGeometry") part.geometry.dispose();
  });
  object.removeFromParent();
}

