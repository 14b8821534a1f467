package lightning.format.exchange.assembly;

import java.io.IOException;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.file.Files;
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
import java.util.stream.Stream;
import lightning.base.file.ParentFolder;
import lightning.base.file.RegularFile;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.text.DecimalNumber;
import lightning.base.text.PrintableText;
import lightning.base.text.RefusalException;
import lightning.format.jen.asset.FileKind;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.UniqueNames;
import lightning.scene.Camera;
import lightning.scene.Dome;
import lightning.scene.NamedCamera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.ViewCurve;
import lightning.scene.ViewSettings;
import lightning.scene.World;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.Mesh;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.shot.Shot;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/** Mutable builder of an imported scene: materials, shapes, lights, and the files to copy. */
public final class SceneAssembler {
    private static final Pattern DISALLOWED = Pattern.compile("[^\\p{L}\\p{N} _.,()+-]");
    private static final int MAX_FILE_NAME_LENGTH = 100;
    private static final int MAX_FILE_BYTES = 64 << 20;
    /** Minimum distance from a light to a surface without clamping, as a fraction of the scene's size. */
    private static final double MIN_LIGHT_DISTANCE = 0.05;

    public final ConversionNotes notes = new ConversionNotes();
    public final UniqueNames names = new UniqueNames();
    public final ImageImport images;
    public final List<SceneNode> nodes = new ArrayList<>();
    public final List<Material> materials = new ArrayList<>();
    public final List<Light> lights = new ArrayList<>();
    public final List<LightGroup> lightGroups = new ArrayList<>();
    /** Names of lights whose intensities are not raw numbers of the file. */
    public final Set<String> restoredLights = new HashSet<>();
    /** Names of materials whose glow is a raw number of the file. */
    public final Set<String> rawGlows = new HashSet<>();
    public final Bounds bounds = new Bounds();
    public Optional<Camera> camera = Optional.empty();
    private final List<NamedCamera> cameras = new ArrayList<>();
    private final UniqueNames cameraNames = new UniqueNames();
    /** With a view in which highlights do not clip, since a file does not say how its picture looks. */
    public PictureSettings picture = new PictureSettings(800, 600, PictureSettings.DEPTH.initial())
            .withView(ViewSettings.DEFAULT.withCurve(ViewCurve.AGX));
    public World world = World.DEFAULT;
    /** Assumed units of the lights' numbers, if the file does not define them. */
    public Optional<LightUnits> units = Optional.empty();
    /** True if the file defines all lights of the scene, even none. */
    public boolean isLit;
    /** Animation of the scene; empty if the file has none. */
    public Optional<Shot> shot = Optional.empty();
    /** Comment lines at the end of the scene file. */
    public final List<String> closingComments = new ArrayList<>();
    private final Path source;
    private final Path sceneFile;
    private final UniqueNames materialNames = new UniqueNames();
    private final Map<Path, AssetCopy> copies = new HashMap<>();
    private final List<String> comments = new ArrayList<>();
    private final Map<Mesh, Bounds> meshBounds = new IdentityHashMap<>();

    public SceneAssembler(Path source, Path sceneFile) {
        this.source = source;
        this.sceneFile = sceneFile;
        images = new ImageImport(this, source);
        materialNames.unique(Material.DEFAULT.name(), "");
        comments.add("imported from " + PrintableText.escape(String.valueOf(source.getFileName())));
    }

    /** Adds a comment line at the start of the scene file. */
    public void addComment(String line) {
        comments.add(line);
    }

    /** Adds a further environment; notes it if there are too many. */
    public void addDome(Dome dome) {
        if (world.named().size() == SceneLimits.MAX_DOMES) {
            notes.add("domes after the first " + SceneLimits.MAX_DOMES);
            return;
        }
        world = world.withNamed(Stream.concat(world.named().stream(), Stream.of(dome)).toList());
    }

    /** Returns the name of the scene file without its ending. */
    public String stem() {
        return sanitize(sceneFile.getFileName().toString().replaceFirst("\\.[^.]*$", ""));
    }

    Path folder() {
        return ParentFolder.of(sceneFile);
    }

    /** Adds a file of the source's folder, copied if it is not next to the scene; returns the name for the scene. */
    public String addFile(Path file) {
        Path folder = ParentFolder.of(source.toAbsolutePath().normalize());
        Path absolute = file.toAbsolutePath().normalize();
        Path relative = absolute.startsWith(folder) ? folder.relativize(absolute) : absolute.getFileName();
        List<String> parts = new ArrayList<>();
        relative.forEach(part -> parts.add(sanitize(part.toString())));
        String name = String.join("/", parts);
        addCopy(name, file, null);
        return name;
    }

