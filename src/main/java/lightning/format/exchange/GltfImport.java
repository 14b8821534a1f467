package lightning.format.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import lightning.base.file.RegularFile;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.text.RefusalException;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.exchange.assembly.TransformDecomposition;
import lightning.format.exchange.json.SceneExtras;
import lightning.format.gltf.GltfAnimation;
import lightning.format.gltf.GltfCamera;
import lightning.format.gltf.GltfFile;
import lightning.format.gltf.GltfLight;
import lightning.format.gltf.GltfMaterial;
import lightning.format.gltf.GltfMeshReader;
import lightning.format.gltf.GltfNode;
import lightning.format.gltf.GltfPart;
import lightning.format.gltf.GltfScene;
import lightning.format.gltf.MaterialVariants;
import lightning.format.gltf.MeshFileWriter;
import lightning.format.gltf.PosedMeshes;
import lightning.format.jen.asset.JenLimits;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.scene.Camera;
import lightning.scene.asset.IesProfile;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.value.Attenuation;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;

/**
 * Converter from glTF to a scene: nodes become groups and shapes; cameras and punctual lights become their closest
 * equivalents.
 */
final class GltfImport {
    /** Minimum distance of the target from a camera among the objects, as a share of their radius. */
    private static final double MIN_TARGET_DISTANCE = 0.2;

    /** Spots with a larger ratio of the inner to the outer angle have a hard edge. */
    private static final double MAX_INNER_RATIO = 0.9999;

    private final SceneAssembler assembler;
    private final SpotEdges spotEdges = new SpotEdges();
    private final LightUnits units;
    private final GltfScene file;
    private final List<GltfNode> nodes;
    private final List<GltfLight> lights;
    private final Map<Integer, List<GltfPart>> parts = new HashMap<>();
    private final List<String> materials = new ArrayList<>();
    private final List<GltfNode> lightNodes = new ArrayList<>();
    private final List<Transform> lightTransforms = new ArrayList<>();
    /** Names in the scene of the file's nodes; the first node of a name represents all. */
    private final Map<String, String> nodeNames = new HashMap<>();
    private final SceneExtras extras;
    private final GltfCameras cameras;
    private final String meshFile;
    private final PosedMeshes posed;
    /** File of the posed meshes; empty if there are none. */
    private final String posedFile;
    /** Animation of the file; empty if there is none. */
    private final Optional<GltfShot> shot;
    /** Node of the scene's camera; empty if it is not of the file. */
    private Optional<GltfNode> cameraNode = Optional.empty();

    /** @param content file with the glTF; the source itself, or what it was converted to */
    private GltfImport(Path source, Path content, Path sceneFile, ImportOptions options, Progress progress)
            throws IOException, MeshException {
        assembler = new SceneAssembler(source, sceneFile);
        GltfFile gltf = GltfFile.read(content, progress);
        units = options.units().orElseGet(() -> LightUnits.writtenBy(gltf.generator()));
        file = new GltfScene(gltf, assembler.notes);
        nodes = file.nodes(SceneLimits.MAX_SHAPES);
        var variants = new MaterialVariants(gltf, options.variants().isEmpty() ? "" : options.variants().getFirst());
        variants.noteNames(assembler.notes);
        for (GltfPart part : GltfMeshReader.readAll(gltf, assembler.notes)) {
            parts.computeIfAbsent(part.mesh(), _ -> new ArrayList<>()).add(variants.part(part, assembler.notes));
        }
        posed = PosedMeshes.of(gltf, nodes, parts);
        lights = file.lights();
        extras = new SceneExtras(file.settings());
        cameras = new GltfCameras(gltf, nodes, options.camera(), extras.camera());
        if (parts.isEmpty() && lights.isEmpty() && gltf.cameraCount() == 0) {
            throw new MeshException(source, "meshes", "must have triangles, lights or cameras");
        }
        meshFile = parts.isEmpty() ? source.getFileName().toString() : content.equals(source) ? assembler.addFile(source)
                : assembler.addFile(assembler.stem() + ".glb", RegularFile.readBytes(content, "a converted file", Integer.MAX_VALUE - 8));
        posedFile =
                posed.meshes().isEmpty() ? "" : assembler.addFile(assembler.stem() + ".posed.glb", MeshFileWriter.write(posed.meshes()));
        shot = extras.hasShot() ? Optional.empty() : shot(gltf, progress);
        assembler.notes.add("animations", extras.hasShot() ? file.animationCount() : 0);
        for (Path buffer : parts.isEmpty() ? Set.<Path>of() : file.bufferFiles()) {
            assembler.addFileAsNamed(buffer);
        }
    }

