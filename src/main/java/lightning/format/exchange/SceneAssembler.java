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
import lightning.base.file.RegularFile;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.text.DecimalNumber;
import lightning.base.text.PrintableText;
import lightning.format.jen.FileKind;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.UniqueNames;
import lightning.scene.Camera;
import lightning.scene.Light;
import lightning.scene.LightGroup;
import lightning.scene.LightRig;
import lightning.scene.LightType;
import lightning.scene.Material;
import lightning.scene.Mesh;
import lightning.scene.PictureSettings;
import lightning.scene.Placement;
import lightning.scene.Scene;
import lightning.scene.SceneNode;
import lightning.scene.Shape;
import lightning.scene.Solid;
import lightning.scene.Stage;
import lightning.scene.Texture;
import lightning.scene.TextureMap;
import lightning.scene.World;

/** The pieces of a scene in the making: materials, shapes, lights, and the files that go with it. */
final class SceneAssembler {
    private static final Pattern DISALLOWED = Pattern.compile("[^\\p{L}\\p{N} _.,()+-]");
    private static final int MAX_FILE_NAME_LENGTH = 100;
    /** How far a light must be from a surface not to be cut, as a share of the scene's size. */
    private static final double MIN_LIGHT_DISTANCE = 0.05;

    final ConversionNotes notes = new ConversionNotes();
    final UniqueNames names = new UniqueNames();
    final List<SceneNode> nodes = new ArrayList<>();
    final List<Material> materials = new ArrayList<>();
    final List<Light> lights = new ArrayList<>();
    final List<LightGroup> lightGroups = new ArrayList<>();
    /** Lights whose intensities are not numbers of the file. */
    final Set<String> restoredLights = new HashSet<>();
    final Bounds bounds = new Bounds();
    Optional<Camera> camera = Optional.empty();
    PictureSettings picture = new PictureSettings(800, 600, PictureSettings.DEPTH.initial());
    World world = World.DEFAULT;
    /** What the numbers of the lights are, where the file does not say it. */
    Optional<LightUnits> units = Optional.empty();
    private final Path source;
    private final Path sceneFile;
    private final UniqueNames materialNames = new UniqueNames();
    private final Map<Path, ImportedScene.AssetCopy> copies = new HashMap<>();
    private final List<String> comments = new ArrayList<>();
    private final Map<Mesh, Bounds> meshBounds = new IdentityHashMap<>();

    SceneAssembler(Path source, Path sceneFile) {
        this.source = source;
        this.sceneFile = sceneFile;
        materialNames.unique(Material.DEFAULT.name(), "");
        comments.add("imported from " + PrintableText.escape(String.valueOf(source.getFileName())));
    }

    /** A line that the scene's file begins with. */
    void addComment(String line) {
        comments.add(line);
    }

    Path folder() {
        return sceneFile.toAbsolutePath().getParent();
    }

    /** The name by which the scene can name a file of the source's folder, which is copied where it does not lie beside the scene. */
    String addFile(Path file) {
        Path folder = source.toAbsolutePath().normalize().getParent();
        Path absolute = file.toAbsolutePath().normalize();
        Path relative = absolute.startsWith(folder) ? folder.relativize(absolute) : absolute.getFileName();
        List<String> parts = new ArrayList<>();
        relative.forEach(part -> parts.add(sanitize(part.toString())));
        String name = String.join("/", parts);
        addCopy(name, file, null);
        return name;
    }

    /** The name of a file that is not yet one. */
    String addFile(String requested, byte[] bytes) {
        String name = sanitize(requested);
        for (int i = 2; copies.containsKey(folder().resolve(name)); i++) {
            name = i + " " + sanitize(requested);
        }
        addCopy(name, null, bytes);
        return name;
    }

    /** Puts a file beside the scene under the name that the file beside it names it by. */
    void addFileAsNamed(Path file) throws IOException {
        Path folder = source.toRealPath().getParent();
        Path target = folder().resolve(folder.relativize(file));
        copies.put(target, new ImportedScene.AssetCopy(target, file, null));
    }

    private void addCopy(String name, Path file, byte[] bytes) {
        Path target = folder().resolve(name);
        copies.put(target, new ImportedScene.AssetCopy(target, file, bytes));
    }

    private static String sanitize(String name) {
        String sanitized = DISALLOWED.matcher(name).replaceAll("_");
        String shortened =
                sanitized.length() <= MAX_FILE_NAME_LENGTH ? sanitized : sanitized.substring(sanitized.length() - MAX_FILE_NAME_LENGTH);
        return shortened.equals(".") || shortened.equals("..") || shortened.isEmpty() ? "_" : shortened;
    }

    /** Adds a material, under a name that is free; returns that name. */
    String addMaterial(String requested, Material material) {
        String name = materialNames.unique(requested, "material");
        materials.add(material.withName(name));
        return name;
    }

    /** A picture, by the name of its file: what it holds is read with the scene. */
    static Optional<TextureMap> placeholderTexture(String file) {
        return Optional.of(new TextureMap(file, 1, 1, new Texture(1, 1, new float[3])));
    }