    /**
     * Adds a file from anywhere: one of the source's folder by its place there, another by its content, since it may be temporary.
     *
     * @param requested name for a file of another folder
     */
    public String addFile(Path file, String requested) throws IOException {
        return isInFolder(file) ? addFile(file)
                : addFile(requested, RegularFile.readBytes(file, "a file that the scene uses", MAX_FILE_BYTES));
    }

    /** Returns whether {@link #addFile(Path, String)} accepts a file: one of the source's folder, or one that is not large. */
    public boolean canAdd(Path file) throws IOException {
        return isInFolder(file) || Files.size(file) <= MAX_FILE_BYTES;
    }

    private boolean isInFolder(Path file) {
        return file.toAbsolutePath().normalize().startsWith(ParentFolder.of(source.toAbsolutePath().normalize()));
    }

    /** Adds a file from memory; returns its name. */
    public String addFile(String requested, byte[] bytes) {
        String name = sanitize(requested);
        for (int i = 2; copies.containsKey(folder().resolve(name)); i++) {
            name = i + " " + sanitize(requested);
        }
        addCopy(name, null, bytes);
        return name;
    }

    /**
     * Replaces a file by one from memory.
     *
     * @param name      name of the file, in the scene
     * @param requested name of the new file
     * @return its name in the scene
     */
    String replaceFile(String name, String requested, byte[] bytes) {
        copies.remove(folder().resolve(name));
        return addFile(requested, bytes);
    }

    /** Adds a file next to the scene under the relative path by which another file references it. */
    public void addFileAsNamed(Path file) throws IOException {
        Path folder = ParentFolder.of(source.toRealPath());
        Path target = folder().resolve(folder.relativize(file));
        copies.put(target, new AssetCopy(target, file, null));
    }

    private void addCopy(String name, @Nullable Path file, byte @Nullable [] bytes) {
        Path target = folder().resolve(name);
        copies.put(target, new AssetCopy(target, file, bytes));
    }

    /** Returns a name with the characters and the length that a scene allows. */
    static String sanitize(String name) {
        String sanitized = DISALLOWED.matcher(name).replaceAll("_");
        String shortened =
                sanitized.length() <= MAX_FILE_NAME_LENGTH ? sanitized : sanitized.substring(sanitized.length() - MAX_FILE_NAME_LENGTH);
        return shortened.equals(".") || shortened.equals("..") || shortened.isEmpty() ? "_" : shortened;
    }

    /** Adds a material under a unique name; returns that name. */
    public String addMaterial(String requested, Material material) {
        String name = materialNames.unique(requested, "material");
        materials.add(material.withName(name));
        return name;
    }

    /** Returns a placeholder texture for a file, whose content is read with the scene. */
    public static Optional<TextureMap> placeholderTexture(String file) {
        return Optional.of(new TextureMap(file, 1, 1, new Texture(1, 1, new float[3])));
    }

    /** Creates a shape that shows a mesh, and extends the scene's bounds by it. */
    public Shape createShape(String requested, String file, String part, Mesh mesh, String material, Placement placement, Transform outer) {
        bounds.add(meshBounds.computeIfAbsent(mesh, Bounds::of), outer.times(placement.transform()));
        return new Shape(new Solid.TriangleMesh(file, part, mesh), names.unique(requested, "mesh"), material, placement);
    }

    /** Clamps a color to 0 … {@code max}; notes if it was outside. */
    public Rgb clampColor(Rgb c, double max, String label) {
        if (!(c.min() >= 0 && c.max() <= max)) {
            notes.add(label + " beyond 0 to " + DecimalNumber.format(max));
        }
        return new Rgb(clamp(c.r(), max), clamp(c.g(), max), clamp(c.b(), max));
    }

    public static double clamp(double v, double max) {
        return v >= 0 ? Math.min(v, max) : 0;
    }

    /**
     * Returns the quadratic attenuation factor of a light: a power of 100, so that the light is clamped at 1 only nearer
     * than 1/20 of the scene's size. Its intensity is multiplied by the same factor.
     */
    public double quadraticAttenuation() {
        double quadratic = 1;
        while (1 / Math.sqrt(quadratic) > MIN_LIGHT_DISTANCE * bounds.radius() && quadratic < 1e16) {
            quadratic *= 100;
        }
        return quadratic;
    }

    /** Adds a camera of the file, that of the picture included: the scene keeps all if there are several. */
    public void addCamera(String name, Camera added) {
        cameras.add(new NamedCamera(cameraNames.unique(name, "camera"), added));
    }

    /** Sets the image's aspect ratio, width / height, above 0; the longer side stays. */
    public void setAspectRatio(double aspectRatio) {
        int longer = Math.max(picture.width(), picture.height());
        picture = picture.withSize(imageSide(longer * aspectRatio, longer), imageSide(longer / aspectRatio, longer));
    }

    private static int imageSide(double pixels, int longest) {
        return (int) Math.rint(Math.clamp(pixels, 1, longest));
    }

