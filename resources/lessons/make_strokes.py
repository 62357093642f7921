#!/usr/bin/env python3
"""Writes the stroke files of Fettle's own lessons beside each lesson.json: the teacher's hand, made of a few gestures. Millimetres, y up."""
import json
import math
import os

DAB = 0.08  # s between the dabs of a hand that rests
SPEED = 60  # mm/s of a hand that moves
TURN = 60  # degrees a second of the turntable


class Hand:
    """Strokes in the order in which they are made."""

    def __init__(self, **settings):
        self.settings = settings
        self.strokes = []

    def stroke(self, tool, radius, samples, **settings):
        self.strokes.append({"tool": tool, "radius": radius, **self.settings, **settings, "samples": samples})

    def hold(self, tool, radius, points, dabs, **settings):
        """Rests for so many dabs, on its way from the first point to the last."""
        path = [along(points, i / max(dabs - 1, 1)) for i in range(dabs)]
        self.stroke(tool, radius, [sample(i * DAB, p) for i, p in enumerate(path)], **{"place": "nearest", **settings})

    def drag(self, tool, radius, points, spacing=0.15, place="nearest", **settings):
        """Moves through the points; a tool that follows the hand takes with it what was under the first."""
        samples, time = [], 0.0
        for i, p in enumerate(points):
            time += math.dist(p, points[i - 1]) / SPEED if i else 0
            samples.append(sample(time, p))
        self.stroke(tool, radius, samples, spacing=spacing, place=place, **settings)

    def turned(self, tool, radius, height, turns=1.0, step=8, rise=0.0, **settings):
        """Rests beside the turntable while the model turns; `rise`: so far it goes up meanwhile."""
        count = round(360 * turns / step)
        samples = [{"t": fixed(i * step / TURN), "position": [150, fixed(height + rise * i / count), 0], "direction": [-1, 0, 0]}
                   for i in range(count)]
        self.stroke(tool, radius, samples, place="ray", turntable_deg_per_s=TURN, **settings)

    def rest_above(self, tool, radius, dabs, **settings):
        """Over the axis."""
        self.stroke(tool, radius, [{"t": fixed(i * DAB), "position": [0, 150, 0], "direction": [0, -1, 0]} for i in range(dabs)], place="ray", **settings)

    def turned_above(self, tool, radius, x, turns=1.0, step=8, **settings):
        """Rests over the turntable, so far from its axis."""
        samples = [{"t": fixed(i * step / TURN), "position": [x, 150, 0], "direction": [0, -1, 0]} for i in range(round(360 * turns / step))]
        self.stroke(tool, radius, samples, place="ray", turntable_deg_per_s=TURN, **settings)

    def command(self, word, **keys):
        self.strokes.append({"command": word, **keys})

    def take(self):
        strokes, self.strokes = self.strokes, []
        return strokes


def fixed(x):
    return round(x, 3) + 0


def sample(time, p):
    return {"t": fixed(time), "position": [fixed(x) for x in p]}


def along(points, share):
    at = share * (len(points) - 1)
    i = min(int(at), len(points) - 2) if len(points) > 1 else 0
    if len(points) == 1:
        return points[0]
    return [a + (at - i) * (b - a) for a, b in zip(points[i], points[i + 1])]


def arc(centre, radius, start, end, count, z=0.0):
    """In the plane z; degrees from x towards y."""
    angles = [math.radians(start + (end - start) * i / (count - 1)) for i in range(count)]
    return [[centre[0] + radius * math.cos(a), centre[1] + radius * math.sin(a), z] for a in angles]


def on_ball(radius, longitude, latitude):
    """Longitude 0: in front (z), 90: at the right (x)."""
    lon, lat = math.radians(longitude), math.radians(latitude)
    return [radius * math.cos(lat) * math.sin(lon), radius * math.sin(lat), radius * math.cos(lat) * math.cos(lon)]


def first_clay():
    hand = Hand()
    hand.hold("pull", 42, [[0, 50, 0], [0, 78, 0]], 9)
    yield "pull", hand.take()
    hand.hold("push", 22, [[0, 84, 0]], 11)
    yield "push", hand.take()
    for longitude in range(0, 360, 60):
        hand.drag("smooth", 26, [on_ball(48, longitude, -60), on_ball(50, longitude, 0), [20 * math.sin(math.radians(longitude)), 60, 20 * math.cos(math.radians(longitude))]])
    yield "smooth", hand.take()
    hand.drag("snake", 7, [[0, 72, 0], [0, 80, 0], [3, 92, 0], [7, 100, 0]], spacing=0.1)
    hand.command("flatten_base", height=4)
    yield "stalk", hand.take()


