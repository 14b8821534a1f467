package lightning.format.exchange;

import java.io.IOException;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import lightning.base.file.OrdinaryFile;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.text.Decimal;
import lightning.base.text.Visible;
import lightning.format.jen.FileKind;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.Notes;
import lightning.format.mesh.PartNames;
import lightning.scene.Bank;
import lightning.scene.Camera;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Material;
import lightning.scene.Mesh;
import lightning.scene.Node;
import lightning.scene.Picture;
import lightning.scene.Placement;
import lightning.scene.Rig;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.Solid;
import lightning.scene.Stage;
import lightning.scene.Texture;
import lightning.scene.TextureMap;
import lightning.scene.World;

/** The pieces of a scene in the making: materials, shapes, lights, and the files that go with it. */
final class Pieces {
    private static final Pattern NOT_ALLOWED = Pattern.compile("[^\\p{L}\\p{N} _.,()+-]");
    private static final int LONGEST_FILE_NAME = 100;
    /** How far a light must be from a surface not to be cut, as a share of the scene's size. */
    private static final double NEAR = 0.05;

    final Notes notes = new Notes();
    final PartNames names = new PartNames();
    final List<Node> nodes = new ArrayList<>();
    final List<Material> materials = new ArrayList<>();
    final List<Light> lights = new ArrayList<>();
    final List<Bank> banks = new ArrayList<>();
    /** Lights whose intensities are not numbers of the file. */
    final Set<String> restored = new HashSet<>();
    final Bounds bounds = new Bounds();
    Optional<Camera> camera = Optional.empty();
    Picture picture = new Picture(800, 600, Picture.DEPTH.initial());
    World world = World.DEFAULT;
    /** What the numbers of the lights are, where the file does not say it. */
    Optional<LightUnits> units = Optional.empty();
    private final Path source;
    private final Path to;
    private final PartNames materialNames = new PartNames();
    private final Map<Path, Import.Copy> copies = new HashMap<>();
    private final List<String> remarks = new ArrayList<>();
    private final Map<Mesh, Bounds> boxes = new IdentityHashMap<>();

    Pieces(Path source, Path to) {
        this.source = source;
        this.to = to;
        materialNames.unique(Material.DEFAULT.name(), "");
        remarks.add("imported from " + Visible.escaped(String.valueOf(source.getFileName())));
    }

    /** A line that the scene's file begins with. */
    void remark(String line) {
        remarks.add(line);
    }

    Path folder() {
        return to.toAbsolutePath().getParent();
    }

    /** The name by which the scene can name a file of the source's folder, which is copied where it does not lie beside the scene. */
    String name(Path file) {
        Path from = source.toAbsolutePath().normalize().getParent();
        Path absolute = file.toAbsolutePath().normalize();
        Path relative = absolute.startsWith(from) ? from.relativize(absolute) : absolute.getFileName();
        List<String> parts = new ArrayList<>();
        relative.forEach(part -> parts.add(allowed(part.toString())));
        String name = String.join("/", parts);
        copy(name, file, null);
        return name;
    }

    /** The name of a file that is not yet one. */
    String name(String wanted, byte[] bytes) {
        String name = allowed(wanted);
        for (int i = 2; copies.containsKey(folder().resolve(name)); i++) {
            name = i + " " + allowed(wanted);
        }
        copy(name, null, bytes);
        return name;
    }

    /** Puts a file beside the scene under the name that the file beside it names it by. */
    void copyAsNamed(Path file) throws IOException {
        Path from = source.toRealPath().getParent();
        Path target = folder().resolve(from.relativize(file));
        copies.put(target, new Import.Copy(target, file, null));
    }

    private void copy(String name, Path file, byte[] bytes) {
        Path target = folder().resolve(name);
        copies.put(target, new Import.Copy(target, file, bytes));
    }

    private static String allowed(String name) {
        String shown = NOT_ALLOWED.matcher(name).replaceAll("_");
        String cut = shown.length() <= LONGEST_FILE_NAME ? shown : shown.substring(shown.length() - LONGEST_FILE_NAME);
        return cut.equals(".") || cut.equals("..") || cut.isEmpty() ? "_" : cut;
    }

    /** Adds a material, under a name that is free; returns that name. */
    String material(String wanted, Material like) {
        String name = materialNames.unique(wanted, "material");
        materials.add(like.withName(name));
        return name;
    }

    /** A picture, by the name of its file: what it holds is read with the scene. */
    static Optional<TextureMap> texture(String file) {
        return Optional.of(new TextureMap(file, 1, 1, new Texture(1, 1, new float[3])));
    }

    /** A shape that shows a mesh; it counts for the scene's size. */
    Shape shape(String wanted, String file, String part, Mesh mesh, String material, Placement placement, Transform outer) {
        bounds.add(boxes.computeIfAbsent(mesh, Bounds::of), outer.times(placement.transform()));
        return new Shape(new Solid.Triangles(file, part, mesh), names.unique(wanted, "mesh"), material, placement);
    }