    /**
     * Returns the scene; adds a camera that frames everything and a light if the file has none, and reduces images that do not fit.
     *
     * @throws MeshException if it is not a valid scene
     * @throws IOException   if an image cannot be read
     */
    public ImportedScene build() throws IOException, MeshException {
        try {
            Camera view = camera.orElseGet(this::defaultCamera);
            boolean hasLights = !lights.isEmpty() || isLit || world.hasEnvironment();
            if (!hasLights) {
                addComment(ImportedScene.ADDED_LIGHT_COMMENT);
                notes.add(ImportedScene.ADDED_LIGHT);
                lights.add(defaultLight(view));
            }
            Stage stage = new Stage(List.copyOf(materials), List.copyOf(nodes));
            // A single one is that of the picture.
            List<NamedCamera> kept = cameras.size() < 2 ? List.of() : cameras.subList(0, Math.min(cameras.size(), SceneLimits.MAX_CAMERAS));
            notes.add("named cameras above the limit", Math.max(0, cameras.size() - SceneLimits.MAX_CAMERAS));
            Scene scene = new FileRenaming(images.fit()).applyTo(new Scene(picture, view, world, stage,
                    LightRig.of(lights.stream().map(light -> withValidLinks(light, stage)).toList(), lightGroups),
                    kept));
            return new ImportedScene(scene, shot.map(s -> withValidTracks(s, scene)), Set.copyOf(restoredLights), Set.copyOf(rawGlows),
                    units,
                    List.copyOf(comments), sceneFile,
                    List.copyOf(copies.values()),
                    Map.copyOf(notes.counts()), new ImportSubject(bounds.min(), bounds.max(), camera.isPresent(), hasLights),
                    List.copyOf(closingComments));
        } catch (RefusalException e) {
            throw new MeshException(source, "", "cannot be a scene here: " + e.getMessage());
        }
    }

    /** Returns a key light from above and to the right of the camera. */
    private Light defaultLight(Camera shownCamera) {
        Vec3 view = shownCamera.to().minus(shownCamera.from()).normalized();
        Vec3 right = view.cross(shownCamera.up()).normalized();
        Vec3 direction = view.times(1.5).minus(right.times(0.5)).minus(right.cross(view).times(0.8));
        return Light.of(names.unique("light", "light"), LightType.DIRECTIONAL)
                .withDirection(new Vec3(round(direction.x(), 2), round(direction.y(), 2), round(direction.z(), 2)));
    }

    /** Removes links to shapes that the scene does not contain. */
    private Light withValidLinks(Light light, Stage stage) {
        Light valid = light.retainLinks(stage::hasNode);
        notes.add("light links to missing objects", valid.equals(light) ? 0 : 1);
        return valid;
    }

    private Shot withValidTracks(Shot animation, Scene scene) {
        Shot valid = ImportedScene.validTracks(animation, scene);
        notes.add("animated properties that cannot be used", animation.tracks().size() - valid.tracks().size());
        return valid;
    }

    /** Returns whether the scene can find a file of this name, after copying it from the source's folder if it is there. */
    public boolean hasOrCopiesFile(FileKind kind, String name) {
        try {
            Optional<Path> file = kind.find(ParentFolder.of(source), name);
            file.ifPresent(path -> addCopy(name, path, null));
            return file.isPresent() || hasFile(kind, name);
        } catch (IOException | RefusalException e) {
            return false;
        }
    }

    /** Returns whether the scene can find a file of this name. */
    public boolean hasFile(FileKind kind, String name) {
        try {
            return kind.find(folder(), name).isPresent();
        } catch (IOException | RefusalException e) {
            return false;
        }
    }

    private Camera defaultCamera() {
        notes.add(ImportedScene.ADDED_CAMERA);
        double distance = bounds.radius() / Math.sin(Math.toRadians(20)) * 1.05;
        Vec3 middle = bounds.center();
        return new Camera(round(middle.plus(new Vec3(0.5, 0.4, 0.9).normalized().times(distance))), round(middle), Vec3.Y, 40);
    }

    /** Rounds to the decimal place below a hundredth of the scene's radius, for readable numbers. */
    private Vec3 round(Vec3 v) {
        int decimals = 2 - (int) Math.floor(Math.log10(bounds.radius()));
        return new Vec3(round(v.x(), decimals), round(v.y(), decimals), round(v.z(), decimals));
    }

    private static double round(double v, int decimals) {
        return BigDecimal.valueOf(v).setScale(decimals, RoundingMode.HALF_EVEN).doubleValue();
    }

    /** Returns whether an image starts with the signature of a supported format. */
    public static boolean isPngOrJpeg(byte[] start) {
        return start.length > 3 && ((start[0] & 0xFF) == 0x89 && start[1] == 'P' || (start[0] & 0xFF) == 0xFF && (start[1] & 0xFF) == 0xD8);
    }
}
