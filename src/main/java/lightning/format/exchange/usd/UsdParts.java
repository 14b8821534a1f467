package lightning.format.exchange.usd;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.base.math.Transform;
import lightning.base.text.RefusalException;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.Bounds;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.exchange.assembly.TransformDecomposition;
import lightning.format.gltf.JsonValue;
import lightning.format.gltf.MeshFileWriter;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;
import lightning.format.mesh.NamedMesh;
import lightning.format.mesh.UniqueNames;
import lightning.format.usd.UsdMesh;
import lightning.format.usd.UsdStage;
import lightning.format.usd.UsdSubdivision;
import lightning.scene.material.Material;
import lightning.scene.node.Mesh;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.value.Placement;

/** Shapes of single prims: parts of one file with all meshes, and solids. */
final class UsdParts {
    private final SceneAssembler assembler;
    private final UsdStage stage;
    private final List<String> materials = new ArrayList<>();
    /** Parts by mesh and subsets: a mesh has the same in all instances, but each may have its materials. */
    private final Map<String, List<Part>> meshes = new HashMap<>();
    private final int requestedLevels;
    private final Progress progress;
    private int[] levels = {};
    private String meshFile = "";

    /** @param levels refinements of subdivision surfaces */
    UsdParts(SceneAssembler assembler, UsdStage stage, int levels, Progress progress) {
        this.progress = progress;
        this.assembler = assembler;
        this.stage = stage;
        requestedLevels = levels;
    }

    /** Reads materials and meshes of all nodes. */
    void read(JsonValue nodes) throws IOException, MeshException {
        var textures = new UsdTextures(assembler);
        var converter = new UsdMaterialImport(assembler, textures);
        JsonValue all = stage.root().get("materials");
        List<JsonValue> images = new ArrayList<>();
        for (int i = 0; i < all.size(); i++) {
            images.addAll(converter.maps(all.element(i)));
        }
        textures.fit(images);
        for (int i = 0; i < all.size(); i++) {
            materials.add(assembler.addMaterial(all.element(i).get("name").text().orElse(""), converter.convert(all.element(i))));
        }
        levels = UsdSubdivision.levels(stage.root().get("meshes"), requestedLevels);
        List<NamedMesh> written = new ArrayList<>();
        var names = new UniqueNames();
        long triangles = 0;
        for (int i = 0; i < nodes.size(); i++) {
            JsonValue node = nodes.element(i);
            progress.checkCanceled("canceled while the meshes of the stage were read");
            if (node.get("mesh").isPresent() && !meshes.containsKey(key(node))) {
                List<Part> parts = parts(node, names);
                meshes.put(key(node), parts);
                parts.stream().flatMap(p -> p.mesh().map(m -> new NamedMesh(p.name(), m)).stream()).forEach(written::add);
                triangles += parts.stream().flatMap(p -> p.mesh().stream()).mapToLong(Mesh::triangleCount).sum();
                if (triangles > MeshLimits.TRIANGLES || written.size() > MeshLimits.PARTS) {
                    throw node.problem(
                            "must be a stage of at most " + MeshLimits.TRIANGLES + " triangles in " + MeshLimits.PARTS + " meshes");
                }
            }
        }
        if (!written.isEmpty()) {
            try {
                meshFile = assembler.addFile(assembler.stem() + ".meshes.glb", MeshFileWriter.write(written));
            } catch (RefusalException e) {
                throw nodes.problem(e.getMessage());
            }
        }
    }

    private static String key(JsonValue node) throws MeshException {
        return node.get("mesh").node() + " " + node.get("subsets").node();
    }

    /** Part of a mesh prim; without a mesh if it has no faces. */
    private record Part(String name, Optional<Mesh> mesh) {}