    static ImportedScene read(Path source, Path sceneFile, ImportOptions options, Progress progress) throws IOException, MeshException {
        return new GltfImport(source, source, sceneFile, options, progress).assemble();
    }

    /**
     * Reads a file that was converted to glTF.
     *
     * @param content the converted file, which may be deleted afterwards
     * @param losses number of things of each kind that it lacks
     */
    static ImportedScene readConverted(Path source, Path content, Map<String, Integer> losses, Path sceneFile, ImportOptions options,
            Progress progress) throws IOException, MeshException {
        var converted = new GltfImport(source, content, sceneFile, options, progress);
        losses.forEach(converted.assembler.notes::add);
        return converted.assemble();
    }

    private Optional<GltfShot> shot(GltfFile gltf, Progress progress) throws IOException, MeshException {
        Optional<GltfAnimation> animation = GltfAnimation.read(gltf, assembler.notes);
        Optional<GltfShot> result = animation.map(a -> new GltfShot(assembler, a, nodes, progress));
        if (result.isPresent()) {
            assembler.notes.add("moving skins and morph targets, posed as the file has them",
                    animation.get().morphCount() + file.movingSkinCount(nodes, result.get()::moves));
        }
        return result;
    }

    private ImportedScene assemble() throws IOException, MeshException {
        var surfaces = new GltfMaterialImport(assembler, file, meshFile);
        for (GltfMaterial material : file.materials()) {
            Material converted = surfaces.convert(material);
            String name = assembler.addMaterial(material.name(), converted);
            materials.add(name);
            if (!material.isUnlit() && !converted.glow().isBlack()) {
                assembler.rawGlows.add(name);
            }
        }
        for (GltfNode node : nodes) {
            assembler.nodes.addAll(importNode(node, Transform.IDENTITY));
        }
        var settings = new LightSettings(assembler);
        for (int i = 0; i < lightNodes.size(); i++) {
            importLight(lightNodes.get(i), lightTransforms.get(i), settings);
        }
        spotEdges.addFiles(assembler);
        Optional<Camera> shown = assembler.camera;
        assembler.camera = shown.map(camera -> withExtras(camera, assembler.notes));
        cameras.forEach((name, camera) -> assembler.addCamera(name, shown.filter(s -> s == camera).flatMap(_ -> assembler.camera)
                .orElseGet(() -> withTarget(camera, distanceToObjects(camera)))));
        if (shot.isPresent()) {
            double fov = cameraNode.isEmpty() ? 0 : fieldOfView(file.camera(cameraNode.get().camera(), new ConversionNotes()));
            // The camera without animation has the notes already.
            shot.get().finish(cameraNode, fov, (world, angle) -> withExtras(camera(world, angle), new ConversionNotes()));
        }
        assembler.units = assembler.lights.isEmpty() ? Optional.empty() : Optional.of(units);
        List<Material> before = List.copyOf(assembler.materials);
        extras.apply(assembler, nodeNames);
        for (int i = 0; i < before.size(); i++) {
            if (!before.get(i).glow().equals(assembler.materials.get(i).glow())) {
                assembler.rawGlows.remove(before.get(i).name());
            }
        }
        return assembler.build();
    }

