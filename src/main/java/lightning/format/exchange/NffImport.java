package lightning.format.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.text.RefusalException;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.Bounds;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.exchange.assembly.TransformDecomposition;
import lightning.format.exchange.assembly.TransmissionImport;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.MeshException;
import lightning.format.nff.NffFile;
import lightning.format.nff.NffReader;
import lightning.format.nff.NffSolid;
import lightning.scene.Camera;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;

/**
 * Converter from NFF to a scene: spheres and cones become solids; polygons and patches remain in the source file and become
 * meshes.
 */
final class NffImport {
    private final SceneAssembler assembler;
    private final NffFile file;
    private final String meshFile;
    private final List<String> materialNames = new ArrayList<>();

    private NffImport(Path source, Path sceneFile, Progress progress) throws IOException, MeshException {
        assembler = new SceneAssembler(source, sceneFile);
        try (ByteSource bytes = ByteSource.openText(source, progress)) {
            file = NffReader.read(bytes, assembler.notes);
        }
        meshFile = file.meshes().isEmpty() ? "" : assembler.addFile(source);
    }

    static ImportedScene read(Path source, Path sceneFile, Progress progress) throws IOException, MeshException {
        return new NffImport(source, sceneFile, progress).assemble();
    }

    private ImportedScene assemble() throws IOException, MeshException {
        assembler.world =
                assembler.world.withBackground(assembler.clampColor(file.background(), SceneLimits.MAX_EMISSION, "background colors"));
        file.view().ifPresent(this::importCamera);
        for (NffFile.Fill fill : file.fills()) {
            materialNames.add(assembler.addMaterial("fill", convertFill(fill)));
        }
        for (NffSolid solid : file.solids()) {
            importSolid(solid).ifPresentOrElse(assembler.nodes::add,
                    () -> assembler.notes.add("objects that are flat, too small or too large"));
        }
        for (NffFile.Surface surface : file.meshes()) {
            assembler.nodes
                    .add(assembler.createShape(surface.name(), meshFile, surface.name(), surface.mesh(), materialName(surface.fill()),
                            Placement.IDENTITY, Transform.IDENTITY));
        }
        file.lights().forEach(this::importLight);
        return assembler.build();
    }

    private void importCamera(NffFile.View view) {
        try {
            assembler.camera = Optional.of(new Camera(view.from(), view.at(), view.up(),
                    Math.clamp(view.angle(), SceneLimits.MIN_FOV, SceneLimits.MAX_FOV)));
        } catch (RefusalException e) {
            assembler.notes.add("cameras that cannot be placed");
        }
        if (view.width() > 0 && view.height() > 0 && Math.max(view.width(), view.height()) <= SceneLimits.MAX_SIZE) {
            assembler.picture = assembler.picture.withSize(view.width(), view.height());
        }
    }

    private String materialName(int fill) {
        return fill < 0 ? Material.DEFAULT.name() : materialNames.get(fill);
    }

    /**
     * Converts a fill. NFF reflects by Ks and adds all terms; here reflection and transmission reduce the diffuse term,
     * which is scaled up to compensate as far as its range allows.
     */
    private Material convertFill(NffFile.Fill fill) {
        double specular = SceneAssembler.clamp(fill.specular(), 1);
        double transmittance = SceneAssembler.clamp(fill.transmittance(), 1);
        double diffuseShare = (1 - specular) * (1 - transmittance);
        double diffuse = diffuseShare > 0 ? Math.min(fill.diffuse() / diffuseShare, Math.max(fill.diffuse(), 1)) : 0;
        assembler.notes.add("fills with Ks beyond 0 to 1", specular == fill.specular() ? 0 : 1);
        Material opaque =
                Material.of("material").withDiffuse(assembler.clampColor(fill.color().times(diffuse), 1, "diffuse colors of fills"))
                        .withSpecular(Rgb.gray(specular)).withReflective(Rgb.gray(specular))
                        .withShininess(SceneAssembler.clamp(fill.shininess(), SceneLimits.MAX_SHININESS));
        return new TransmissionImport(assembler).withTransmission(opaque, transmittance, Rgb.WHITE, fill.ior(), false, 0);
    }

    private Optional<SceneNode> importSolid(NffSolid solid) {
        String material = materialName(solid.fill());
        try {
            return switch (solid) {
                case NffSolid.Sphere ball -> createShape(Solid.SPHERE, material,
                        new Transform(ball.radius(), 0, 0, ball.center().x(), 0, ball.radius(), 0, ball.center().y(), 0, 0, ball.radius(),
                                ball.center().z()));
                case NffSolid.Cone tube -> importCone(tube, material);
            };
        } catch (RefusalException | ArithmeticException e) {
            return Optional.empty();
        }
    }

    /** Converts a cone; the wider end becomes the base. */
    private Optional<SceneNode> importCone(NffSolid.Cone tube, String material) {
        boolean isFlipped = tube.apexRadius() > tube.baseRadius();
        Vec3 base = isFlipped ? tube.apex() : tube.base();
        double radius = Math.max(tube.baseRadius(), tube.apexRadius());
        double top = Math.min(tube.baseRadius(), tube.apexRadius()) / radius;
        Solid solid = top == 1 ? new Solid.Cylinder(false) : top > 0 ? new Solid.Frustum(top, false) : new Solid.Cone(false);
        Vec3 y = (isFlipped ? tube.base() : tube.apex()).minus(base);
        Vec3 axis = y.normalized();
        // Any perpendicular direction works; the coordinate axis with the smallest component is the most stable choice.
        boolean alongX = Math.abs(axis.x()) <= Math.min(Math.abs(axis.y()), Math.abs(axis.z()));
        Vec3 z = (alongX ? new Vec3(1, 0, 0) : Math.abs(axis.y()) <= Math.abs(axis.z()) ? Vec3.Y : new Vec3(0, 0, 1)).cross(axis)
                .normalized();
        Vec3 x = axis.cross(z);
        return createShape(solid, material, new Transform(radius * x.x(), y.x(), radius * z.x(), base.x(), radius * x.y(), y.y(),
                radius * z.y(), base.y(), radius * x.z(), y.z(), radius * z.z(), base.z()));
    }

    private Optional<SceneNode> createShape(Solid solid, String material, Transform transform) {
        List<Placement> placements = TransformDecomposition.decompose(transform);
        if (placements.size() != 1) {
            return Optional.empty();
        }
        assembler.bounds.add(Bounds.UNIT_CUBE, transform);
        return Optional.of(new Shape(solid, assembler.names.unique(solid.typeName(), "shape"), material, placements.getFirst()));
    }

    /**
     * Adds a light. NFF defines neither falloff nor the intensity of a light without color; its own generators write n
     * lights as white at 1 / √n each.
     */
    private void importLight(NffFile.Light light) {
        Rgb color = light.color().orElse(Rgb.WHITE);
        double intensity = light.color().isPresent() ? 1 : 1 / Math.sqrt(file.lights().size());
        try {
            assembler.lights.add(Light.of(assembler.names.unique("light", "light"), LightType.POINT)
                    .withColor(assembler.clampColor(color, SceneLimits.MAX_LIGHT_COLOR, "colors of lights")).withIntensity(intensity)
                    .withPosition(light.position()));
        } catch (RefusalException e) {
            assembler.notes.add("lights that cannot be placed");
        }
    }
}
