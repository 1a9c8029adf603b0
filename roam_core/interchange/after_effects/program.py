"""The script for After Effects around its values: it builds masks, and compositions where layers join."""

PROGRAM = """\
// Masks from ROAM. In After Effects: File > Scripts > Run Script File.
// With one layer selected the masks go onto it, scaled to its size; otherwise onto a new solid. Where layers of shapes
// have modes of their own, compositions join them, and the layer gets the outcome as its luma matte.
(function () {
  var clip = @CLIP@;
  var parts = @PARTS@;
  var begin = clip.offset / clip.fps;  // seconds from the start of a layer that is there to the plate's first frame

  function created(name) {
    var seconds = clip.length / clip.fps;
    var comp = app.project.items.addComp(name, clip.width, clip.height, clip.aspect, seconds, clip.fps);
    if (comp.displayStartFrame !== undefined) { comp.displayStartFrame = clip.first; }
    else { comp.displayStartTime = clip.first / clip.fps; }
    comp.motionBlur = clip.blurred;
    return comp;
  }

  function composition() {
    var item = app.project.activeItem;
    if (item && item instanceof CompItem) { return item; }
    begin = 0;  // a new composition bears the numbers instead
    item = created("ROAM");
    item.openInViewer();
    return item;
  }

  function solid(comp, name, grey) {
    return comp.layers.addSolid([grey, grey, grey], name, clip.width, clip.height, clip.aspect, comp.duration);
  }

  function target(comp) {
    var picked = comp.selectedLayers;
    if (picked.length === 1 && picked[0].property("ADBE Mask Parade")) { return picked[0]; }
    return solid(comp, "ROAM", 1);
  }

  function scaled(pairs, x, y) {
    var result = [];
    for (var i = 0; i < pairs.length; i++) { result.push([pairs[i][0] * x, pairs[i][1] * y]); }
    return result;
  }

  function outline(key, closed, x, y) {
    var shape = new Shape(), count = key.v.length, mean = Math.sqrt(x * y);
    shape.vertices = scaled(key.v, x, y);
    shape.inTangents = scaled(key.i, x, y);
    shape.outTangents = scaled(key.o, x, y);
    shape.closed = closed;
    if (key.r) {
      var segments = [], places = [], radii = [], types = [], zeros = [];
      for (var i = 0; i < count; i++) {
        var isLast = !closed && i === count - 1 && count > 1;
        segments.push(isLast ? i - 1 : i);
        places.push(isLast ? 1 : 0);
        radii.push(key.r[i] * mean);
        types.push(key.r[i] < 0 ? 1 : 0);
        zeros.push(0);
      }
      shape.featherSegLocs = segments;
      shape.featherRelSegLocs = places;
      shape.featherRadii = radii;
      shape.featherTypes = types;
      shape.featherInterps = zeros;
      shape.featherTensions = zeros;
      shape.featherRelCornerAngles = zeros;
    }
    return shape;
  }

  function moves(path, keys) {
    var kinds = {
      "linear": KeyframeInterpolationType.LINEAR,
      "hold": KeyframeInterpolationType.HOLD,
      "smooth": KeyframeInterpolationType.BEZIER
    };
    for (var i = 0; i < keys.length; i++) {
      var before = i === 0 ? "linear" : keys[i - 1].t;
      if (before === "hold") { before = "linear"; }
      if (before === "smooth" || keys[i].t === "smooth") {
        var ease = [new KeyframeEase(0, 100 / 3)];
        path.setTemporalEaseAtKey(i + 1, ease, ease);
      }
      path.setInterpolationTypeAtKey(i + 1, kinds[before], kinds[keys[i].t]);
    }
  }

  // A value, or a list of [frame, value, whether it holds]; `shown` makes of a number what the property takes.
  function keyed(property, value, start, shown) {
    if (!(value instanceof Array)) { property.setValue(shown(value)); return; }
    var linear = KeyframeInterpolationType.LINEAR, hold = KeyframeInterpolationType.HOLD, i;
    for (i = 0; i < value.length; i++) {
      property.setValueAtTime(start + value[i][0] / clip.fps, shown(value[i][1]));
    }
    for (i = 0; i < value.length; i++) {
      property.setInterpolationTypeAtKey(i + 1, linear, value[i][2] ? hold : linear);
    }
  }

  function plain(number) { return number; }

  // `start` is the moment of the plate's first frame.
  function add(layer, data, start) {
    var x = layer.width / clip.width, y = layer.height / clip.height, times = [], shapes = [];
    var mask = layer.property("ADBE Mask Parade").addProperty("ADBE Mask Atom");
    try { mask.name = data.name; } catch (error) { mask.name = data.name.substring(0, 31); }
    var path = mask.property("ADBE Mask Shape");
    for (var i = 0; i < data.keys.length; i++) {
      times.push(start + data.keys[i].f / clip.fps);
      shapes.push(outline(data.keys[i], data.closed, x, y));
    }
    path.setValuesAtTimes(times, shapes);
    moves(path, data.keys);
    mask.maskMode = MaskMode[data.mode];
    mask.inverted = data.inverted;
    mask.color = data.color;
    mask.maskMotionBlur = data.blurred ? MaskMotionBlur.ON : MaskMotionBlur.OFF;
    keyed(mask.property("ADBE Mask Feather"), data.feather, start, function (width) {
      return [width * x, width * y];
    });
    keyed(mask.property("ADBE Mask Offset"), data.expansion, start, function (width) {
      return width * Math.sqrt(x * y);
    });
    keyed(mask.property("ADBE Mask Opacity"), data.opacity, start, plain);
    if (typeof MaskFeatherFalloff !== "undefined") { mask.maskFeatherFalloff = MaskFeatherFalloff.FFO_LINEAR; }
    mask.locked = data.locked;
  }

  // White on black: every layer is joined by its blending mode with what lies under it.
  function joined(name, parts) {
    var comp = created(name), layer, k, m;
    solid(comp, "Nothing", 0);
    for (k = 0; k < parts.length; k++) {
      if (parts[k].parts) {
        layer = comp.layers.add(joined(parts[k].name, parts[k].parts));
        layer.name = parts[k].name;
      } else {
        layer = solid(comp, parts[k].name, parts[k].grey);
        for (m = 0; m < parts[k].masks.length; m++) { add(layer, parts[k].masks[m], 0); }
      }
      layer.blendingMode = BlendingMode[parts[k].blend];
      keyed(layer.property("ADBE Transform Group").property("ADBE Opacity"), parts[k].opacity, 0, plain);
    }
    return comp;
  }

  function matted(comp, layer, matte) {
    var placed = comp.layers.add(matte), way = placed.property("ADBE Transform Group");
    placed.startTime = layer.startTime + begin;
    placed.parent = layer;
    way.property("ADBE Anchor Point").setValue([0, 0]);
    way.property("ADBE Position").setValue([0, 0]);
    way.property("ADBE Scale").setValue([100 * layer.width / clip.width, 100 * layer.height / clip.height]);
    way.property("ADBE Rotate Z").setValue(0);
    placed.moveBefore(layer);
    if (layer.setTrackMatte) { layer.setTrackMatte(placed, TrackMatteType.LUMA); }
    else { layer.trackMatteType = TrackMatteType.LUMA; }
    placed.enabled = false;
  }

  app.beginUndoGroup("Masks from ROAM");
  var comp = composition(), layer = target(comp);
  if (parts.length === 1 && parts[0].isFlat) {
    for (var k = 0; k < parts[0].masks.length; k++) { add(layer, parts[0].masks[k], layer.startTime + begin); }
  } else { matted(comp, layer, joined("ROAM matte", parts)); }
  app.endUndoGroup();
})();
"""