    /** A colour within 0 and {@code most}; told where it was not. */
    Rgb color(Rgb c, double most, String what) {
        if (!(c.min() >= 0 && c.max() <= most)) {
            notes.add(what + " beyond 0 to " + Decimal.text(most));
        }
        return new Rgb(clamp(c.r(), most), clamp(c.g(), most), clamp(c.b(), most));
    }

    static double clamp(double v, double most) {
        return v >= 0 ? Math.min(v, most) : 0;
    }

    /**
     * The factor of a light's attenuation with the square of the distance: a power of 100, so that its light is not cut at 1 except
     * nearer to it than a twentieth of the scene's size. Its intensity is that much larger.
     */
    double quadratic() {
        double quadratic = 1;
        while (1 / Math.sqrt(quadratic) > NEAR * bounds.radius() && quadratic < 1e16) {
            quadratic *= 100;
        }
        return quadratic;
    }

    /** Gives the picture the shape of {@code aspectRatio}, width / height, above 0; its longer side stays. */
    void shape(double aspectRatio) {
        int longer = Math.max(picture.width(), picture.height());
        picture = picture.withSize(side(longer * aspectRatio, longer), side(longer / aspectRatio, longer));
    }

    private static int side(double pixels, int longest) {
        return (int) Math.rint(Math.clamp(pixels, 1, longest));
    }

    /** The scene, with a camera that sees all and a light, where it has none. */
    Import finish() throws MeshException {
        try {
            Camera seen = camera.orElseGet(this::view);
            if (lights.isEmpty()) {
                remark("it has no light: this one is made up");
                notes.add("lights made up, as the file has none");
                lights.add(overTheShoulder(seen));
            }
            Stage stage = new Stage(List.copyOf(materials), List.copyOf(nodes));
            Scene scene = new Scene(picture, seen, world, stage,
                    Rig.of(lights.stream().map(light -> linked(light, stage)).toList(), banks));
            return new Import(scene, Set.copyOf(restored), units, List.copyOf(remarks), to, List.copyOf(copies.values()),
                    Map.copyOf(notes.counts()));
        } catch (IllegalArgumentException e) {
            throw new MeshException(source, "", "cannot be a scene here: " + e.getMessage());
        }
    }

    /** A key light on the camera's side: from above and from its right. */
    private Light overTheShoulder(Camera seen) {
        Vec3 view = seen.to().minus(seen.from()).normalized();
        Vec3 right = view.cross(seen.up()).normalized();
        Vec3 to = view.times(1.5).minus(right.times(0.5)).minus(right.cross(view).times(0.8));
        return Light.of(names.unique("light", "light"), LightType.DIRECTIONAL)
                .withDirection(new Vec3(shortened(to.x(), 2), shortened(to.y(), 2), shortened(to.z(), 2)));
    }

    /** Without links to what the scene does not have. */
    private Light linked(Light light, Stage stage) {
        Light known = light.withIlluminates(light.illuminates().within(stage::hasNode))
                .withShadowedBy(light.shadowedBy().within(stage::hasNode));
        notes.add("lights linked to shapes that are not there", known.equals(light) ? 0 : 1);
        return known;
    }

    /** Whether the scene finds a file of a name where it will lie. */
    boolean finds(FileKind kind, String name) {
        try {
            return kind.find(folder(), name).isPresent();
        } catch (IOException | IllegalArgumentException e) {
            return false;
        }
    }

    private Camera view() {
        notes.add("cameras made up, as the file has none");
        double distance = bounds.radius() / Math.sin(Math.toRadians(20)) * 1.05;
        Vec3 middle = bounds.middle();
        return new Camera(shortened(middle.plus(new Vec3(0.5, 0.4, 0.9).normalized().times(distance))), shortened(middle), Vec3.Y, 40);
    }

    /** To the decimal place below a hundredth of the radius, as somebody would write it. */
    private Vec3 shortened(Vec3 v) {
        int place = 2 - (int) Math.floor(Math.log10(bounds.radius()));
        return new Vec3(shortened(v.x(), place), shortened(v.y(), place), shortened(v.z(), place));
    }

    private static double shortened(double v, int place) {
        return BigDecimal.valueOf(v).setScale(place, RoundingMode.HALF_EVEN).doubleValue();
    }

    /** Whether the bytes of a picture are of a kind that a scene can show. */
    static boolean isPicture(byte[] start) {
        return start.length > 3 && ((start[0] & 0xFF) == 0x89 && start[1] == 'P' || (start[0] & 0xFF) == 0xFF && (start[1] & 0xFF) == 0xD8);
    }

    static boolean isPicture(Path file) throws IOException {
        try (var in = OrdinaryFile.open(file, "a PNG or JPEG file")) {
            return isPicture(in.readNBytes(4));
        }
    }
}
