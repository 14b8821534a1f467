package lightning.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.gltf.GltfFile;
import lightning.gltf.GltfLight;
import lightning.gltf.GltfMaterial;
import lightning.gltf.GltfMeshes;
import lightning.gltf.GltfNode;
import lightning.gltf.GltfPart;
import lightning.gltf.GltfScene;
import lightning.math.Rgb;
import lightning.math.Transform;
import lightning.math.Vec3;
import lightning.mesh.MeshException;
import lightning.scene.Attenuation;
import lightning.scene.Camera;
import lightning.scene.Group;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Placement;
import lightning.scene.Relief;
import lightning.scene.TextureMap;
import lightning.work.Progress;

/** Makes a scene of a glTF file: nodes become groups and shapes, cameras, punctual lights and materials their nearest here. */
final class GltfImport {
    private final Pieces pieces;
    private final LightUnits units;
    private final GltfScene file;
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
        for (GltfMaterial material : file.materials()) {
            materials.add(pieces.material(material.name(), material(material)));
        }
        for (GltfNode node : file.nodes()) {
            pieces.nodes.addAll(placed(node, Transform.IDENTITY));
        }
        for (int i = 0; i < lit.size(); i++) {
            light(lit.get(i), litAt.get(i));
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
        String material = part.material() < 0 ? Material.DEFAULT.name() : materials.get(part.material());
        return pieces.shape(node.isEmpty() ? part.name() : node, meshFile, part.name(), part.triangles(), material, placement, outer);
    }

    private void camera(int index, Transform world) throws MeshException {
        Vec3 from = world.point(Vec3.ZERO);
        Vec3 view = world.vector(new Vec3(0, 0, -1));
        Vec3 up = world.vector(Vec3.Y);
        Optional<Double> angle = file.fieldOfView(index);
        if (pieces.camera.isPresent()) {
            pieces.notes.add("other cameras");
            return;
        }
        if (angle.isEmpty()) {
            pieces.notes.add("cameras without perspective, shown with it");
        }
        double fov = Math.clamp(Math.toDegrees(angle.orElse(Math.toRadians(Camera.DEFAULT.fov()))), Limits.MIN_FOV, Limits.MAX_FOV);
        try {
            pieces.camera = Optional.of(new Camera(from, from.plus(view.normalized()), up.normalized(), fov));
        } catch (IllegalArgumentException | ArithmeticException e) {
            pieces.notes.add("cameras that cannot be placed");
        }
    }

    private void light(GltfNode node, Transform world) {
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
                    Light.of(pieces.names.unique(wanted, "light"), type).withColor(pieces.color(light.color(), 1000, "colors of lights"))
                            .withIntensity(light.intensity() * quadratic);
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
            pieces.lights.add(made);
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

    /**
     * The nearest that Phong's model has. A roughness r is a lobe of exponent (2 / r⁴ − 2) / 4: that of Blinn's model with the same
     * width at its top (Walter and others, Microfacet models for refraction, 2007, §5.2), a quarter for the angle to the mirrored
     * direction. Its height is that of the lobe head on, at most 1. Metals mirror as (1 − r)².
     */
    private Material material(GltfMaterial m) throws IOException, MeshException {
        double metallic = Pieces.clamp(m.metallic(), 1);
        double roughness = Pieces.clamp(m.roughness(), 1);
        Rgb base = pieces.color(m.base(), 1, "base colors of materials");
        Rgb emission = pieces.color(m.emission(), Limits.MAX_EMISSION, "emission of materials");
        Material made = Material.of("material");
        if (m.unlit()) {
            made = made.withAmbient(base).withDiffuse(Rgb.BLACK);
            pieces.notes.add("textures of unlit materials", m.image() < 0 ? 0 : 1);
            return made;
        }
        double blinn = Math.min(2 / Math.pow(Math.max(roughness, 0.03), 4) - 2, 4 * Limits.MAX_SHININESS);
        double height = (blinn + 2) / 8;
        Rgb headOn = mix(m.reflection(), base, metallic);
        Rgb specular = roughness == 1 ? Rgb.BLACK
                : new Rgb(Pieces.clamp(headOn.r() * height, 1), Pieces.clamp(headOn.g() * height, 1), Pieces.clamp(headOn.b() * height, 1));
        double mirror = metallic * (1 - roughness) * (1 - roughness);
        made = made.withAmbient(emission).withDiffuse(base.times(1 - mirror)).withSpecular(specular)
                .withShininess(specular.isBlack() ? made.shininess() : Math.rint(100 * blinn / 4) / 100).withReflective(base.times(mirror));
        pieces.notes.add("metallic and rough materials, shown by Phong's model");
        return relieved(made.withTexture(picture(m.image())), m);
    }

    private static Rgb mix(Rgb a, Rgb b, double share) {
        return new Rgb(a.r() + share * (b.r() - a.r()), a.g() + share * (b.g() - a.g()), a.b() + share * (b.b() - a.b()));
    }

    private final Map<Integer, Optional<String>> images = new HashMap<>();

    private Optional<TextureMap> picture(int image) throws IOException, MeshException {
        if (image >= 0 && !images.containsKey(image)) {
            images.put(image, image(image));
        }
        return image < 0 ? Optional.empty() : images.get(image).flatMap(Pieces::texture);
    }

    private Material relieved(Material material, GltfMaterial m) throws IOException, MeshException {
        Optional<TextureMap> normals = picture(m.normals());
        return normals.isEmpty() ? material : material.withRelief(Relief.NONE.withNormals(normals)
                .withStrength(Math.clamp(m.lean(), -Limits.MAX_STRENGTH, Limits.MAX_STRENGTH)));
    }

    /** The name of an image's file; empty where it is none that can be shown. */
    private Optional<String> image(int image) throws IOException, MeshException {
        Optional<Path> path = file.imageFile(image);
        if (path.isPresent()) {
            if (Pieces.isPicture(path.get())) {
                return Optional.of(pieces.name(path.get()));
            }
        } else {
            byte[] bytes = file.imageBytes(image);
            if (Pieces.isPicture(bytes)) {
                String name = file.imageName(image);
                String stem = meshFile.replaceFirst("\\.[^.]*$", "") + "-" + (name.isEmpty() ? "image" + image : name);
                return Optional.of(pieces.name(stem + (bytes[1] == 'P' ? ".png" : ".jpg"), bytes));
            }
        }
        pieces.notes.add("textures that are no PNG or JPEG");
        return Optional.empty();
    }
}