    private List<Part> parts(JsonValue node, UniqueNames names) throws IOException, MeshException {
        int mesh = node.get("mesh").index(stage.root().get("meshes"));
        JsonValue in = stage.root().get("meshes").element(mesh);
        assembler.notes.add("subdivision surfaces refined less, to keep the number of triangles in bounds",
                UsdSubdivision.isSurface(in) && levels[mesh] < requestedLevels ? 1 : 0);
        JsonValue subsets = node.get("subsets");
        List<int[]> faces = new ArrayList<>();
        for (int i = 0; i < subsets.size(); i++) {
            faces.add(stage.ints(subsets.element(i).get("faces")));
        }
        List<Mesh> read = UsdMesh.read(stage, in, levels[mesh], faces, assembler.notes);
        List<Part> result = new ArrayList<>();
        for (int i = 0; i < read.size(); i++) {
            String name = in.get("name").text().orElse("") + (i == 0 ? "" : " " + subsets.element(i - 1).get("name").text().orElse(""));
            result.add(new Part(read.get(i) == null ? "" : names.unique(name, "mesh"), Optional.ofNullable(read.get(i))));
        }
        return result;
    }

    /** Returns the number of shapes of a prim. */
    int count(JsonValue node) throws MeshException {
        return node.get("mesh").isPresent() ? (int) requireNonNull(meshes.get(key(node))).stream().filter(p -> p.mesh().isPresent()).count()
                : UsdSolids.count(node.get("solid"));
    }

    /** Returns the only shape of a prim. */
    Shape shape(JsonValue node, Placement placement, Transform outer) throws MeshException {
        String name = node.get("name").text().orElse("");
        if (!node.get("mesh").isPresent()) {
            List<Placement> placements = TransformDecomposition.decompose(placement.transform().times(
                    UsdSolids.of(node.get("solid")).getFirst().transform()));
            Placement own = placements.size() == 1 ? placements.getFirst() : placement;
            assembler.bounds.add(Bounds.UNIT_CUBE, outer.times(own.transform()));
            return new Shape(UsdSolids.of(node.get("solid")).getFirst().solid(), assembler.names.unique(name, "shape"),
                    material(node.get("material")), own);
        }
        List<Part> parts = requireNonNull(meshes.get(key(node)));
        for (int i = 0; i < parts.size(); i++) {
            if (parts.get(i).mesh().isPresent()) {
                return shape(node, i, name, placement, outer);
            }
        }
        throw new AssertionError("a prim without a shape");
    }

    private Shape shape(JsonValue node, int part, String name, Placement placement, Transform outer) throws MeshException {
        Part mesh = requireNonNull(meshes.get(key(node))).get(part);
        JsonValue material = part == 0 ? node.get("material") : node.get("subsets").element(part - 1).get("material");
        return assembler.createShape(name, meshFile, mesh.name(), mesh.mesh().orElseThrow(), material(material), placement, outer);
    }

    /** Returns the shapes of a prim, each with a transform. */
    List<SceneNode> shapes(JsonValue node, Transform local, Transform outer) throws MeshException {
        List<SceneNode> result = new ArrayList<>();
        String name = node.get("name").text().orElse("");
        if (node.get("mesh").isPresent()) {
            List<Part> parts = requireNonNull(meshes.get(key(node)));
            for (int i = 0; i < parts.size(); i++) {
                List<Placement> placements = TransformDecomposition.decompose(local);
                if (parts.get(i).mesh().isPresent() && placements.size() == 1) {
                    result.add(shape(node, i, parts.get(i).name(), placements.getFirst(), outer));
                } else if (parts.get(i).mesh().isPresent()) {
                    assembler.notes.add("objects nested too deep to be sheared");
                }
            }
        }
        for (UsdSolids.Part solid : UsdSolids.of(node.get("solid"))) {
            List<Placement> placements = TransformDecomposition.decompose(local.times(solid.transform()));
            if (placements.size() == 1) {
                assembler.bounds.add(Bounds.UNIT_CUBE, outer.times(placements.getFirst().transform()));
                result.add(new Shape(solid.solid(), assembler.names.unique(name, "shape"), material(node.get("material")),
                        placements.getFirst()));
            } else {
                assembler.notes.add("objects that are flat, too small or too large");
            }
        }
        return result;
    }

    private String material(JsonValue index) throws MeshException {
        int material = index.integer(-1, materials.size() - 1, -1);
        assembler.notes.add("objects without a material, imported as gray", material < 0 ? 1 : 0);
        return material < 0 ? Material.DEFAULT.name() : materials.get(material);
    }
}
