"""Cases of other formats: a square or a cube in the bare view."""

import math
import struct
import zipfile

from parts import HERE, Gltf, case, png

SQUARE = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
FACE = "usemtl m\nf 1/1 2/2 3/3 4/4\n"
CUBE = "".join(f"v {x} {y} {z}\n" for z in (-1, 1) for y in (-1, 1) for x in (-1, 1))
CUBE_FACES = "f 5 6 8 7\nf 2 1 3 4\nf 6 2 4 8\nf 1 5 7 3\nf 7 8 4 3\nf 1 2 6 5\n"


def obj(name, mtl, geometry=SQUARE, faces=FACE):
    file = name.replace(" ", "_")
    (HERE / f"{file}.mtl").write_text("newmtl m\n" + mtl)
    (HERE / f"{file}.obj").write_text(f"mtllib {file}.mtl\n{geometry}{faces}")
    return f"{file}.obj"


png("disc_alpha.png", 16, 16, [[[255, 255, 255, 255 if (x - 7.5) ** 2 + (y - 7.5) ** 2 < 36 else 0] for x in range(16)]
                               for y in range(16)], 4)
png("disc_grey.png", 16, 16, [[[255 if (x - 7.5) ** 2 + (y - 7.5) ** 2 < 36 else 0] for x in range(16)]
                              for y in range(16)], 1)
png("bumps.png", 16, 16, [[[int(127.5 + 127.5 * math.sin(x * math.pi / 4) * math.sin(y * math.pi / 4))] for x in range(16)]
                          for y in range(16)], 1)
plain = obj("mtl plain", "Kd 1 1 1\nmap_Kd corners.png\n")
case("MTL -s", obj("mtl scale", "Kd 1 1 1\nmap_Kd -s 2 2 1 corners.png\n"), "2 x 2 pictures", unlike=plain)
case("MTL -o", obj("mtl offset", "Kd 1 1 1\nmap_Kd -o 0.5 0 0 corners.png\n"), "moved by half", unlike=plain)
case("MTL -mm", obj("mtl gain", "Kd 1 1 1\nmap_Kd -mm 0.5 0.2 corners.png\n"), "paler", unlike=plain)
case("MTL -clamp", obj("mtl clamp", "Kd 1 1 1\nmap_Kd -clamp on -s 2 2 1 corners.png\n"), "one picture, its edges drawn out",
     unlike="mtl_scale.obj")
case("MTL map_d with alpha", obj("mtl alpha", "Kd .2 .7 .2\nmap_d disc_alpha.png\n"), "the alpha counts, not the red",
     like=obj("mtl grey", "Kd .2 .7 .2\nmap_d disc_grey.png\n"))
case("MTL -imfchan", obj("mtl channel", "Kd .2 .7 .2\nmap_d -imfchan m disc_alpha.png\n"), "the alpha", like="mtl_grey.obj")
case("MTL bump", obj("mtl bump", "Kd .6 .6 .6\nbump -bm 1 bumps.png\n"), "bumps", textured=True)
case("MTL map_Pr", obj("mtl rough", "Kd .9 .6 .2\nmap_Pr halves.png\nmap_Pm halves.png\n"), "roughness and metalness of maps",
     unlike=obj("mtl smooth", "Kd .9 .6 .2\nPr 1\nPm 0\n"))
case("MTL Tr 1", obj("mtl tr", "Kd .8 .2 .2\nTr 1\n"), "drawn opaque, and said", warned="would make it vanish", drawn=True)
case("MTL Kd 255", obj("mtl 255", "Kd 255 51 51\n"), "taken as 0 to 255, and said", warned="expected at most 1",
     like=obj("mtl one", "Kd 1 0.2 0.2\n"))
case("MTL illum 0", obj("mtl constant", "Kd .2 .7 .2\nillum 0\n", geometry=CUBE, faces="usemtl m\n" + CUBE_FACES),
     "one colour, whatever the light", one_colour=True)
