"""The strokes of fettle_bench in Blender 3.4's dynamic topology; peers.py runs it, inside Blender, with a window (sculpting
needs a 3D view: under Xvfb it may be one that nobody sees):

    blender --factory-startup --python blender_strokes.py -- SUBDIVISIONS RADIUS DETAIL DABS OUT.json

Pull dabs with a peak of 0.02 radii on a great circle of an icosphere of radius 1, 0.126 radii apart. No dab is longer or
shorter than Fettle's, edges are refined to the same length. What is timed is the operator alone: no redraw and no upload
happens inside, undo does. A stroke has a cost of its own, that of strokes of one dab; it is told apart:
    ms a dab = (stroke of DABS - stroke of one) / (DABS - 1)
"""

import json
import math
import os
import sys
import time

import bpy
import mathutils.kdtree

SPACING = 0.126  # in radii
PEAK = 0.02  # in radii: Blender's strength counts squared
SINGLE_DABS = 5


def circle_point(radius, i, tilt=0.0):
    angle = SPACING * radius * i
    return math.cos(angle), math.sin(angle) * math.cos(tilt), math.sin(angle) * math.sin(tilt)


def prepare(subdivisions, radius, detail):
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=subdivisions, radius=1)
    bpy.ops.object.mode_set(mode="SCULPT")
    bpy.ops.sculpt.dynamic_topology_toggle()
    settings = bpy.context.scene.tool_settings
    settings.sculpt.detail_type_method = "CONSTANT"
    settings.sculpt.detail_refine_method = "SUBDIVIDE_COLLAPSE"
    settings.sculpt.constant_detail_resolution = 1 / (math.sqrt(0.05) * radius * detail)
    settings.unified_paint_settings.use_unified_size = True
    settings.unified_paint_settings.use_unified_strength = False
    settings.unified_paint_settings.use_locked_size = "SCENE"
    settings.unified_paint_settings.unprojected_radius = radius
    brush = settings.sculpt.brush
    brush.strength = math.sqrt(PEAK)
    brush.curve_preset = "SMOOTH"
    brush.stroke_method = "DOTS"
    brush.auto_smooth_factor = 0
    brush.use_accumulate = True
    brush.use_pressure_strength = False
    brush.use_space_attenuation = False
    return bpy.context.object


def timed_stroke(points, middle):
    """Milliseconds on the wall, and of all of Blender's threads."""
    stroke = [
        {"name": "", "is_start": i == 0, "location": point, "mouse": middle, "mouse_event": middle, "pressure": 1,
         "size": 50, "pen_flip": False, "time": 0, "x_tilt": 0, "y_tilt": 0}
        for i, point in enumerate(points)
    ]
    wall, cpu = time.perf_counter(), time.process_time()
    result = bpy.ops.sculpt.brush_stroke("EXEC_DEFAULT", stroke=stroke)
    cost = 1e3 * (time.perf_counter() - wall), 1e3 * (time.process_time() - cpu)
    assert result == {"FINISHED"}, result
    return cost


def touched_vertices(thing, points, radius):
    """Those in the ball of a dab, as the mesh is at the end, the median of some; and the farthest from the middle."""
    bpy.ops.object.mode_set(mode="OBJECT")
    tree = mathutils.kdtree.KDTree(len(thing.data.vertices))
    highest = 0.0
    for vertex in thing.data.vertices:
        tree.insert(vertex.co, vertex.index)
        highest = max(highest, vertex.co.length)
    tree.balance()
    counts = sorted(len(tree.find_range(point, radius)) for point in points[:: max(1, len(points) // 10)])
    return counts[len(counts) // 2], highest


def main(subdivisions, radius, detail, dabs, out):
    window = bpy.context.window_manager.windows[0]
    area = next(a for a in window.screen.areas if a.type == "VIEW_3D")
    region = next(r for r in area.regions if r.type == "WINDOW")
    middle = (region.width / 2, region.height / 2)  # a stroke starts only if the mouse is over the model
    with bpy.context.temp_override(window=window, area=area, region=region):
        thing = prepare(subdivisions, radius, detail)
        singles = [timed_stroke([circle_point(radius, 40 * i + 20, tilt=1.2)], middle) for i in range(SINGLE_DABS)]
        points = [circle_point(radius, i) for i in range(dabs)]
        stroke = timed_stroke(points, middle)
        touched, highest = touched_vertices(thing, points, radius)
    assert highest > 1 + PEAK * radius, "the strokes moved nothing"
    single = [min(column) for column in zip(*singles)]
    each = [(long - short) / (dabs - 1) for long, short in zip(stroke, single)]
    with open(out, "w", encoding="utf-8") as file:
        json.dump({"wall_ms": each[0], "cpu_ms": each[1], "stroke_ms": single[0] - each[0], "touched": touched,
                   "vertices": len(thing.data.vertices), "version": bpy.app.version_string}, file)


if __name__ == "__main__":
    given = sys.argv[sys.argv.index("--") + 1:]
    status = 1
    try:
        main(int(given[0]), float(given[1]), float(given[2]), int(given[3]), given[4])
        status = 0
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)  # Blender would stay, with its window
