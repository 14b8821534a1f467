package lightning.format.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.gltf.GltfCamera;
import lightning.format.gltf.GltfFile;
import lightning.format.gltf.GltfLight;
import lightning.format.gltf.GltfMaterial;
import lightning.format.gltf.GltfMeshes;
import lightning.format.gltf.GltfNode;
import lightning.format.gltf.GltfPart;
import lightning.format.gltf.GltfScene;
import lightning.format.mesh.MeshException;
import lightning.scene.Attenuation;
import lightning.scene.Camera;
import lightning.scene.Group;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Placement;

/** Makes a scene of a glTF file: nodes become groups and shapes, cameras and punctual lights their nearest here. */
final class GltfImport {
    private final Pieces pieces;
    private final LightUnits units;
    private final GltfScene file;
    private final List<GltfNode> nodes;
    private final List<GltfLight> lights;
    private final Map<Integer, List<GltfPart>> parts = new HashMap<>();
    private final List<String> materials = new ArrayList<>();
    private final List<GltfNode> lit = new ArrayList<>();
    private final List<Transform> litAt = new ArrayList<>();
    private final String meshFile;

    private GltfImport(Path source, Path to, LightUnits units, Progress progress) throws IOException, MeshException {
        this.units = units;
        pieces = new Pieces(source, to);
        GltfFile gltf = GltfFile.read(source, progress);
        file = new GltfScene(gltf, pieces.notes);
        nodes = file.nodes(Limits.MAX_SHAPES);
        for (GltfPart part : GltfMeshes.read(gltf, pieces.notes)) {
            parts.computeIfAbsent(part.mesh(), _ -> new ArrayList<>()).add(part);
        }
        lights = file.lights();
        meshFile = pieces.name(source);
        for (Path buffer : file.bufferFiles()) {
            pieces.copyAsNamed(buffer);
        }
    }

    static Import read(Path source, Path to, LightUnits units, Progress progress) throws IOException, MeshException {
        return new GltfImport(source, to, units, progress).make();
    }

    private Import make() throws IOException, MeshException {
        var surfaces = new GltfSurfaces(pieces, file, meshFile);
        for (GltfMaterial material : file.materials()) {
            materials.add(pieces.material(material.name(), surfaces.material(material)));
        }
        for (GltfNode node : nodes) {
            pieces.nodes.addAll(placed(node, Transform.IDENTITY));
        }
        var settings = new LightSettings(pieces);
        for (int i = 0; i < lit.size(); i++) {
            light(lit.get(i), litAt.get(i), settings);
        }
        pieces.units = pieces.lights.isEmpty() ? Optional.empty() : Optional.of(units);
        return pieces.finish();
    }

    /** The node with all that is in it; nothing where it shows nothing. */
    private List<Node> placed(GltfNode node, Transform outer) throws MeshException {
        Transform world = outer.times(node.local());
        if (node.camera() >= 0) {
            camera(node.camera(), world);
        }
        if (node.light() >= 0) {
            lit.add(node);
            litAt.add(world);
        }
        List<Placement> places = Decomposition.of(node.local());
        List<GltfPart> own = node.mesh() < 0 ? List.of() : parts.getOrDefault(node.mesh(), List.of());
        if (places.isEmpty()) {
            pieces.notes.add("nodes that are flat, too small or too large, with their shapes", own.isEmpty() ? 0 : 1);
            // Cameras and lights inside it are looked for all the same.
            for (GltfNode child : node.children()) {
                pieces.notes.add("shapes inside nodes that are flat, too small or too large", placed(child, world).size());
            }
            return List.of();
        }
        if (own.size() == 1 && node.children().isEmpty()) {
            Transform around = places.size() == 1 ? outer : outer.times(places.getFirst().transform());
            return within(node, places.subList(0, places.size() - 1),
                    List.of(shape(node.name(), own.getFirst(), places.getLast(), around)));
        }
        List<Node> inside = new ArrayList<>();
        for (GltfPart part : own) {
            inside.add(shape(node.name(), part, Placement.IDENTITY, world));
        }
        for (GltfNode child : node.children()) {
            inside.addAll(placed(child, world));
        }
        return inside.isEmpty() ? List.of() : within(node, places, inside);
    }

