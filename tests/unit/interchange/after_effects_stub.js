// Stands in for After Effects: objects that remember what a script does to them, printed as JSON in the end.
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

function layer(name, width, height) {
  const masks = [];
  return {
    name, width, height, startTime: 0, masks,
    property(wanted) {
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
    this.layers = { addSolid: (color, title, w, h) => {
      const solid = layer(title, w, h);
      this.all.push(solid);
      return solid;
    } };
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
  MaskMotionBlur: { ON: "on", OFF: "off" },
  MaskFeatherFalloff: { FFO_LINEAR: "linear" },
};
const text = fs.readFileSync(script, "latin1");
if (/[^\x00-\x7f]/.test(text)) { throw new Error("the script is not ASCII"); }
vm.runInNewContext(text, world, { timeout: 20000 });
const comp = project.activeItem || project.comps[0];
const masks = comp.all[0].masks.map((mask) => ({
  name: mask.name, mode: mask.maskMode, inverted: mask.inverted, color: mask.color, blur: mask.maskMotionBlur,
  falloff: mask.maskFeatherFalloff, locked: mask.locked, properties: mask.properties,
}));
const { name, all, selectedLayers, layers, ...about } = comp;
console.log(JSON.stringify({ comp: about, layer: { name: all[0].name, width: all[0].width }, masks }));
