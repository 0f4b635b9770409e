// SPDX-License-Identifier: Apache-2.0
// The bag in three dimensions, from the frames of a run.
"use strict";

// The bytes of base64 of what zlib has packed.
const unpacked = text => {
  const packed = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();
};

// Frames of a run: header, and the rest of frames.bin.
class Frames {
  constructor(header, bytes) {
    this.header = header;
    this.bytes = bytes;
    this.count = bytes.byteLength / header.frame_bytes;
    this.time = Array.from({ length: this.count }, (_, i) => this.scalars(i).time_s);
  }

  scalars(i) {
    const view = new DataView(this.bytes, i * this.header.frame_bytes);
    return Object.fromEntries(this.header.scalars.map((name, k) => [name, view.getFloat64(8 * k, true)]));
  }

  frame(i) {
    const { nodes, elements, frame_bytes, scalars } = this.header, s = this.scalars(i);
    let at = i * frame_bytes + 8 * scalars.length;
    const whole = count => { const list = new Uint16Array(this.bytes, at, count); at += 2 * count; return list; };
    const scaled = (list, step, low = 0) => Float32Array.from(list, v => low + step * v);
    const corner = [s.x_m, s.y_m, s.z_m];
    const position = Float32Array.from(whole(3 * nodes), (v, k) => corner[k % 3] + s.position_step_m * v);
    const speed = scaled(whole(nodes), s.speed_step_m_s);
    const jet = scaled(whole(elements), s.jet_step_Pa);
    const strain = scaled(whole(elements), s.strain_step, s.strain_low);
    return { s, position, speed, jet, strain, mask: new Uint8Array(this.bytes, at, elements) };
  }
}

// value: by element e with corners t, of a frame f. moving: a rigid target has none.
const quantities = {
  overpressure: { title: "overpressure, gas and jet", unit: "Pa", moving: true, value: (f, e) => f.s.overpressure_Pa + f.jet[e] },
  jet_overpressure: { title: "overpressure of the jet", unit: "Pa", value: (f, e) => f.jet[e] },
  mask: { title: "jet mask", classes: ["outside the jet", "in it, but hidden", "hit by the jet"], value: (f, e) => f.mask[e] },
  strain: { title: "larger principal strain", unit: "", moving: true, value: (f, e) => f.strain[e] },
  speed: { title: "speed", unit: "m/s", moving: true, value: (f, e, t) => (f.speed[t[0]] + f.speed[t[1]] + f.speed[t[2]]) / 3 },
  none: { title: "none" },
};
// viridis, dark to light; classes from a set that colour-blind readers tell apart.
const ramp = [[68, 1, 84], [71, 44, 122], [59, 81, 139], [44, 113, 142], [33, 144, 141], [39, 173, 129], [92, 200, 99], [170, 220, 50], [253, 231, 37]];
const classColours = [[170, 176, 184], [0, 114, 178], [230, 120, 0]];
const fabric = [190, 196, 204];

const rampColour = share => {
  const x = Math.min(1, Math.max(0, share)) * (ramp.length - 1), i = Math.min(ramp.length - 2, Math.floor(x));
  return ramp[i].map((low, c) => low + (x - i) * (ramp[i + 1][c] - low));
};

const surface = ({ nodes_m, triangles }) => {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(nodes_m.flat(), 3));
  geometry.setIndex(triangles.flat());
  geometry.computeVertexNormals();
  return geometry;
};
const vector = list => new THREE.Vector3(...list);