    /** A shape that shows a mesh; it counts for the scene's size. */
    Shape createShape(String requested, String file, String part, Mesh mesh, String material, Placement placement, Transform outer) {
        bounds.add(meshBounds.computeIfAbsent(mesh, Bounds::of), outer.times(placement.transform()));
        return new Shape(new Solid.TriangleMesh(file, part, mesh), names.unique(requested, "mesh"), material, placement);
    }

    /** A color within 0 and {@code max}; told where it was not. */
    Rgb clampColor(Rgb c, double max, String label) {
        if (!(c.min() >= 0 && c.max() <= max)) {
            notes.add(label + " beyond 0 to " + DecimalNumber.format(max));
        }
        return new Rgb(clamp(c.r(), max), clamp(c.g(), max), clamp(c.b(), max));
    }

    static double clamp(double v, double max) {
        return v >= 0 ? Math.min(v, max) : 0;
    }

    /**
     * The factor of a light's attenuation with the square of the distance: a power of 100, so that its light is not cut at 1 except
     * nearer to it than a twentieth of the scene's size. Its intensity is that much larger.
     */
    double quadraticAttenuation() {
        double quadratic = 1;
        while (1 / Math.sqrt(quadratic) > MIN_LIGHT_DISTANCE * bounds.radius() && quadratic < 1e16) {
            quadratic *= 100;
        }
        return quadratic;
    }

    /** Gives the picture the shape of {@code aspectRatio}, width / height, above 0; its longer side stays. */
    void setAspectRatio(double aspectRatio) {
        int longer = Math.max(picture.width(), picture.height());
        picture = picture.withSize(imageSide(longer * aspectRatio, longer), imageSide(longer / aspectRatio, longer));
    }

    private static int imageSide(double pixels, int longest) {
        return (int) Math.rint(Math.clamp(pixels, 1, longest));
    }

    /** The scene, with a camera that sees all and a light, where it has none. */
    ImportedScene build() throws MeshException {
        try {
            Camera view = camera.orElseGet(this::defaultCamera);
            if (lights.isEmpty()) {
                addComment("it has no light: this one is made up");
                notes.add("lights made up, as the file has none");
                lights.add(defaultLight(view));
            }
            Stage stage = new Stage(List.copyOf(materials), List.copyOf(nodes));
            Scene scene = new Scene(picture, view, world, stage,
                    LightRig.of(lights.stream().map(light -> withValidLinks(light, stage)).toList(), lightGroups));
            return new ImportedScene(scene, Set.copyOf(restoredLights), units, List.copyOf(comments), sceneFile,
                    List.copyOf(copies.values()),
                    Map.copyOf(notes.counts()));
        } catch (IllegalArgumentException e) {
            throw new MeshException(source, "", "cannot be a scene here: " + e.getMessage());
        }
    }

    /** A key light on the camera's side: from above and from its right. */
    private Light defaultLight(Camera shownCamera) {
        Vec3 view = shownCamera.to().minus(shownCamera.from()).normalized();
        Vec3 right = view.cross(shownCamera.up()).normalized();
        Vec3 direction = view.times(1.5).minus(right.times(0.5)).minus(right.cross(view).times(0.8));
        return Light.of(names.unique("light", "light"), LightType.DIRECTIONAL)
                .withDirection(new Vec3(round(direction.x(), 2), round(direction.y(), 2), round(direction.z(), 2)));
    }

    /** Without links to what the scene does not have. */
    private Light withValidLinks(Light light, Stage stage) {
        Light valid = light.withIlluminates(light.illuminates().retain(stage::hasNode))
                .withShadowedBy(light.shadowedBy().retain(stage::hasNode));
        notes.add("lights linked to shapes that are not there", valid.equals(light) ? 0 : 1);
        return valid;
    }

    /** Whether the scene finds a file of a name where it will lie. */
    boolean hasFile(FileKind kind, String name) {
        try {
            return kind.find(folder(), name).isPresent();
        } catch (IOException | IllegalArgumentException e) {
            return false;
        }
    }

    private Camera defaultCamera() {
        notes.add("cameras made up, as the file has none");
        double distance = bounds.radius() / Math.sin(Math.toRadians(20)) * 1.05;
        Vec3 middle = bounds.center();
        return new Camera(round(middle.plus(new Vec3(0.5, 0.4, 0.9).normalized().times(distance))), round(middle), Vec3.Y, 40);
    }

    /** To the decimal place below a hundredth of the radius, as somebody would write it. */
    private Vec3 round(Vec3 v) {
        int decimals = 2 - (int) Math.floor(Math.log10(bounds.radius()));
        return new Vec3(round(v.x(), decimals), round(v.y(), decimals), round(v.z(), decimals));
    }

    private static double round(double v, int decimals) {
        return BigDecimal.valueOf(v).setScale(decimals, RoundingMode.HALF_EVEN).doubleValue();
    }

    /** Whether the bytes of a picture are of a kind that a scene can show. */
    static boolean isPngOrJpeg(byte[] start) {
        return start.length > 3 && ((start[0] & 0xFF) == 0x89 && start[1] == 'P' || (start[0] & 0xFF) == 0xFF && (start[1] & 0xFF) == 0xD8);
    }

    static boolean isPngOrJpeg(Path file) throws IOException {
        try (var in = RegularFile.open(file, "a PNG or JPEG file")) {
            return isPngOrJpeg(in.readNBytes(4));
        }
    }
}
