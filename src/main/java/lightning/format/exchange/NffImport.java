package lightning.format.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.MeshException;
import lightning.format.nff.NffFile;
import lightning.format.nff.NffReader;
import lightning.format.nff.NffSolid;
import lightning.scene.Camera;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Placement;
import lightning.scene.Shape;
import lightning.scene.Solid;

/** Makes a scene of an NFF file: balls and tubes become solids, polygons and patches are shown from the file itself. */
final class NffImport {
    private final Pieces pieces;
    private final NffFile file;
    private final String meshFile;
    private final List<String> fills = new ArrayList<>();

    private NffImport(Path source, Path to, Progress progress) throws IOException, MeshException {
        pieces = new Pieces(source, to);
        try (ByteSource bytes = ByteSource.open(source, progress)) {
            file = NffReader.read(bytes, pieces.notes);
        }
        meshFile = file.meshes().isEmpty() ? "" : pieces.name(source);
    }

    static Import read(Path source, Path to, Progress progress) throws IOException, MeshException {
        return new NffImport(source, to, progress).make();
    }

    private Import make() throws MeshException {
        pieces.world = pieces.world.withBackground(pieces.color(file.background(), Limits.MAX_EMISSION, "background colors"));
        file.view().ifPresent(this::view);
        for (NffFile.Fill fill : file.fills()) {
            fills.add(pieces.material("fill", material(fill)));
        }
        for (NffSolid solid : file.solids()) {
            shape(solid).ifPresentOrElse(pieces.nodes::add, () -> pieces.notes.add("shapes that are flat, too small or too large"));
        }
        for (NffFile.Surface surface : file.meshes()) {
            pieces.nodes.add(pieces.shape(surface.name(), meshFile, surface.name(), surface.mesh(), material(surface.fill()),
                    Placement.IDENTITY, Transform.IDENTITY));
        }
        file.lights().forEach(this::light);
        return pieces.finish();
    }

    private void view(NffFile.View view) {
        try {
            pieces.camera = Optional.of(new Camera(view.from(), view.at(), view.up(),
                    Math.clamp(view.angle(), Limits.MIN_FOV, Limits.MAX_FOV)));
        } catch (IllegalArgumentException e) {
            pieces.notes.add("cameras that cannot be placed");
        }
        if (view.width() > 0 && view.height() > 0 && Math.max(view.width(), view.height()) <= Limits.MAX_SIZE) {
            pieces.picture = pieces.picture.withSize(view.width(), view.height());
        }
    }

    private String material(int fill) {
        return fill < 0 ? Material.DEFAULT.name() : fills.get(fill);
    }

    /** The format mirrors by Ks and adds all; here what is mirrored, and what goes through, takes its share from the diffuse light, which is given back first as far as a surface can have it. */
    private Material material(NffFile.Fill fill) {
        double mirror = Pieces.clamp(fill.specular(), 1);
        double through = Pieces.clamp(fill.transmittance(), 1);
        double kept = (1 - mirror) * (1 - through);
        double diffuse = kept > 0 ? Math.min(fill.diffuse() / kept, Math.max(fill.diffuse(), 1)) : 0;
        pieces.notes.add("fills with Ks beyond 0 to 1", mirror == fill.specular() ? 0 : 1);
        Material opaque = Material.of("material").withDiffuse(pieces.color(fill.color().times(diffuse), 1, "diffuse colours of fills"))
                .withSpecular(Rgb.grey(mirror)).withReflective(Rgb.grey(mirror))
                .withShininess(Pieces.clamp(fill.shine(), Limits.MAX_SHININESS));
        return new SeeThrough(pieces).made(opaque, through, Rgb.WHITE, fill.index(), false, 0);
    }

    private Optional<Node> shape(NffSolid solid) {
        String material = material(solid.fill());
        try {
            return switch (solid) {
                case NffSolid.Ball ball -> placed(Solid.SPHERE, material,
                        new Transform(ball.radius(), 0, 0, ball.center().x(), 0, ball.radius(), 0, ball.center().y(), 0, 0, ball.radius(),
                                ball.center().z()));
                case NffSolid.Tube tube -> tube(tube, material);
            };
        } catch (IllegalArgumentException | ArithmeticException e) {
            return Optional.empty();
        }
    }

    /** The wider end is the base here. */
    private Optional<Node> tube(NffSolid.Tube tube, String material) {
        boolean turned = tube.apexRadius() > tube.baseRadius();
        Vec3 base = turned ? tube.apex() : tube.base();
        double radius = Math.max(tube.baseRadius(), tube.apexRadius());
        double top = Math.min(tube.baseRadius(), tube.apexRadius()) / radius;
        Solid solid = top == 1 ? new Solid.Cylinder(false) : top > 0 ? new Solid.Frustum(top, false) : new Solid.Cone(false);
        Vec3 y = (turned ? tube.base() : tube.apex()).minus(base);
        Vec3 axis = y.normalized();
        // Any direction across will do; the one along which the axis has least is farthest from it.
        boolean alongX = Math.abs(axis.x()) <= Math.min(Math.abs(axis.y()), Math.abs(axis.z()));
        Vec3 z = (alongX ? new Vec3(1, 0, 0) : Math.abs(axis.y()) <= Math.abs(axis.z()) ? Vec3.Y : new Vec3(0, 0, 1)).cross(axis)
                .normalized();
        Vec3 x = axis.cross(z);
        return placed(solid, material, new Transform(radius * x.x(), y.x(), radius * z.x(), base.x(), radius * x.y(), y.y(),
                radius * z.y(), base.y(), radius * x.z(), y.z(), radius * z.z(), base.z()));
    }

    private Optional<Node> placed(Solid solid, String material, Transform map) {
        List<Placement> places = Decomposition.of(map);
        if (places.size() != 1) {
            return Optional.empty();
        }
        pieces.bounds.add(Bounds.SOLID, map);
        return Optional.of(new Shape(solid, pieces.names.unique(solid.noun(), "shape"), material, places.getFirst()));
    }

    /**
     * The format says neither how lights fall off nor how strong one is that has no colour: as its own generators write them, n
     * lights are white at 1 / √n each.
     */
    private void light(NffFile.Light light) {
        Rgb color = light.color().orElse(Rgb.WHITE);
        double alone = light.color().isPresent() ? 1 : 1 / Math.sqrt(file.lights().size());
        try {
            pieces.lights.add(Light.of(pieces.names.unique("light", "light"), LightType.POINT)
                    .withColor(pieces.color(color, Limits.MAX_LIGHT_COLOR, "colours of lights")).withIntensity(alone)
                    .withPosition(light.at()));
        } catch (IllegalArgumentException e) {
            pieces.notes.add("lights that cannot be placed");
        }
    }
}
