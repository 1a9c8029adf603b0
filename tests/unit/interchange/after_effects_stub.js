// Stands in for After Effects: objects that remember what a script does to them, printed as JSON in the end.
// Compositions within a layer come along as its `comp`.
// Usage: node after_effects_stub.js SCRIPT.jsx [width height] - with a size, one layer of that size is selected.
"use strict";
const fs = require("fs");
const vm = require("vm");

function property(name) {
  return {
    name, keys: [], value: undefined,
    setValue(value) { this.value = value; },
    setValueAtTime(time, value) { this.keys.push({ time, value, types: null, ease: null }); },
    setValuesAtTimes(times, values) {
      if (times.length !== values.length) { throw new Error("times and values differ in number"); }
      times.forEach((time, k) => this.setValueAtTime(time, values[k]));
    },
    key(index) {
      if (!(index >= 1 && index <= this.keys.length)) { throw new Error("no key " + index); }
      return this.keys[index - 1];
    },
    setInterpolationTypeAtKey(index, before, after) { this.key(index).types = [before, after]; },
    setTemporalEaseAtKey(index, before, after) { this.key(index).ease = [before[0], after[0]]; },
  };
}

function group() {
  const properties = {};
  const made = { property: (name) => (properties[name] ||= property(name)) };
  let locked = false;
  return new Proxy(made, {
    get: (target, name) => (name === "locked" ? locked : name === "properties" ? properties : target[name]),
    set: (target, name, value) => {
      if (locked) { throw new Error("a locked mask was changed: " + String(name)); }
      if (name === "locked") { locked = value; } else { target[name] = value; }
      return true;
    },
  });
}

function layer(name, width, height, grey, comp) {
  const masks = [], transform = {};
  const way = { property(wanted) {
    if (!["ADBE Opacity", "ADBE Anchor Point", "ADBE Position", "ADBE Scale", "ADBE Rotate Z"].includes(wanted)) {
      throw new Error("unknown property " + wanted);
    }
    return (transform[wanted] ||= property(wanted));
  } };
  return {
    name, width, height, grey, comp, startTime: 0, masks, transform, enabled: true, blendingMode: "normal",
    moveBefore(other) { this.lies = "before " + other.name; },
    setTrackMatte(other, kind) { this.matte = { layer: other, kind }; },
    property(wanted) {
      if (wanted === "ADBE Transform Group") { return way; }
      if (wanted !== "ADBE Mask Parade") { throw new Error("unknown property " + wanted); }
      return { addProperty(kind) {
        if (kind !== "ADBE Mask Atom") { throw new Error("unknown property " + kind); }
        const mask = group();
        masks.push(mask);
        return mask;
      } };
    },
  };
}

class CompItem {
  constructor(name, width, height, aspect, duration, fps) {
    Object.assign(this, { name, width, height, aspect, duration, fps, selectedLayers: [], all: [] });
    Object.assign(this, { displayStartFrame: 0 });
    const put = (made) => { this.all.push(made); return made; };
    this.layers = {
      addSolid: (color, title, w, h) => put(layer(title, w, h, color[0])),
      add: (comp) => put(layer(comp.name, comp.width, comp.height, 0, comp)),
    };
  }
  openInViewer() {}
}

const [script, width, height] = process.argv.slice(2);
const project = { activeItem: null, comps: [] };
project.items = { addComp: (...values) => {
  const comp = new CompItem(...values);
  project.comps.push(comp);
  return comp;
} };
if (width) {
  project.activeItem = project.items.addComp("Shot", Number(width), Number(height), 1, 10, 24);
  const plate = layer("plate", Number(width), Number(height));
  plate.startTime = 2;
  project.activeItem.all.push(plate);
  project.activeItem.selectedLayers.push(plate);
}
const world = {
  app: { project, beginUndoGroup() {}, endUndoGroup() {} },
  CompItem,
  Shape: class Shape {},
  KeyframeEase: class KeyframeEase { constructor(speed, influence) { Object.assign(this, { speed, influence }); } },
  KeyframeInterpolationType: { LINEAR: "linear", HOLD: "hold", BEZIER: "bezier" },
  MaskMode: { NONE: "none", ADD: "add", SUBTRACT: "subtract", INTERSECT: "intersect", DIFFERENCE: "difference",
              LIGHTEN: "lighten" },
  BlendingMode: { NORMAL: "normal", SCREEN: "screen", DIFFERENCE: "difference", LIGHTEN: "lighten", ADD: "add",
                  MULTIPLY: "multiply" },
  TrackMatteType: { LUMA: "luma" },
  MaskMotionBlur: { ON: "on", OFF: "off" },
  MaskFeatherFalloff: { FFO_LINEAR: "linear" },
};
const text = fs.readFileSync(script, "latin1");
if (/[^\x00-\x7f]/.test(text)) { throw new Error("the script is not ASCII"); }
vm.runInNewContext(text, world, { timeout: 20000 });
const comp = project.activeItem || project.comps[0];
function told(made) {
  const masks = made.masks.map((mask) => ({
    name: mask.name, mode: mask.maskMode, inverted: mask.inverted, color: mask.color, blur: mask.maskMotionBlur,
    falloff: mask.maskFeatherFalloff, locked: mask.locked, properties: mask.properties,
  }));
  const { name, width, height, grey, blendingMode, transform, enabled, startTime } = made;
  const matte = made.matte && { ...told(made.matte.layer), kind: made.matte.kind, parent: made.matte.layer.parent.name };
  const comp = made.comp && { ...about(made.comp), layers: made.comp.all.map(told) };
  return { name, width, height, grey, blendingMode, transform, enabled, startTime, masks, matte, comp };
}

function about(comp) {
  const { name, width, height, aspect, duration, fps, displayStartFrame, motionBlur } = comp;
  return { name, width, height, aspect, duration, fps, displayStartFrame, motionBlur };
}

const first = comp.all[0];
console.log(JSON.stringify({
  comp: about(comp), layer: { name: first.name, width: first.width }, masks: told(first).masks, scene: told(first),
}));