    /** A group for each of the placements, the outermost first. */
    private List<Node> within(GltfNode node, List<Placement> places, List<Node> inside) {
        List<Node> nodes = inside;
        for (Placement place : places.reversed()) {
            nodes = List.of(new Group(pieces.names.unique(node.name(), "group"), place, nodes));
        }
        return nodes;
    }

    private Node shape(String node, GltfPart part, Placement placement, Transform outer) {
        pieces.notes.add("shapes without a material, grey here", part.material() < 0 ? 1 : 0);
        String material = part.material() < 0 ? Material.DEFAULT.name() : materials.get(part.material());
        return pieces.shape(node.isEmpty() ? part.name() : node, meshFile, part.name(), part.triangles(), material, placement, outer);
    }

    private void camera(int index, Transform world) throws MeshException {
        Vec3 from = world.point(Vec3.ZERO);
        Vec3 view = world.vector(new Vec3(0, 0, -1));
        Vec3 up = world.vector(Vec3.Y);
        GltfCamera look = file.camera(index);
        if (pieces.camera.isPresent()) {
            pieces.notes.add("other cameras");
            return;
        }
        if (look.fieldOfView().isEmpty()) {
            pieces.notes.add("cameras without perspective, shown with it");
        }
        double fov =
                Math.clamp(Math.toDegrees(look.fieldOfView().orElse(Math.toRadians(Camera.DEFAULT.fov()))), Limits.MIN_FOV, Limits.MAX_FOV);
        try {
            pieces.camera = Optional.of(new Camera(from, from.plus(view.normalized()), up.normalized(), fov));
            look.aspectRatio().ifPresent(pieces::shape);
        } catch (IllegalArgumentException | ArithmeticException e) {
            pieces.notes.add("cameras that cannot be placed");
        }
    }

    private void light(GltfNode node, Transform world, LightSettings settings) {
        GltfLight light = lights.get(node.light());
        LightType type = switch (light.type()) {
            case DIRECTIONAL -> LightType.DIRECTIONAL;
            case POINT -> LightType.POINT;
            case SPOT -> LightType.SPOT;
        };
        String wanted = node.name().isEmpty() ? light.name() : node.name();
        try {
            double quadratic = type.hasPosition() ? pieces.quadratic() : 1;
            Light made =
                    Light.of(pieces.names.unique(wanted, "light"), type).withColor(pieces.color(light.color(), 1000, "colours of lights"))
                            .withIntensity(Math.min(light.intensity() * quadratic, Limits.MAX_INTENSITY));
            if (type.hasPosition()) {
                made = made.withPosition(world.point(Vec3.ZERO)).withAttenuation(new Attenuation(0, 0, quadratic));
                pieces.notes.add("ranges of lights", light.ranged() ? 1 : 0);
            }
            if (type.hasDirection()) {
                made = made.withDirection(world.vector(new Vec3(0, 0, -1)).normalized());
            }
            if (type.hasCone()) {
                made = made.withAngle(Math.toDegrees(light.outer())).withDropoff(dropoff(light));
                pieces.notes.add("edges of spots, which fade otherwise here", light.inner() < light.outer() ? 1 : 0);
            }
            pieces.lights.add(settings.restored(made, light));
            boolean isCut = light.intensity() * quadratic > Limits.MAX_INTENSITY && !pieces.restored.contains(made.name());
            pieces.notes.add("intensities of lights beyond 1e30", isCut ? 1 : 0);
        } catch (IllegalArgumentException | ArithmeticException e) {
            pieces.notes.add("lights that cannot be placed");
        }
    }

    /**
     * The exponent with which a spot fades as the file's does where that is half as bright: in the file by the square of
     * (cos a − cos outer) / (cos inner − cos outer), here by a power of cos a.
     */
    private static double dropoff(GltfLight light) {
        double inner = Math.cos(light.inner());
        double outer = Math.cos(light.outer());
        double half = outer + Math.sqrt(0.5) * (inner - outer);
        double exponent = Math.log(0.5) / Math.log(half);
        return light.inner() < light.outer() && half > 0 && half < 1 ? Pieces.clamp(exponent, Limits.MAX_DROPOFF) : 0;
    }
}
