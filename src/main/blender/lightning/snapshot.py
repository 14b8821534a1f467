# SPDX-License-Identifier: Apache-2.0
"""What a render of a scene shows: its objects with their meshes, their instances, and the lights in instances."""

from dataclasses import dataclass, field

import bpy
from mathutils import Matrix

from . import render_graph, strands, visibility, volumes, world
from .left_out import LeftOut

# Objects that have no surface of their own.
BARE_TYPES = {"ARMATURE", "CAMERA", "EMPTY", "LATTICE", "LIGHT", "LIGHT_PROBE", "SPEAKER"}
# Objects whose surface Blender lists once more, as an instance of a mesh.
CONVERTED_TYPES = {"CURVE", "FONT", "META", "SURFACE"}
# Most instances. Lightning reads files with some more.
MOST_INSTANCES = 200_000
# Most lights of a scene of Lightning.
MOST_LIGHTS = 1000


def is_itself(instance) -> bool:
    """Returns whether an instance is the object's own surface."""
    return instance.instance_object.original == instance.parent.original and instance.matrix_world == instance.parent.matrix_world


@dataclass
class Shown:
    """An object of the scene, with what is at its place.

    Attributes:
        shapes: indices of meshes
        children: instances: name, matrix in the world, index of the mesh
    """

    matrix: Matrix
    shapes: list[int] = field(default_factory=list)
    children: list[tuple[str, Matrix, int]] = field(default_factory=list)


@dataclass
class Shape:
    """A mesh of a render, which is a new block of Blender.

    Attributes:
        name: that of the block that it was made from
        part: word for it, if the object has others
    """

    mesh: bpy.types.Mesh
    materials: tuple
    name: str
    part: str