case("MTL refl", obj("mtl mirror", "Kd .2 .7 .2\nrefl -type sphere sky.png\n"), "named as left out", warned="refl")
for name, lines in (("smooth", "s 1\n"), ("flat", "s off\n")):
    (HERE / f"obj_{name}.obj").write_text(CUBE + lines + CUBE_FACES)
case("OBJ s off", "obj_flat.obj", "flat faces", unlike="obj_smooth.obj")
for name, text in (("NUL at the end", SQUARE + "f 1 2 3 4\n\0\0\0"), ("v//", SQUARE + "f 1// 2// 3// 4//\n"),
                   ("v/vt/", SQUARE + "f 1/1/ 2/2/ 3/3/ 4/4/\n"), ("curv2", SQUARE + "curv2 1 2\nf 1 2 3 4\n"),
                   ("nan colours", "v 0 0 0 nan nan nan\nv 1 0 0 nan nan nan\nv 0 1 0 nan nan nan\nf 1 2 3\n")):
    file = "obj_" + {"NUL at the end": "nul", "v//": "slashes", "v/vt/": "slash"}.get(name, name.replace(" ", "_")) + ".obj"
    (HERE / file).write_text(text)
    case(f"OBJ {name}", file, "drawn", drawn=True, **({"warned": "free-form curves"} if name == "curv2" else {}))
(HERE / "obj_colors.obj").write_text("v -1 -1 0 1 0 0\nv 1 -1 0 0 1 0\nv 1 1 0 0 1 0\nv -1 1 0 1 0 0\nf 1 2 3 4\n")
case("OBJ vertex colours", "obj_colors.obj", "red at the left, green at the right", halves=True)
(HERE / "colors.ply").write_text(
    "ply\nformat ascii 1.0\nelement vertex 4\n" + "".join(f"property float {c}\n" for c in "xyz") +
    "".join(f"property uchar {c}\n" for c in ("red", "green", "blue")) +
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "-1 -1 0 255 0 0\n1 -1 0 0 255 0\n1 1 0 0 255 0\n-1 1 0 255 0 0\n4 0 1 2 3\n")
case("PLY vertex colours", "colors.ply", "red at the left, green at the right", halves=True)
(HERE / "faint.ply").write_text((HERE / "colors.ply").read_text().replace(
    "property uchar blue\n", "property uchar blue\nproperty uchar alpha\n").replace(" 0 0\n", " 0 0 0\n").replace(" 255 0\n", " 255 0 0\n"))
case("PLY opacity 0 everywhere", "faint.ply", "drawn opaque", like="colors.ply")
(HERE / "points.ply").write_text("ply\nformat ascii 1.0\nelement vertex 2\n" + "".join(
    f"property float {c}\n" for c in "xyz") + "end_header\n0 0 0\n1 1 1\n")
case("PLY point cloud", "points.ply", "refused in words that help", refused="point cloud")
HALVES = "red at the left, green at the right"
(HERE / "diffuse.ply").write_text((HERE / "colors.ply").read_text().replace("property uchar ", "property uchar diffuse_"))
case("PLY diffuse_red", "diffuse.ply", "the same colours under another name", like="colors.ply")
(HERE / "float_255.ply").write_text((HERE / "colors.ply").read_text().replace("property uchar ", "property float "))
case("PLY floats to 255", "float_255.ply", "the same colours in another type", like="colors.ply")
(HERE / "face_colors.ply").write_text((HERE / "colors.ply").read_text().replace(" 255 0 0", "").replace(" 0 255 0", "").replace(
    "".join(f"property uchar {c}\n" for c in ("red", "green", "blue")), "").replace("vertex_indices\n", "vertex_indices\n" + "".join(
        f"property uchar {c}\n" for c in ("red", "green", "blue"))).replace("4 0 1 2 3", "4 0 1 2 3 255 0 0"))
case("PLY colours of faces", "face_colors.ply", "named as left out", drawn=True, warned="colours of faces")
CORNERS = ["-1 -1 0", "1 -1 0", "1 1 0", "-1 1 0"]
SIDES = ["255 0 0", "0 255 0", "0 255 0", "255 0 0"]
(HERE / "vertex_colors.off").write_text("COFF\n4 1 0\n" + "".join(
    f"{at} {colour} 255\n" for at, colour in zip(CORNERS, SIDES)) + "4 0 1 2 3\n")