    /** Converts a node with its descendants; empty if it shows nothing. */
    private List<SceneNode> importNode(GltfNode node, Transform parentTransform) throws MeshException {
        Optional<Transform> later = shot.flatMap(s -> s.laterTransform(node));
        Transform local = later.orElse(node.local());
        Transform world = parentTransform.times(local);
        if (node.camera() >= 0) {
            importCamera(node, world);
        }
        if (node.light() >= 0) {
            lightNodes.add(node);
            lightTransforms.add(world);
        }
        List<Placement> placements = TransformDecomposition.decompose(local);
        List<GltfPart> posedParts = posed.parts(node);
        if (node.skin() >= 0 && !posedParts.isEmpty()) {
            // The joints place a skinned mesh, and its node does not.
            for (GltfPart part : posedParts) {
                assembler.nodes.add(createShape(node.name(), posedFile, part, Placement.IDENTITY, Transform.IDENTITY));
            }
        }
        List<GltfPart> nodeParts = node.mesh() < 0 || node.skin() >= 0 ? List.of()
                : posedParts.isEmpty() ? parts.getOrDefault(node.mesh(), List.of()) : posedParts;
        String file = posedParts.isEmpty() ? meshFile : posedFile;
        if (placements.isEmpty()) {
            assembler.notes.add("nodes that are flat, too small or too large, with their objects", nodeParts.isEmpty() ? 0 : 1);
            // Cameras and lights inside the node are imported anyway.
            for (GltfNode child : node.children()) {
                assembler.notes.add("objects inside nodes that are flat, too small or too large", importNode(child, world).size());
            }
            return List.of();
        }
        if (nodeParts.size() == 1 && node.children().isEmpty()) {
            Transform outerTransform = placements.size() == 1 ? parentTransform : parentTransform.times(placements.getFirst().transform());
            SceneNode shape = createShape(node.name(), file, nodeParts.getFirst(), placements.getLast(), outerTransform);
            nodeNames.putIfAbsent(node.name(), shape.name());
            return animated(node, wrapInGroups(node, "", placements.subList(0, placements.size() - 1), List.of(shape)), later.isPresent());
        }
        // The group gets the node's name before its parts do, so that links and keyframes of the node find it.
        String groupName = nodeParts.isEmpty() ? "" : assembler.names.unique(node.name(), "group");
        List<SceneNode> children = new ArrayList<>();
        for (GltfPart part : nodeParts) {
            children.add(createShape(node.name(), file, part, Placement.IDENTITY, world));
        }
        for (GltfNode child : node.children()) {
            children.addAll(importNode(child, world));
        }
        if (children.isEmpty()) {
            return List.of();
        }
        List<SceneNode> group = wrapInGroups(node, groupName, placements, children);
        nodeNames.putIfAbsent(node.name(), group.getFirst().name());
        return animated(node, group, later.isPresent());
    }

    /**
     * Returns a node's only shape or group after it was added to what moves.
     *
     * @param isHidden true if it is hidden without animation
     */
    private List<SceneNode> animated(GltfNode node, List<SceneNode> shown, boolean isHidden) {
        List<SceneNode> result = isHidden ? List.of(shown.getFirst().withVisible(false)) : shown;
        shot.ifPresent(s -> s.addNode(node, result.getFirst()));
        return result;
    }

    /**
     * Wraps nodes in one group for each placement, outermost first.
     *
     * @param outermost name of the outermost group; empty for a new one
     */
    private List<SceneNode> wrapInGroups(GltfNode node, String outermost, List<Placement> placements, List<SceneNode> children) {
        List<SceneNode> nodes = children;
        for (int i = placements.size() - 1; i >= 0; i--) {
            String name = i == 0 && !outermost.isEmpty() ? outermost : assembler.names.unique(node.name(), "group");
            nodes = List.of(new NodeGroup(name, placements.get(i), nodes));
        }
        return nodes;
    }

    private SceneNode createShape(String nodeName, String file, GltfPart part, Placement placement, Transform outer) {
        assembler.notes.add("objects without a material, imported as gray", part.material() < 0 ? 1 : 0);
        String material = part.material() < 0 ? Material.DEFAULT.name() : materials.get(part.material());
        return assembler.createShape(nodeName.isEmpty() ? part.name() : nodeName, file, part.name(), part.triangles(), material,
                placement, outer);
    }

    private void importCamera(GltfNode node, Transform world) throws MeshException {
        GltfCamera gltfCamera = file.camera(node.camera(), assembler.notes);
        if (gltfCamera.fieldOfView().isEmpty()) {
            assembler.notes.add("orthographic cameras, imported as perspective");
        }
        try {
            Camera camera = camera(world, fieldOfView(gltfCamera));
            cameras.add(node, camera);
            if (assembler.camera.isEmpty() && cameras.isCandidate(node)) {
                assembler.camera = Optional.of(camera);
                cameraNode = Optional.of(node);
                gltfCamera.aspectRatio().ifPresent(assembler::setAspectRatio);
            } else {
                assembler.notes.add("animations of additional cameras", shot.filter(s -> s.movesCamera(node)).isPresent() ? 1 : 0);
            }
        } catch (RefusalException | ArithmeticException e) {
            assembler.notes.add("cameras that cannot be placed");
        }
    }