class View {
  constructor(place, name, frames, up) {
    Object.assign(this, { name, frames, up });
    this.root = element("div", { class: "view" }, element("span", { class: "name", textContent: name }));
    place.append(this.root);
    this.renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.domElement.tabIndex = 0;
    this.renderer.domElement.setAttribute("aria-label", `${name}: a drag or the arrow keys turn it, plus and minus come nearer or farther`);
    this.renderer.domElement.addEventListener("keydown", event => this.key(event));
    this.root.append(this.renderer.domElement);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(30, 1, 0.01, 100);
    this.camera.up.copy(up);
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x8a8f98, 0.75));
    const lamp = new THREE.DirectionalLight(0xffffff, 0.45);
    lamp.position.set(0.4, 0.6, 1);
    this.camera.add(lamp);
    this.scene.add(this.camera);
    this.controls = new THREE.OrbitControls(this.camera, this.renderer.domElement);
    this.controls.enableKeys = false;
    this.controls.addEventListener("change", () => { this.render(); this.onturn && this.onturn(this); });
    this.size = Math.max(...frames.time.map((_, i) => 65535 * frames.scalars(i).position_step_m), ...this.box().getSize(new THREE.Vector3()).toArray()); // [m] largest extent
    this.makeBag();
    this.makeSurroundings();
    new ResizeObserver(() => this.resize()).observe(this.root);
  }

  makeBag() {
    const { triangles, nodes } = this.frames.header;
    this.skin = new THREE.BufferGeometry();
    this.skin.setAttribute("position", new THREE.BufferAttribute(new Float32Array(9 * triangles.length), 3));
    this.skin.setAttribute("color", new THREE.BufferAttribute(new Float32Array(9 * triangles.length), 3));
    this.material = new THREE.MeshPhongMaterial({ vertexColors: THREE.VertexColors, side: THREE.DoubleSide, flatShading: true, shininess: 5, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    const mesh = new THREE.Mesh(this.skin, this.material);
    const pairs = new Set();
    for (const t of triangles) for (let k = 0; k < 3; ++k) {
      const a = t[k], b = t[(k + 1) % 3];
      pairs.add(Math.min(a, b) * nodes + Math.max(a, b));
    }
    const index = [];
    for (const pair of pairs) index.push(Math.floor(pair / nodes), pair % nodes);
    this.net = new THREE.BufferGeometry();
    this.net.setAttribute("position", new THREE.BufferAttribute(new Float32Array(3 * nodes), 3));
    this.net.setIndex(index);
    this.edges = new THREE.LineSegments(this.net, new THREE.LineBasicMaterial({ color: 0x20262e, transparent: true, opacity: 0.35 }));
    for (const part of [mesh, this.edges]) part.frustumCulled = false;
    this.scene.add(mesh, this.edges);
  }

  makeSurroundings() {
    const { straps, plates, jets, pendulum, impactor } = this.frames.header, grey = 0x8a929c;
    this.straps = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0xd03030 }));
    this.straps.geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(6 * straps.length), 3));
    this.straps.frustumCulled = false;
    this.scene.add(this.straps);
    for (const { point_m, normal } of plates) {
      const side = 1.2 * this.size;
      const plate = new THREE.Mesh(new THREE.PlaneGeometry(side, side), new THREE.MeshBasicMaterial({ color: grey, transparent: true, opacity: 0.25, side: THREE.DoubleSide, depthWrite: false }));
      const rim = new THREE.LineSegments(new THREE.EdgesGeometry(plate.geometry), new THREE.LineBasicMaterial({ color: grey }));
      plate.add(rim);
      plate.position.copy(vector(point_m));
      plate.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), vector(normal).normalize());
      this.scene.add(plate);
    }
    this.jets = jets.map(jet => this.makeJet(jet));
    if (!pendulum && !impactor) return;
    const metal = new THREE.MeshPhongMaterial({ color: 0x5a6470, shininess: 40 });
    this.impactor = new THREE.Mesh(pendulum ? new THREE.SphereGeometry(pendulum.radius_m, 32, 20) : surface(impactor), metal);
    this.scene.add(this.impactor);
    const pivot = (pendulum ?? impactor).pivot_m;
    if (!pivot) return;
    this.arm = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0x5a6470 }));
    this.arm.geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array([...pivot, 0, 0, 0]), 3));
    this.arm.frustumCulled = false;
    this.scene.add(this.arm);
  }

  // The outlet's rim, and rims of the jet's edge along its axis.
  makeJet(jet) {
    const axis = vector(jet.axis).normalize(), across = vector(jet.across).normalize(), side = axis.clone().cross(across);
    const rim = (z, width) => {
      const corners = jet.half_length_m > 0
        ? [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([a, b]) => [a * jet.half_length_m, b * width])
        : Array.from({ length: 32 }, (_, i) => [width * Math.cos(i * Math.PI / 16), width * Math.sin(i * Math.PI / 16)]);
      return corners.map(([a, b]) => vector(jet.centre_m).addScaledVector(axis, z).addScaledVector(across, a).addScaledVector(side, b));
    };
    const loop = (points, colour) => new THREE.LineLoop(new THREE.BufferGeometry().setFromPoints(points), new THREE.LineBasicMaterial({ color: colour }));
    const outlet = loop(rim(0, jet.half_width_m), 0xe67800), edge = new THREE.Group();
    outlet.material.depthTest = false;
    const rims = jet.sections_m.map(([z, width]) => rim(z, width));
    const points = [];
    for (let i = 1; i < rims.length; ++i) rims[i].forEach((p, k) => {
      const next = (k + 1) % rims[i].length;
      points.push(rims[i - 1][k], rims[i - 1][next], p, p, rims[i - 1][next], rims[i][next]);
    });
    const shape = new THREE.BufferGeometry().setFromPoints(points);
    edge.add(new THREE.Mesh(shape, new THREE.MeshBasicMaterial({ color: 0xe67800, transparent: true, opacity: 0.08, side: THREE.DoubleSide, depthWrite: false, depthTest: false })));
    this.scene.add(outlet, edge);
    const corners = 6 * rims[0].length; // of a section
    return { outlet, edge, reach: far => shape.setDrawRange(0, corners * jet.sections_m.filter(([z]) => z > 0 && z <= far).length), axis, centre: vector(jet.centre_m) };
  }

  // Shows frame i in the colours of a quantity between the ends of a scale.
  show(i, name, [low, high], { edges, jet, through }) {
    const { header } = this.frames, f = this.frames.frame(i), position = this.skin.attributes.position.array, colour = this.skin.attributes.color.array;
    const quantity = quantities[name];
    header.triangles.forEach((t, e) => {
      const rgb = !quantity.value ? fabric : quantity.classes ? classColours[quantity.value(f, e, t)] : rampColour((quantity.value(f, e, t) - low) / (high - low));
      for (let k = 0; k < 3; ++k) for (let c = 0; c < 3; ++c) {
        position[9 * e + 3 * k + c] = f.position[3 * t[k] + c];
        colour[9 * e + 3 * k + c] = rgb[c] / 255;
      }
    });
    this.net.attributes.position.array.set(f.position);
    const tied = this.straps.geometry.attributes.position.array;
    header.straps.flat().forEach((node, k) => tied.set(f.position.subarray(3 * node, 3 * node + 3), 3 * k));
    for (const geometry of [this.skin, this.net, this.straps.geometry]) geometry.attributes.position.needsUpdate = true;
    this.skin.attributes.color.needsUpdate = true;
    this.edges.visible = edges;
    Object.assign(this.material, { transparent: through, depthWrite: !through, opacity: through ? 0.45 : 1 });
    this.jets.forEach((part, k) => {
      part.outlet.visible = jet;
      part.edge.visible = jet && f.s[`jet_${k}_m_s`] > 0;
      let far = 0;
      for (let n = 0; n < f.position.length; n += 3)
        far = Math.max(far, part.axis.x * (f.position[n] - part.centre.x) + part.axis.y * (f.position[n + 1] - part.centre.y) + part.axis.z * (f.position[n + 2] - part.centre.z));
      part.reach(far);
    });
    if (this.impactor) {
      const centre = [f.s.impactor_x_m, f.s.impactor_y_m, f.s.impactor_z_m];
      this.impactor.position.set(...centre);
      if (header.impactor) this.impactor.quaternion.set(f.s.impactor_turn_x, f.s.impactor_turn_y, f.s.impactor_turn_z, f.s.impactor_turn_w);
    }
    if (this.arm) {
      const centre = [f.s.impactor_x_m, f.s.impactor_y_m, f.s.impactor_z_m];
      this.arm.geometry.attributes.position.array.set(centre, 3);
      this.arm.geometry.attributes.position.needsUpdate = true;
    }
    this.render();
  }

  // Looks at the middle of what the bag fills, from a direction and a distance [m].
  lookFrom(direction, distance) {
    this.controls.target.copy(this.box().getCenter(new THREE.Vector3()));
    const side = vector(direction);
    if (Math.abs(side.clone().normalize().dot(this.up)) > 0.99) side.addScaledVector(new THREE.Vector3(0.02, 0.01, 0.015), 1);
    this.camera.position.copy(this.controls.target).addScaledVector(side.normalize(), distance);
    this.controls.update();
  }

  // What the bag fills over time, or a rigid target with the outlets that blow at it.
  box() {
    const box = new THREE.Box3(), { jets, rigid } = this.frames.header;
    for (const i of [0, Math.floor(this.frames.count / 2), this.frames.count - 1]) box.union(new THREE.Box3().setFromArray(this.frames.frame(i).position));
    if (rigid) for (const jet of jets) box.expandByPoint(vector(jet.centre_m));
    return box;
  }

  // Arrow keys turn by 10 degrees, but not over the poles; plus and minus change the distance by a tenth.
  key(event) {
    const [about, over, distance] = { ArrowLeft: [-1, 0, 1], ArrowRight: [1, 0, 1], ArrowUp: [0, -1, 1], ArrowDown: [0, 1, 1], "+": [0, 0, 0.9], "-": [0, 0, 1 / 0.9] }[event.key] ?? [];
    if (about === undefined || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    const away = this.camera.position.clone().sub(this.controls.target), step = Math.PI / 18;
    const pole = this.up.angleTo(away) + over * step;
    if (pole > 0.02 && pole < Math.PI - 0.02) away.applyAxisAngle(this.up.clone().cross(away).normalize(), over * step);
    away.applyAxisAngle(this.up, about * step);
    this.camera.position.copy(this.controls.target).addScaledVector(away, distance);
    this.controls.update();
  }

  resize() {
    const width = this.root.clientWidth, height = Math.round(Math.min(0.95 * width, 0.62 * innerHeight, 640));
    if (!width || (width === this.width && height === this.height)) return;
    Object.assign(this, { width, height });
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.render();
  }

  render() { this.renderer.render(this.scene, this.camera); }
}

// Scale of a quantity over all frames of all views: [low, high, largest]. Of bags the topmost 0.5 % of the values share the last colour.
const scaleOf = (views, name) => {
  const { value, classes } = quantities[name], all = [];
  if (!value || classes) return [0, 1, 1];
  for (const { frames } of views)
    for (let i = 0; i < frames.count; ++i) {
      const f = frames.frame(i);
      frames.header.triangles.forEach((t, e) => all.push(value(f, e, t)));
    }
  const sorted = Float32Array.from(all).sort(), last = sorted.length - 1, share = views.every(view => view.frames.header.rigid) ? 1 : 0.995;
  const low = sorted[0], high = sorted[Math.floor(share * last)];
  return high > low ? [low, high, sorted[last]] : [low, sorted[last] > low ? sorted[last] : low + 1, sorted[last]];
};