class Snapshot:
    """What a render shows. Close it, because its meshes are blocks of Blender's file.

    Attributes:
        objects: objects with surfaces or instances, by name
        loose: name, matrix and mesh of instances that do not move with the object that makes them
        lights: lights in instances: object, object that makes the instances, matrix
        watched: names of objects that move others in a way that only an export knows
        camera: matrix of the scene's camera
        fog: the volume of a box, as Lightning's world
        messages: what the fog loses
    """

    def __init__(self, scene) -> None:
        """Takes the snapshot.

        Raises:
            RuntimeError: Blender cannot evaluate the scene
        """
        self.objects: dict[str, Shown] = {}
        self.loose: list[tuple[str, Matrix, int]] = []
        self.lights: list[tuple] = []
        self.watched: set[str] = set()
        self.camera = Matrix()
        self.left_out = LeftOut()
        self.fog: dict = {}
        self.messages: list[str] = []
        self._has_world_fog = "fog" in world.kinds(scene.world)
        self.shapes: list[Shape] = []
        self._count = 0
        self._room = max(MOST_LIGHTS - sum(obj.type == "LIGHT" for obj in scene.objects), 0)
        self._indices: dict[tuple, int | None] = {}
        try:
            render_graph.visit(scene, lambda depsgraph, reader: self._read(scene, depsgraph, reader))
        except BaseException:
            self.close()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_) -> None:
        self.close()

    def close(self) -> None:
        """Removes the meshes."""
        bpy.data.batch_remove([shape.mesh for shape in self.shapes])
        self.shapes = []

    def _read(self, scene, depsgraph, reader) -> None:
        if scene.camera is not None:
            self.camera = scene.camera.evaluated_get(depsgraph).matrix_world.copy()
        for instance in depsgraph.object_instances:
            if instance.object.original != reader:
                self._add(instance, depsgraph)

    def _add(self, instance, depsgraph) -> None:
        obj = instance.object
        # Blender lists text, curves and metaballs a second time, as a mesh at the same place.
        is_instance = instance.is_instance and not is_itself(instance)
        maker = instance.parent.original if instance.is_instance else obj.original
        if is_instance:
            self.watched.add(instance.instance_object.original.name)
        if obj.type == "LIGHT":
            if is_instance and not visibility.is_portal(obj.original):
                self.watched.add(maker.name)
                if len(self.lights) == self._room:
                    self.left_out.add(f"more than {MOST_LIGHTS} lights, so the rest of those in instances is left out", maker.name)
                    return
                self.lights.append((obj.original, maker, instance.matrix_world.copy()))
            return
        if obj.type in BARE_TYPES | CONVERTED_TYPES:
            return
        owner = instance.instance_object if instance.is_instance else obj
        for shown in (owner, instance.parent) if is_instance else (obj,):
            if not visibility.is_seen_by_camera(shown, depsgraph.view_layer_eval):
                self.left_out.add("hidden from the camera, so left out with reflections, shadows and indirect light", shown.original.name)
                return
        if is_instance and self._count == MOST_INSTANCES:
            self.left_out.add(f"more than {MOST_INSTANCES} instances, so the rest is left out", maker.name)
            return
        if obj.type == "MESH" and volumes.has_only_volume(obj):
            self._add_fog(obj, instance.matrix_world, owner.original.name)
            return
        self._count += is_instance
        self.left_out.add_rays(owner, owner.original.name)
        shapes = [self._shape(obj, owner, depsgraph)] if instance.show_self else []
        if instance.show_particles:
            shapes += [self._hair(obj, i) for i in range(len(obj.particle_systems))]
        for shape in [index for index in shapes if index is not None]:
            self._place(instance, maker, is_instance, shape)

    def _add_fog(self, obj, matrix, name: str) -> None:
        """Takes the first box whose volume is a fog as Lightning's fog."""
        bounds = volumes.box(obj.data, matrix)
        if bounds is None:
            self.left_out.add("volumes of shapes other than a box along the axes are not sent", name)
        elif self._has_world_fog or self.fog:
            self.left_out.add("only one fog is sent, so these volumes are left out", name)
        else:
            material = next(slot.material for slot in obj.material_slots if slot.material is not None)
            self.fog = volumes.fog(material, name, self.messages)
            self.fog |= {"fog_center": bounds[0], "fog_size": bounds[1]} if self.fog else {}

    def _place(self, instance, maker, is_instance: bool, shape: int) -> None:
        matrix = instance.matrix_world.copy()
        name = instance.instance_object.original.name if is_instance else maker.name
        system = instance.particle_system
        if system is not None and system.settings.type == "EMITTER":
            self.loose.append((name, matrix, shape))
            self.watched.add(maker.name)
        elif is_instance:
            self._shown(maker.name, instance.parent.matrix_world).children.append((name, matrix, shape))
        else:
            self._shown(maker.name, matrix).shapes.append(shape)

    def _shown(self, name: str, matrix) -> Shown:
        if name not in self.objects:
            self.objects[name] = Shown(matrix.copy())
        return self.objects[name]

    def _shape(self, obj, owner, depsgraph) -> int | None:
        if obj.type == "MESH":
            # A copy of a mesh in edit mode is empty. An instance that geometry nodes make has a mesh that its object does not have.
            is_own = obj.data == owner.data
            return self._index((obj.data.as_pointer(),), obj, lambda: bpy.data.meshes.new_from_object(
                owner, preserve_all_data_layers=True, depsgraph=depsgraph) if is_own else obj.data.copy())
        if obj.type == "CURVES":
            return self._index((obj.data.as_pointer(),), obj, lambda: strands.of_curves(obj.data, obj.original.name, self.left_out))
        self.left_out.add_type(obj)
        return None

    def _hair(self, obj, number: int) -> int | None:
        system = obj.particle_systems[number]
        if system.settings.type != "HAIR" or system.settings.render_type != "PATH":
            return None
        slot = min(max(system.settings.material, 1), max(len(obj.material_slots), 1)) - 1
        return self._index((obj.original.as_pointer(), number), obj, lambda: strands.of_particles(obj, system, self.left_out), slot)

    def _index(self, block: tuple, obj, create, slot: int | None = None) -> int | None:
        """Returns the index of a mesh with the materials of an object; None if it has no faces."""
        own = tuple(s.material.original if s.link == "OBJECT" and s.material is not None else None for s in obj.material_slots)
        key = (*block, *(material and material.as_pointer() for material in own))
        if key not in self._indices:
            mesh = create()
            if mesh is None or not mesh.polygons:
                self._indices[key] = None
                if mesh is not None:
                    bpy.data.meshes.remove(mesh)
                return None
            if slot is None:
                # A mesh of geometry nodes has materials that its object does not have. Tubes have none.
                data = [material and material.original for material in (obj.data if obj.type == "CURVES" else mesh).materials]
                count = max(len(data), len(own))
                materials = [own[i] if i < len(own) and own[i] is not None else data[i] if i < len(data) else None for i in range(count)]
            else:
                materials = [s.material and s.material.original for s in obj.material_slots][slot:slot + 1]
            self._indices[key] = len(self.shapes)
            self.shapes.append(Shape(mesh, tuple(materials), (obj.original.data or obj.data).name, "surface" if slot is None else "hair"))
        return self._indices[key]
