# A landscape for `airlight haze`, rendered by another program: blender -b -P scene.py -- valley.exr
#
# Hills of sines and 24 towers among them, from 350 m to 9 km away, before mountains at 20 km, in the light of a low sun and of a blue dome; no air. Metres,
# z up, the camera looks north. Lamps and dome are in cd/m2 and lx: --exposure-of-color 1.
import math
import sys

import bpy

SUN_AZIMUTH, SUN_ELEVATION = math.radians(235), math.radians(18)
EYE = (0.0, 0.0, 150.0)

bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene


def material(name, colour):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    nodes = made.node_tree.nodes
    nodes.clear()
    diffuse = nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (*colour, 1)
    output = nodes.new("ShaderNodeOutputMaterial")
    made.node_tree.links.new(diffuse.outputs[0], output.inputs["Surface"])
    return made


def mesh(name, vertices, faces, look):
    data = bpy.data.meshes.new(name)
    data.from_pydata(vertices, [], faces)
    data.materials.append(look)
    scene.collection.objects.link(bpy.data.objects.new(name, data))


def height(x, y):
    rise = 40 * math.sin(x / 310) * math.cos(y / 470) + 90 * math.sin(x / 1300 + 1) * math.sin(y / 1700)
    far = max(y - 4000, 0) / 16000  # mountains behind
    return rise + 1400 * far * (1 + 0.5 * math.sin(x / 1900) * math.cos(y / 2300) + 0.2 * math.sin(x / 430 + y / 610))


def land():
    # Rows that widen with distance: triangles of about equal size in the picture.
    columns, rows = 241, 260
    vertices, faces = [], []
    for j in range(rows):
        y = 60 * 1.022**j
        for i in range(columns):
            x = (i / (columns - 1) - 0.5) * 2.4 * (y + 300)
            vertices.append((x, y, height(x, y)))
    for j in range(rows - 1):
        for i in range(columns - 1):
            a = j * columns + i
            faces.append((a, a + 1, a + columns + 1, a + columns))
    mesh("land", vertices, faces, material("grass", (0.07, 0.10, 0.035)))


def towers():
    walls = [material(f"wall {i}", c) for i, c in enumerate([(0.45, 0.36, 0.27), (0.5, 0.5, 0.48), (0.42, 0.13, 0.08)])]
    for i in range(24):
        y = 350 * 1.15**i
        x = y * (0.42 * math.sin(2.4 * i) + 0.05)
        side, bottom = 26, height(x, y) - 20
        top = bottom + 150 + 40 * math.sin(1.7 * i)
        box = [(x + side * a, y + side * b, z) for z in (bottom, top) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        faces = [(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
        mesh(f"tower {i}", box, faces, walls[i % 3])


def light():
    lamp = bpy.data.lights.new("sun", "SUN")
    # Blender's unit for a sun is W/m2, for radiance W/(m2 sr); it knows no colour of its own, so both are read as lx and cd/m2.
    lamp.energy = 60000
    lamp.color = (1.0, 0.80, 0.58)
    lamp.angle = math.radians(0.53)
    sun = bpy.data.objects.new("sun", lamp)
    sun.rotation_euler = (math.pi / 2 - SUN_ELEVATION, 0, -SUN_AZIMUTH + math.pi)
    scene.collection.objects.link(sun)
    world = bpy.data.worlds.new("dome")
    world.use_nodes = True
    background = world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = (0.45, 0.70, 1.0, 1)
    background.inputs["Strength"].default_value = 3500
    scene.world = world


def camera():
    lens = bpy.data.cameras.new("camera")
    lens.sensor_fit = "HORIZONTAL"
    lens.angle = math.radians(60)
    lens.clip_end = 1e6
    seen = bpy.data.objects.new("camera", lens)
    seen.location = EYE
    seen.rotation_euler = (math.radians(90), 0, 0)  # level, to the north
    scene.collection.objects.link(seen)
    scene.camera = seen


land()
towers()
light()
camera()
scene.render.engine = "CYCLES"
scene.cycles.device = "CPU"
scene.cycles.samples = 32
scene.cycles.use_denoising = False
scene.cycles.max_bounces = 2
scene.render.threads_mode = "FIXED"
scene.render.threads = 2
scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 320, 180, 100
scene.render.film_transparent = True  # alpha says where the sky is seen
scene.view_layers[0].use_pass_z = True
settings = scene.render.image_settings
settings.file_format = "OPEN_EXR_MULTILAYER"
settings.color_depth = "32"
settings.exr_codec = "ZIP"
for name in [n for n in dir(scene.render) if n.startswith("use_stamp_")]:
    setattr(scene.render, name, False)  # the file holds no dates and names
scene.render.filepath = sys.argv[sys.argv.index("--") + 1]
bpy.ops.render.render(write_still=True)
