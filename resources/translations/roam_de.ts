<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name></name>
    <message>
        <source>  (on)</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source> %n of its {count} vertices is/are doubtful and ringed.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source> (ripple)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Bridged without a picture: {bridged}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> GB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Its plate was found at {path}; save to keep that.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> MB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and </source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source> in %n shape(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source> or </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> px²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> since the last save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> {shapes} edited meanwhile: left as they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n doubtful frame(s): N goes to the next one.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n edit(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) is/are missing.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n proposal(s) to answer: Alt+P goes there.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n shape(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tracked frame(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>1 frame, {each:.0f} ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>100 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; what came after them is damaged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A closed shape needs at least {min_points_closed} points; click to place more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A copy of {name}; save to keep it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A folder; its pictures are {first} and so on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A key of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A key on each so many frames; 0: at both ends of the range alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A short shot to try everything on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About ROAM</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About ROAM…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About the middle of what is selected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add an empty layer, to drop shapes on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adjust key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adjust key on frame {frame}: what it changes is spread to the adjust keys beside it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adjust key on frame {here}: the track is right here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adjust track</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All settings as they were at first; keys stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All shapes together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alpha alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt+arrows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Always</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An edit changes all keys of the in/out range alike</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An error inside ROAM ended the work: {error}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another version of the plate below the same shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Around the shapes only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As few as hold the outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As many as there are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As stacked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As stacked from here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attach to neighbours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auto-key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B-spline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>BSD 3-Clause licence, copyright the ROAM developers. The libraries beneath it:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back and forth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin again at the end of the range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin and end softly after the chosen keys or this one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Behind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Behind from here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Besides:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bezier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Box or click an object: a shape is fitted to it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Box the object or click on it; before that, Shift+click marks more of it and Ctrl+click what is not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Break a tangent; from an anchor: pull its handles out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brightness alone, and back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By outlines again: shapes that overlap are parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change keys…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the reach of soft selection, of the brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channels of one file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cineon log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear in and out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click along an edge: the line clings to it, straight with Ctrl. Return or the first point closes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click control points around the object. Return or the first point closes, Esc leaves it open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click for a corner, drag for a curve. Return or the first point closes, Esc leaves it open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click for each corner. Return or the first point closes, Esc leaves it open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click here, then press the new key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click one, two or four marks, then &lt;planar.forward&gt;; Ctrl and the wheel size their areas.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click or box the object to find it, Return finds what is marked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close a shape being drawn, leave it open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare what is shown now with what will be: drag the line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare with what is shown now, in place of what was pinned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Confidence is {confidence:.2f} at least.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copied the key of frame {frame}: paste puts it on another frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copied {shapes} for {program}; paste there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copied {shapes}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy for Fusion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy for Nuke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the selected shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the selected shapes as they are on this frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copying for {program} …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Alt+click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Alt+click on an outline inserts a point there; a drag is a lasso.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Alt+drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curves carried through a shot</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Cusp %n point(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Cusp points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut the selected shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut-out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cuts a hole into what lies under it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Delete %n point(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n shape(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Delete every tracked frame; artist keys stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the keys of the selected shapes on this frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the selected points or shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the selected shapes and layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete tracked frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dials that were turned and are not offered (any more) stay at 100 %: {names}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dissolve the layer; its shapes stay as they are seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do anything by a few letters of its name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not offer again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do what?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a free line about points, not a rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag around the object; end near the start to close the shape. Zoom in for a finer fit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag from corner to corner of the ellipse. Shift: a circle. Ctrl: from its centre.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag from corner to corner of the rectangle. Shift: a square. Ctrl: from its centre.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag out of a point of the selected shape to soften its edge; double-click a feather point to take it back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag the corners to where they belong on this frame, or the inside to move all; Return says: right here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to change; Shift: faster, Ctrl: finer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to pull the points under the brush. Ctrl+wheel or Ctrl+drag changes its size, a pen&apos;s pressure too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a Bezier shape: click corners, drag curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a line that clings to the edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a polygon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a shape first: press &lt;tool.bezier&gt; in the viewer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a smooth shape by its control points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw by hand; few points are fitted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop the part that came off {name}?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EXR files only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edits make keys on their frames; off: they change keys around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Equalise the handles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export mattes to a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export mattes…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export selected shapes…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export stopped; the files that are finished stay.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export to Nuke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export to Nuke…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export, although the mattes would differ in the other program?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export: {title}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported to {path}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exporting to {name} …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feather</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feather and shutter as the plate shows them, on all keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feather for all keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feather handle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files of their own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill between keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filled already: nothing that it depends on has changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filled the frames {first} to {last}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filled {count} gaps between frames {first} and {last}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filling frames {first} to {last}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filling stopped after the gap up to frame {frame}; the finished frames stay.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filling stopped before a gap was finished.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find an action…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finding the object …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit shapes to a folder of mask pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit shapes to a picture of this frame&apos;s mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Float</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fold or unfold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow the surface in the shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow the surface in the shapes back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Followed {what} to frame {last}: {done} frames. {verdict}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For decoding pictures and for the engine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget all keys of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Four points are enough: drag one of them, or take one back with Backspace.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame {frame}: the confidence of the track {name} is {trust:.2f}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame {frame}: the confidence of {name} is {confidence:.2f}.{rings}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free edges, which the picture shows, solid; seams of an object dashed; what a nearer part hides dotted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freehand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From mask image…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the next start on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From this frame on the others hide the shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From this frame on the shapes hide the others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From this frame on what hides what goes by the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the key to this action; the other one goes without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the selected B-splines handles; no outline changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the selected shapes control points: smooth everywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the soft edge as it is here to every key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the timeline half of the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give this action the keys of the preset again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go one key, or change of depth, of the shapes in hand back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go one key, or change of depth, of the shapes in hand on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the frame that the engine trusts least</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the next frame on which the engine proposes a change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the next frame worth fixing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Green</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group into a layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half float</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide the shapes while you look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the copied key through a range of frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holding Alt while dropping a clip opens it without a question</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hole of {name}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far a curve may stray from its mask&apos;s outline on any frame, in pixels of the masks; of masks that tremble, a fifth of the outline may stray farther</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the outline may stray from the tracked one when keys are left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far tracked keys may move so that shapes move evenly through time, in pixels of the plate;
your own keys stay where they are, and so does the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the engine works</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If both save, the later one wins. A copy is a project of its own, without a file until you save it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If you save anyway, what is in the file now stays beside it as a backup.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import masks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import masks…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import shapes…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import the masks of a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In front from here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the viewer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In to out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert a point on the outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inside the box moves, handles scale, sides shear, outside a corner turns; Shift and Ctrl vary it. Esc ends.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Intersect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It joins soft edges as older versions did (Plus), so that its mattes stay as they were; choose Add in the Shape panel where they are to join as in other programs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It stays, and is found under File &gt; Recover work…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joins with what lies under it, soft edges as one painted over the other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the keys that the action has, and add the new one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps only what both cover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps what one of both covers and the other does not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kept: it is yours now. {key} tracks on from here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys of other programs, and keys of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lasso selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the shape as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave this action without a key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let parts hang by joints on those that they overlap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let parts move free of those that they overlap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock or unlock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at frame {frame}: confidence is {confidence:.2f} there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at frame {frame}: the planar track&apos;s confidence is {confidence:.2f} there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking at the plate&apos;s edge …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking at {name} …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for what the format cannot hold …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luminance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnetic lasso</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make B-spline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make Bezier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the change that the engine proposes here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the selected shapes, as they are here, artist keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make this change, and every one proposed for this shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark this frame, or take its mark away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mask pictures (*.png *.tif *.tiff *.jpg *.jpeg *.exr);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Match the plate&apos;s edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Matte</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mattes of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Max</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory for frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory for undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Menu</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle button, Alt+left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror horizontally</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror vertically</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mode at the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More keeps more of a clip ready to play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Most doubtful frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move handle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move on evenly from the chosen keys, or from this one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move x, y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move {count} points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move {count} shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move {dx:+.1f}, {dy:+.1f} px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move, turn, scale and shear by numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move, turn, scale and shear points or shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Movies (*.mov *.mp4 *.avi *.mkv *.m4v *.mxf *.webm *.mpg *.mpeg *.gif);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>My keys only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name mark…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Neither {folder} nor a temporary folder can be written to: {error}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Never</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next doubtful frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next proposal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No doubtful frame after frame {frame}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No doubtful frame before frame {frame}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No frame is tracked yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No point lies under the brush; Ctrl and the wheel make it wider.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No proposal waits for an answer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No shape is in sight here that could be selected; show or unlock some.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No shape is selected; select some, or export all.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is called so; try another word, or fewer letters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is sent. Copy it into an issue if you like.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is white in {name}; paint the object white and the rest black.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was copied.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was exported; the files that are there stay.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Nudge %n point(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Nudge points by a pixel, with Shift by ten</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Occluder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Older versions of a project, kept beside it when you save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On empty background: add points to the selection, take them away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One on every frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Onion skin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only a closed shape that is not locked has an edge to match; unlock or close one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a clip first: a mask belongs to one of its frames.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a clip first: drop a folder of images or a movie on the window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a clip first: shapes come into its frames and pixels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open anyway</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open clip: the folder of its frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open clips without asking from now on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open clip…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open movie</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open movie…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open or close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open or close shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open: not tracked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opened lately</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opened {name}.{moved}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opened {name}: {count} frames. {gaps}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening {name} …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Or drop a folder of images, a movie or a project anywhere in this window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Packing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of {count}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts and holes that are never larger are left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste key to range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste key to range…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste the copied shapes, also those copied in Nuke or Fusion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pattern {pattern:.0f} px, search {search:.0f} px.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Per second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pin as A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pin the corners of a tracked surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pixel aspect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Planar track</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Planar track backward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Planar track forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play backward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play backward at half speed; again: slower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play backward slowly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play backward; again: faster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play forward at half speed; again: slower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play forward; again: faster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play slowly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point track</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points near the selected ones follow them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous doubtful frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problem report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problem report…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Proposal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Propose changes for the selected shapes again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pull out handles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pull the points under a soft, round brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put a word on this frame&apos;s mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put into</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put points that a track follows, with the shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the copied key on this frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the feather of the selected points back on the outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ROAM did not close properly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ROAM did not make what is there in {folder}. It would be lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ROAM projects (*.roam)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read {shapes} from {name}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading {name} …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover work…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recovered; save to keep it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recovering …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Red</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redone: {text}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refuse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refuse, and propose nothing more for this shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relink clip: a frame of the plate, or a movie</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relink clip…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaces the file that is there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset feather</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reshape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Return, Esc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ripple edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate {degrees:+.1f}°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotoscoping with a Rich Online Appearance Model: editable curves carried through a shot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save anyway</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes to {name}?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved {name}. {warning}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Say where to write it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale x, y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale {x:.1f} %, {y:.1f} %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scene linear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search for an action or a key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a layer first: click it in the list of shapes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a shape first: click it in the viewer or in the list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a shape first: its key on this frame is copied.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a shape or points to transform: click an outline or drag a marquee.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a shape or some of its points first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a shape or some of its points first; locked and hidden ones stay as they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a shape whose plane is tracked (&lt;planar.forward&gt;), then pin its corners here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select all points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select all shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select an action first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select an action to give it another key.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select and drag shapes, points and handles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select points with a lasso</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select the shape to paste to; it may be neither locked nor hidden.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select the shapes first that you want to be asked about again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select the shapes in sight that are not locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selected shapes only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape from mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape from the mask of this frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shapes ({kinds})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shapes for other programs, and mattes: every format, keys and frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shapes of Nuke, Silhouette and others; or drop the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shear x, y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shear {percent:+.1f} %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift+click, Ctrl+click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift+drag, Ctrl+drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all that the Shape panel has of the selected shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show every key, and find one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show every step and go back to any</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide the panels on the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the plate as it is: all channels, neutral</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole clip in the timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what was found before a clip opens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what was said, and when</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size on the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skip frames whose files are there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Smooth %n point(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Smooth points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Soft selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Soften the edge: pull the feather out of points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solve as one object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solve as parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solve by itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Span a rectangle; Shift makes it a square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Span an ellipse; Shift makes it a circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Specks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split {name} into {count} shapes?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stand still after the chosen keys, or this one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starting the planar track …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starting to fill {names} …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starting to track {names} …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop; the frames that are finished stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped; no edge was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Subtract</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swap left and right of what is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swap top and bottom of what is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take it over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take off this list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tall timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ten frames back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ten frames on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blue channel alone, and back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The clip begins here: there is no frame to track to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The clip ends here: there is no frame to track to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The demo shot cannot be written to {folder}: {reason}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The demo shot: press &lt;track.forward&gt; to track the shape, &lt;track.stop&gt; to stop; drag its points to correct it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The drag was dropped: its shape or the frame changed meanwhile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first frame to export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder {wanted} cannot be written to: settings and the journal of edits are kept in {used} for now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The format holds all that is chosen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The greater of both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The green channel alone, and back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The journal builds on {name} as it was, and that file has changed or gone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The journal is damaged: its last edits could not be put together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The journal is damaged: what came after its last sound entry is lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The journal {journal} has no beginning; nothing of it can be recovered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last frame to export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The matte of all visible shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The matte without its outlines, and back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mattes would differ in the other program:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The next frame is a key already: there is nothing to track before it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The oldest steps go first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The one used last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outlines of frames before and after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The planar track stopped at frame {frame}; the finished frames stay.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The planar track stopped before a frame was finished; the finished frames stay.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plate alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plate could not be opened; choose it again in the File menu. {error}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plate inside of the matte, on a ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plate is {name} now; save to keep that.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plate with its shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The points lie on one line, or on one another: put them apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project is being saved …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The red channel alone, and back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selected shapes alone, in any format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selected shapes are {kind} already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selected shapes, or all, as a node to paste into a script</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selected shapes, or all, as nodes to paste into a flow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shape stands still there: other keys in the range give way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The soft edge goes over to your next keys, through the tracked frames between; &lt;feather.all_keys&gt; gives it to all.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sum of both, as projects of earlier versions added: soft edges that overlap grow hard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no frame to track backward to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no frame to track forward to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no frame to track to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no gap to fill here: set a key (&lt;key.set&gt;) on two frames, with others between them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no key after this frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no key before this frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no key to paste; copy one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no keymap {name!r}; choose one that lies in resources/keymaps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no picture of this frame to find edges in (yet).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no picture of this frame to look at (yet).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no plate to track in; open a clip first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no shape here that can be reshaped; draw one, or unlock and show it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no shape to copy for {programs}; draw one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no shape to paste; copy one first, here or in another program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to export yet; open a clip first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to recover.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They are lost if you do not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Track</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Track backward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Track each of the selected shapes with no other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Track forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Track one frame backward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Track one frame forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Track points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Track the frames between two keys from both at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Track the selected shapes as one whole object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Track to the next key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tracked {names} to frame {frame}: {paced}.{gaps}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tracking stopped at frame {frame}; the finished frames stay.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tracking stopped before a frame was finished.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tracking {names} backward: {place} · {pace}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tracking {names} forward: {place} · {pace}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transform</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transform by numbers…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn at both ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undone: {text}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Versions, system and messages, to copy into an issue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What crashes left, and what was thrown away, session by session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is selected is locked; unlock it first (&lt;shape.lock&gt;).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where parts hang together, on frames with keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the engine trusts the outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole of {count} shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the object tool: mark more of the object, mark what is not it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Work that is in no file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write over</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Write over {name} and %n other file(s)?</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Write over {name}?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You will be asked about {names} again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your own files are not changed until you save. What you leave here stays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>accept yes topology</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>again repeat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>alone single isolate unlink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>alpha mask black white</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as stacked again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at both ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>autokey keyframe record stopwatch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>begin start rewind home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>behind the others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>below </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bookmark marker flag note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bookmark marker jump</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bookmark marker label note comment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bounce back and forth loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>brightness grey luma channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bug crash error issue trace support</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cancel abort interrupt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>channel rgb</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>circle oval round draw roto mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clear track reset remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clipboard davinci resolve setting mask node export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clipboard insert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clipboard move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clipboard roto node script export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>color rgb all channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>commands search find</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>composite comp cutout transparent background checkerboard colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>confidence worst error fix bad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>confidence wrong error fix bad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>convert tangents handles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>convert xspline smooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>copy clone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>corner linear sharp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crash autosave backup journal lost restore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cyclic finish open spline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>depth order occlusion over above z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>depth order occlusion reset z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>depth order occlusion under below hidden z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dissolve unparent folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dopesheet keys height bigger large half</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>empty begin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>everything splines layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>example sample tutorial manta</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exit close leave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flip flop horizontal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flip vertical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>folder group create</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>folder layer parent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frame {frame} of {last}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>freehand marquee</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gain gamma viewer neutral default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>handles shape the curve now, and no outline changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>import footage mov mp4 quicktime read load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>import footage plate read sequence images source load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in front of the others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>intelligent scissors edge snap draw roto mask path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>interpolate inbetween tween both directions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>interpolation easing ease</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>interpolation easing ease bezier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>interpolation easing ease step constant freeze</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its curve is smooth everywhere now, and its points moved by up to {moved:.1f} pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>joint free unpin unparent rig</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>joint pin hinge parent rig</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jump skip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keyframe hold many frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keyframe insert add autokey</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keyframe jump</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keyframe pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keyframe remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>linear straight draw roto mask path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>link join group glue whole together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>load script scene session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>magic wand quick selection rotobrush ai auto sam box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mask black white channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mattes alpha segmentation load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>messages errors console</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mixed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>motion tracker stabilise stabilize corner pin perspective mocha plane surface homography</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move rotate turn scale resize skew shear box jack gizmo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not installed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nuke silhouette fusion blender mocha after effects svg render write output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nuke silhouette fusion svg roto load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>numeric move rotate scale type exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>onionskin ghost light table frames before after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only some shapes write output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pen spline draw roto mask path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pencil sketch lasso draw roto mask path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pick arrow move edit transform deselect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>planar track corner pin surface drift fix mocha keyframe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plate footage rgb image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point mark begin work area range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point mark end work area range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point tracker tracking one two four corners pattern search area follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>preferences options configuration memory cache threads scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>propagate rotobrush follow solve motion tracker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>propagate rotobrush follow solve play motion tracker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>propagate step motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>propagate until</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>properties attributes parameters motion blur shutter opacity transparency blend mode add subtract hole intersect difference invert colour color lifetime feather rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>properties sidebar column interface toggle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>proportional falloff magnet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>protect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recovered work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reject no topology</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>remove erase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>remove erase vertex vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>render alpha png exr tiff masks write output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeat cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>replace plate version footage path missing moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reset work area remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reverse rewind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>revert back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rig skeleton hinges bones pins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>roto node script write output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>seam free contrast boundary outline kinds dashed dotted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>see its package</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shapes splines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shortcuts hotkeys keyboard bindings remap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shortcuts hotkeys keyboard help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slow half speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slow reverse half speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>snapshot store buffer compare reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>soft edge blur every frame copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>soft edge blur falloff</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>soft edge remove clear hard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>soften feather softness blurred focus defocus shutter width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>splines outlines invisible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>square box quad draw roto mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>start run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>start stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step back arrow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step on arrow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stop halt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tangents curve handles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the clipboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the whole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>through time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>topology split suggestion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>topology suggestion reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trace vectorise matte image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trust doubt heat quality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>uberkey multi-frame multiframe all keys offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>undo list steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unhide reveal visibility eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unlink limbs articulated overlap rig</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>untitled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>version copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>version licence credits libraries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertex cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>visibility invisible eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>warp push pull liquify sculpt brush magnet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wipe compare split screen ab buffer before after snapshot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write store keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>xspline x-spline spline smooth draw roto mask path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zoom focus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zoom pixels one to one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zoom timeline dopesheet whole all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zoom whole frame all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{action} cannot be done at the moment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} frames, from {first} to {last}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} of {all} gap(s) could not be filled: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} shapes are fitted: drag the points to adjust, ] tracks forward.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} shapes changed. {sentences}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} shapes lie {where} from frame {frame} on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{done} frames, {each:.0f} ms each</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>{edit}: %n key(s) changed.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>{first}, a single picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{first}–{last}, {count} frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{journal} cannot be marked: {reason}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{journal} cannot be read: {reason}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{keys} is the key of “{action}”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{keys} moves the selected points; choose another key.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name!r} is a B-spline, which is smooth everywhere; make it Bezier for corners.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name!r} is locked or hidden; unlock and show it to edit it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} is drawn: drag its points to adjust it, ] tracks it forward.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} is drawn: drag its points to adjust it, it is open, C closes it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} is fitted: drag the points to adjust, ] tracks forward.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} is locked; unlock it to track it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} is not saved yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} is open; close it (&lt;points.toggle_closed&gt; in the viewer) to track it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} is open; close it (&lt;points.toggle_closed&gt; in the viewer) to track its plane.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} is {who}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} lies {where} from frame {frame} on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} was changed by another program since it was opened or saved here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} was not opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{pace:.0f} ms a frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} is damaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} is no keymap; set your keys again in Edit &gt; Keys.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{space} (found)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{what}  The energy falls by {figures}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{width:.0f} × {height:.0f} pixels. Shift: equal sides. Ctrl: from the centre.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“{action}” in the menu</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“{action}” is {keys} now.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