def mug():
    hand = Hand()
    hand.turned("push", 40, 0, turns=1, step=10, strength=0.7, detail=0.5)
    hand.command("flatten_base", height=12)
    hand.command("place_on_bed")
    yield "body", hand.take()
    hand.rest_above("flatten", 38, 4, detail=0.5)
    hand.rest_above("push", 28, 13, strength=1.4, detail=0.5)
    hand.turned_above("smooth", 14, 30)
    yield "hollow", hand.take()
    hand.turned("push", 6, 32, step=4, strength=1.2)
    hand.turned("push", 6, 47, step=4, strength=1.2)
    yield "grooves", hand.take()
    handle = [[42, 66, 0], [50, 69, 0], *arc([47, 43], 26, 75, -80, 24), [44, 17, 0], [34, 17, 0]]
    hand.drag("snake", 12, handle, spacing=0.06, place="point")
    yield "handle", hand.take()
    for height in (66, 18):
        hand.drag("smooth", 13, [[40, height, 12], [46, height, 10], [50, height, 0], [46, height, -10], [40, height, -12]], spacing=0.15)
    yield "finish", hand.take()


def creature():
    hand = Hand(symmetry="x")
    hand.hold("pull", 17, [on_ball(50, 35, -48), on_ball(82, 35, -54)], 17)
    hand.hold("pull", 17, [on_ball(50, 145, -48), on_ball(82, 145, -54)], 17)
    yield "legs", hand.take()
    hand.drag("snake", 18, [on_ball(50, 55, 48), on_ball(60, 55, 52), on_ball(72, 52, 58), on_ball(84, 44, 62)], spacing=0.06)
    hand.drag("snake", 14, [on_ball(50, 180, -8), on_ball(62, 180, -4), on_ball(74, 180, 6), on_ball(82, 180, 18)], spacing=0.06)
    yield "ears", hand.take()
    hand.hold("pull", 20, [on_ball(50, 0, -4), on_ball(58, 0, -4)], 6)
    hand.hold("inflate", 11, [on_ball(50, 26, 22), on_ball(53, 26, 22)], 12)
    hand.hold("push", 5, [on_ball(58, 24, 22)], 4)
    hand.hold("push", 4, [[6, -3, 62]], 5)
    yield "face", hand.take()
    hand.command("flatten_base", height=6)
    hand.command("place_on_bed")
    yield "base", hand.take()


def toy_car():
    hand = Hand()
    hand.command("transform", centre=[0, 0, 0], scale=[1, 0.3, 0.5])
    yield "body", hand.take()
    size = {"width": 50, "height": 24, "depth": 44}
    hand.command("insert", primitive="box", **size, where="centre", centre=[-8, 26, 0], combine="join")
    yield "cabin", hand.take()
    hand.command("trim", outline=[[4, 38.5, 0], [24, 44, 0], [18, 15.5, 0]], along=[0, 0, -1])
    yield "windscreen", hand.take()
    for x, z in ((28, 25), (-28, 25), (28, -25), (-28, -25)):
        wheel = {"primitive": "cylinder", "radius": 14, "height": 10, "axis": "z"}
        hand.command("insert", **wheel, where="centre", centre=[x, -14, z], combine="part")
    yield "wheels", hand.take()
    hand.command("combine_parts", operation="union", parts=[1, 2, 3, 4])
    hand.command("place_on_bed")
    yield "join", hand.take()


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    lessons = {"first-clay": first_clay(), "mug": mug(), "creature": creature(), "toy-car": toy_car()}
    for folder, steps in lessons.items():
        for name, strokes in steps:
            text = ",\n".join(json.dumps(stroke, separators=(",", ":")) for stroke in strokes)
            with open(os.path.join(here, folder, name + ".json"), "w", encoding="utf-8") as file:
                file.write('{"format":"fettle-strokes","version":1,"strokes":[\n' + text + "]}\n")


if __name__ == "__main__":
    main()