case("OFF vertex colours", "vertex_colors.off", HALVES, halves=True, like="colors.ply")
STRIPES = ["-1 -1 0", "0 -1 0", "0 1 0", "-1 1 0", "1 -1 0", "1 1 0"]
for file, red, green in (("face_colors.off", "255 0 0", "0 255 0"), ("face_floats.off", "1.0 0 0", "0 1.0 0")):
    (HERE / file).write_text("OFF\n6 2 0\n" + "\n".join(STRIPES) + f"\n4 0 1 2 3 {red}\n4 1 4 5 2 {green}\n")
    case("OFF colours of faces" + (", as floats" if "floats" in file else ""), file, HALVES, halves=True)
(HERE / "obj_rgba.obj").write_text("".join(f"v {at} {colour.replace('255', '1')} 1\n" for at, colour in zip(CORNERS, SIDES)) +
                                   "f 1 2 3 4\n")
case("OBJ colours with opacity", "obj_rgba.obj", "v x y z r g b a", like="obj_colors.obj")
(HERE / "obj_mrgb.obj").write_text("".join(f"v {at}\n" for at in CORNERS) + "#MRGB ffff0000ff00ff00ff00ff00ffff0000\nf 1 2 3 4\n")
case("OBJ colours of ZBrush", "obj_mrgb.obj", "comments #MRGB MMRRGGBB", like="obj_colors.obj")
(HERE / "obj_vc.obj").write_text("".join(f"v {at}\nvc 1 0 0\n" for at in CORNERS) + "f 1 2 3 4\n")
case("OBJ unknown statement", "obj_vc.obj", "named as left out", drawn=True, warned="vc")


def binary_stl(file, header, triangles):
    """Triangles of a stripe each, with the attribute word of its two."""
    data = b""
    for corners, word in triangles:
        for t in ((0, 1, 2), (0, 2, 3)):
            numbers = [0, 0, 1] + [float(x) for i in t for x in STRIPES[corners[i]].split()]
            data += struct.pack("<12fH", *numbers, word)
    (HERE / file).write_bytes(header.ljust(80, b" ") + struct.pack("<I", 2 * len(triangles)) + data)


LEFT_STRIPE, RIGHT_STRIPE = (0, 1, 2, 3), (1, 4, 5, 2)
binary_stl("viscam.stl", b"VisCAM", [(LEFT_STRIPE, 0x8000 | 31 << 10), (RIGHT_STRIPE, 0x8000 | 31 << 5)])
case("STL colours of VisCAM", "viscam.stl", HALVES, halves=True)
binary_stl("magics.stl", b"COLOR=\x00\xff\x00\xff", [(LEFT_STRIPE, 31), (RIGHT_STRIPE, 0x8000)])
case("STL colours of Magics", "magics.stl", HALVES + ", which is the header's", halves=True, like="viscam.stl")


def fbx(file, up, front, sign, points):
    settings = (("UpAxis", up), ("UpAxisSign", 1), ("FrontAxis", front), ("FrontAxisSign", sign), ("CoordAxis", 0),
                ("CoordAxisSign", 1))
    lines = "".join(f'\t\tP: "{name}", "int", "Integer", "",{value}\n' for name, value in settings)
    numbers = ",".join(str(x) for p in points for x in p)
    (HERE / file).write_text(f"""; FBX 7.4.0 project file
FBXHeaderExtension: {{
\tFBXHeaderVersion: 1003
\tFBXVersion: 7400
}}
GlobalSettings: {{
\tVersion: 1000
\tProperties70: {{
{lines}\t\tP: "UnitScaleFactor", "double", "Number", "",1
\t}}
}}
Objects: {{
\tGeometry: 100, "Geometry::", "Mesh" {{
\t\tVertices: *{3 * len(points)} {{
\t\t\ta: {numbers}
\t\t}}
\t\tPolygonVertexIndex: *12 {{
\t\t\ta: 0,1,-4,1,2,-4,2,0,-4,0,2,-2
\t\t}}
\t}}
\tModel: 200, "Model::tetrahedron", "Mesh" {{
\t\tVersion: 232
\t}}
}}
Connections: {{
\tC: "OO",200,0
\tC: "OO",100,200
}}
""")