    /** Returns the vertical field of view in radians. */
    private static double fieldOfView(GltfCamera camera) {
        return camera.fieldOfView().orElse(Math.toRadians(Camera.DEFAULT.fov()));
    }

    private static Camera camera(Transform world, double fieldOfView) {
        Vec3 from = world.transformPoint(Vec3.ZERO);
        Vec3 view = world.transformVector(new Vec3(0, 0, -1));
        Vec3 up = world.transformVector(Vec3.Y);
        double fov = Math.clamp(Math.toDegrees(fieldOfView), SceneLimits.MIN_FOV, SceneLimits.MAX_FOV);
        return new Camera(from, from.plus(view.normalized()), up.normalized(), fov);
    }

    /**
     * Returns the shown camera with its target as far as the objects, or at the distance that the file gives: a glTF camera has a direction
     * only. New lights take their size from this distance. Shift and lens are those that the file gives.
     */
    private Camera withExtras(Camera camera, ConversionNotes notes) {
        Camera aimed = withTarget(camera, extras.cameraDistance().orElseGet(() -> distanceToObjects(camera)));
        return extras.withLens(aimed.withShift(extras.cameraShift(notes)), notes);
    }

    private double distanceToObjects(Camera camera) {
        double along = assembler.bounds.center().minus(camera.from()).dot(camera.to().minus(camera.from()));
        return Math.max(along, MIN_TARGET_DISTANCE * assembler.bounds.radius());
    }

    /** Returns the camera with its target at a distance, if it can be there. */
    private static Camera withTarget(Camera camera, double distance) {
        try {
            return camera.withView(camera.from(), camera.from().plus(camera.to().minus(camera.from()).times(distance)), camera.up());
        } catch (RefusalException | ArithmeticException e) {
            return camera;
        }
    }

    private void importLight(GltfNode node, Transform world, LightSettings settings) {
        GltfLight light = lights.get(node.light());
        LightType type = switch (light.type()) {
            case DIRECTIONAL -> LightType.DIRECTIONAL;
            case POINT -> LightType.POINT;
            case SPOT -> LightType.SPOT;
        };
        String name = node.name().isEmpty() ? light.name() : node.name();
        try {
            double quadratic = type.hasPosition() ? assembler.quadraticAttenuation() : 1;
            Light result =
                    Light.of(assembler.names.unique(name, "light"), type)
                            .withColor(assembler.clampColor(light.color(), 1000, "colors of lights"))
                            .withIntensity(Math.min(light.intensity() * quadratic, SceneLimits.MAX_INTENSITY));
            if (type.hasPosition()) {
                result = result.withPosition(world.transformPoint(Vec3.ZERO)).withAttenuation(new Attenuation(0, 0, quadratic));
                assembler.notes.add("ranges of lights", light.hasRange() ? 1 : 0);
            }
            if (type.hasDirection()) {
                result = result.withDirection(world.transformVector(new Vec3(0, 0, -1)).normalized());
            }
            if (type.hasCone()) {
                result = withEdge(result.withAngle(Math.toDegrees(light.outerAngle())).withDropoff(0), light);
            }
            assembler.lights.add(settings.restore(result, light));
            shot.ifPresent(s -> s.addLight(assembler.lights.getLast(), node, light, quadratic));
            boolean isClamped =
                    light.intensity() * quadratic > SceneLimits.MAX_INTENSITY && !assembler.restoredLights.contains(result.name());
            assembler.notes.add("intensities of lights beyond 1e30", isClamped ? 1 : 0);
        } catch (RefusalException | ArithmeticException e) {
            assembler.notes.add("lights that cannot be placed");
        }
    }

    /** Adds the soft edge of a spot; a hard one if the angles are nearly equal. */
    private Light withEdge(Light spot, GltfLight light) {
        double inner = Math.toDegrees(light.innerAngle());
        if (!(inner >= 0 && inner < spot.angle() * MAX_INNER_RATIO) || spot.angle() > 90) {
            return spot;
        }
        Optional<IesProfile> profile = spotEdges.profile(inner, spot.angle());
        assembler.notes.add("soft edges of spots after the first " + JenLimits.PROFILES, profile.isEmpty() ? 1 : 0);
        return spot.withProfile(profile);
    }
}