POINTS = [(-1, 0, 1), (1, 0, 1), (0, 0, -1), (0.3, 3, 0)]
fbx("y_up.fbx", 1, 2, 1, POINTS)
fbx("z_up.fbx", 2, 1, -1, [(x, -z, y) for x, y, z in POINTS])
case("FBX with z up", "z_up.fbx", "the same as with y up", like="y_up.fbx")

TYPES = "http://schemas.openxmlformats.org/package/2006"
CORE = "http://schemas.microsoft.com/3dmanufacturing"
MODEL = f"""<?xml version="1.0" encoding="UTF-8"?>
<model unit="inch" xmlns="{CORE}/core/2015/02"><resources><basematerials id="1"><base name="red" displaycolor="#FF0000FF"/>
<base name="green" displaycolor="#00FF00FF"/></basematerials><object id="2" type="model" pid="1" pindex="0"><mesh><vertices>
<vertex x="0" y="0" z="0"/><vertex x="2" y="0" z="0"/><vertex x="0" y="0" z="3"/><vertex x="2" y="0" z="3"/></vertices><triangles>
<triangle v1="0" v2="1" v3="2"/><triangle v1="2" v2="1" v3="3" pid="1" p1="1"/></triangles></mesh></object></resources>
<build><item objectid="2"/></build></model>
"""
with zipfile.ZipFile(HERE / "inches.3mf", "w", zipfile.ZIP_DEFLATED) as package:
    for name, text in (("[Content_Types].xml", f"""<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="{TYPES}/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>
"""), ("_rels/.rels", f"""<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="{TYPES}/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="{CORE}/2013/01/3dmodel"/></Relationships>
"""), ("3D/3dmodel.model", MODEL)):
        package.writestr(zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0)), text, zipfile.ZIP_DEFLATED)
case("3MF colours of triangles", "inches.3mf", "named as left out", drawn=True, warned="colours of triangles")
facets = [((5, 6, 8), (0, 0, 1)), ((5, 8, 7), (0, 0, 1)), ((2, 1, 3), (0, 0, -1)), ((2, 3, 4), (0, 0, -1)),
          ((6, 2, 4), (1, 0, 0)), ((6, 4, 8), (1, 0, 0)), ((1, 5, 7), (-1, 0, 0)), ((1, 7, 3), (-1, 0, 0)),
          ((7, 8, 4), (0, 1, 0)), ((7, 4, 3), (0, 1, 0)), ((1, 2, 6), (0, -1, 0)), ((1, 6, 5), (0, -1, 0))]
vertex = [None] + [line[2:] for line in CUBE.splitlines()]
(HERE / "cube.stl").write_text("solid cube\n" + "".join(
    f"facet normal {n[0]} {n[1]} {n[2]}\nouter loop\n" + "".join(f"vertex {vertex[i]}\n" for i in t) + "endloop\nendfacet\n"
    for t, n in facets) + "endsolid cube\n")
case("STL", "cube.stl", "flat faces", unlike="obj_smooth.obj")
cube = Gltf({}, camera=False, square=False)
cube.mesh({"POSITION": cube.floats([[float(x) for x in vertex[i].split()] for i in range(1, 9)])},
          cube.shorts([i - 1 for t, _ in facets for i in t]))
cube.write("no_normals.gltf")
own = Gltf({}, camera=False, square=False)
own.mesh({"POSITION": own.floats([[float(x) for x in vertex[i].split()] for t, _ in facets for i in t]),
          "NORMAL": own.floats([list(n) for t, n in facets for _ in t])})
own.write("flat_normals.gltf")
case("glTF without normals", "no_normals.gltf", "glTF 2.0, 3.7.2.1: flat normals", like="flat_normals.gltf")
