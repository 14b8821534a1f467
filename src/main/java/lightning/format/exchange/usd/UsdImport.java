package lightning.format.exchange.usd;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.text.RefusalException;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.FrameTracks;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.exchange.json.SceneExtras;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.format.usd.StageChoice;
import lightning.format.usd.UsdStage;
import lightning.scene.Camera;
import lightning.scene.SceneElement;
import lightning.scene.ViewSettings;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;
import lightning.scene.value.Lens;
import lightning.scene.value.LensShift;
import lightning.scene.value.SceneLimits;
import lightning.scene.value.ShapeLinks;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.node.ObjectNode;

/** Converter from a USD stage to a scene, with its animation. */
public final class UsdImport {
    /** USD gives focal lengths in tenths of a scene unit. */
    private static final double FOCAL_PER_UNIT = 10;
    private static final double MIN_TARGET_DISTANCE = 0.2;

    private final SceneAssembler assembler;
    private final UsdStage stage;
    private final JsonValue root;
    private final Transform upright;
    private final boolean hasZUp;
    private final List<Track> tracks = new ArrayList<>();
    private final Map<String, ObjectNode> originals = new HashMap<>();
    private final int firstFrame;
    private final int levels;
    private final Progress progress;
    private @Nullable UsdNodes nodes;
    private final UsdMeshLights meshLights;

    private UsdImport(UsdStage stage, Path source, Path sceneFile, int levels, Progress progress) throws MeshException {
        this.progress = progress;
        this.stage = stage;
        this.levels = levels;
        root = stage.root();
        assembler = new SceneAssembler(source, sceneFile);
        meshLights = new UsdMeshLights(assembler.notes);
        hasZUp = root.get("up").text().orElse("Y").equals("Z");
        upright = hasZUp ? Transform.rotation(new Vec3(-90, 0, 0)) : Transform.IDENTITY;
        double meters = Math.clamp(root.get("meters").number(0.01), SceneLimits.MIN_METERS, SceneLimits.MAX_METERS);
        assembler.world = assembler.world.withAmbience(0).withMeters(meters);
        firstFrame = hasShot() ? root.get("frames").element(0).integer(0, Shot.MAX_FRAME) : 0;
    }

    /** @param levels refinements of subdivision surfaces */
    public static ImportedScene read(Path source, Path sceneFile, int levels, StageChoice choice, Progress progress)
            throws IOException, MeshException {
        return UsdStage.read(source, choice, progress, stage -> new UsdImport(stage, source, sceneFile, levels, progress).assemble());
    }

    private boolean hasShot() throws MeshException {
        return !root.get("frames").node().isNull() && root.get("frames").size() > 0;
    }

    private ImportedScene assemble() throws IOException, MeshException {
        root.get("notes").node().properties().forEach(e -> assembler.notes.add(e.getKey(), Math.max(0, e.getValue().asInt(0))));
        root.get("named").node().properties()
                .forEach(e -> e.getValue().forEach(name -> assembler.notes.addNamed(e.getKey(), name.asString(""))));
        UsdPaths.addAxis(assembler, hasZUp);
        UsdPaths.addShift(assembler, root.get("shift").integer(-Shot.MAX_FRAME, 0, 0));
        nodes = new UsdNodes(assembler, stage, upright, firstFrame, levels, progress);
        nodes.build();
        tracks.addAll(nodes.tracks());
        importLights();
        JsonValue cameras = root.get("cameras");
        if (cameras.size() > 0) {
            importCamera(cameras.element(0));
            importOtherCameras(cameras.element(0), root.get("other_cameras"));
        }
        importResolution();
        if (hasShot()) {
            importShot();
        }
        ImportedScene built = assembler.build();
        List<String> comments = new ArrayList<>();
        for (int i = 0; i < root.get("hidden").size(); i++) {
            comments.add(UsdHiddenParent.comment(root.get("hidden").element(i)));
        }
        for (Light light : built.scene().lights()) {
            Optional.ofNullable(originals.get(light.name())).ifPresent(o -> comments.add(UsdOriginal.comment(light, built.shot(), o)));
        }
        return meshLights.shown(built).withClosingComments(comments);
    }

    private void importShot() throws MeshException {
        int last = root.get("frames").element(1).integer(firstFrame, Shot.MAX_FRAME);
        double rate = Math.clamp(root.get("frames").element(2).number(), Shot.MIN_RATE, Shot.MAX_RATE);
        long keys = tracks.stream().mapToLong(t -> t.keys().size()).sum();
        if (keys > Shot.MAX_KEYS) {
            assembler.notes.add("animation of more than " + Shot.MAX_KEYS + " keyframes");
        } else {
            assembler.shot = Optional.of(new Shot(firstFrame, last, rate, tracks));
        }
    }

    private void importLights() throws IOException, MeshException {
        double meters = assembler.world.meters();
        var softCones = new SoftCones(assembler);
        var converter = new UsdLightImport(assembler, upright, meters, assembler.notes, softCones);
        // Further frames repeat what is noted already.
        var frameConverter = new UsdLightImport(assembler, upright, meters, new ConversionNotes(), softCones);
        JsonValue lights = root.get("lights");
        for (int i = 0; i < lights.size(); i++) {
            JsonValue in = lights.element(i);
            if (in.get("type").text().orElse("").startsWith("DomeLight")) {
                if (assembler.world.named().size() < SceneLimits.MAX_DOMES) {
                    new UsdDomeImport(assembler, upright, hasZUp).add(in);
                    assembler.notes.add("animation of dome lights", in.get("frames").size() > 0 ? 1 : 0);
                } else {
                    assembler.notes.add("dome lights after the first " + (1 + SceneLimits.MAX_DOMES));
                }
                continue;
            }
            if (in.get("type").text().orElse("").equals("PortalLight")) {
                assembler.notes.add("portal lights, not needed: openings are found without them");
                continue;
            }
            if (assembler.lights.size() == SceneLimits.MAX_LIGHTS) {
                assembler.notes.add("lights after the first " + SceneLimits.MAX_LIGHTS);
                continue;
            }
            String name = assembler.names.unique(in.get("name").text().orElse(""), "light");
            Optional<Light> light = converter.convert(name, in);
            if (light.isPresent()) {
                Light placed = in.get("node").isPresent() ? meshLights.placed(light.get(), in, root.get("nodes"), requireNonNull(nodes))
                        : light.get();
                assembler.lights.add(linked(placed, in.get("links")));
                UsdPaths.addLight(assembler, name, in);
                originals.put(name, UsdOriginal.stage(in));
                importFrames(light.get(), in, frameConverter);
            }
        }
    }

    private void importFrames(Light light, JsonValue in, UsdLightImport converter) throws IOException, MeshException {
        JsonValue frames = in.get("frames");
        List<Light> moving = new ArrayList<>();
        for (int i = 0; i < frames.size(); i++) {
            moving.add(converter.convert(light.name(), frames.element(i)).orElse(light));
        }
        if (!moving.isEmpty()) {
            tracks.addAll(new FrameTracks(firstFrame).of(new SceneElement.OfLight(light.name()), LightAttribute.ALL, moving));
        }
    }

    private Light linked(Light light, JsonValue links) throws MeshException {
        return light.withIlluminates(links(links.get("light"))).withShadowedBy(links(links.get("shadow")));
    }

    private ShapeLinks links(JsonValue in) throws MeshException {
        if (!in.isPresent()) {
            return ShapeLinks.ALL;
        }
        List<String> names = new ArrayList<>();
        for (int i = 0; i < in.get("nodes").size(); i++) {
            names.addAll(requireNonNull(nodes).names(in.get("nodes").element(i).index(root.get("nodes"))));
        }
        if (names.size() > SceneLimits.MAX_LINKS) {
            assembler.notes.add("light links to more than " + SceneLimits.MAX_LINKS + " objects");
            return ShapeLinks.ALL;
        }
        return new ShapeLinks(in.get("only").bool(false), names);
    }

    private void importCamera(JsonValue in) throws MeshException {
        JsonValue frames = in.get("frames");
        List<JsonValue> states = new ArrayList<>(List.of(in));
        for (int i = 0; i < frames.size(); i++) {
            states.add(frames.element(i));
        }
        boolean isShifted = true;
        for (JsonValue state : states) {
            isShifted &= LensShift.isValid(shift(state, "offset_x", "width"), shift(state, "offset_y", "height"));
        }
        assembler.notes.add(SceneExtras.INVALID_SHIFT, isShifted ? 0 : 1);
        try {
            Camera camera = camera(in, isShifted);
            assembler.camera = Optional.of(camera);
            assembler.notes.add("orthographic cameras, imported as perspective", in.get("orthographic").bool(false) ? 1 : 0);
            assembler.notes.add("depth of field of cameras without a focus distance",
                    in.get("f_number").number(0) > 0 && !camera.lens().isOpen() && !in.get("orthographic").bool(false) ? 1 : 0);
            importExposure(in);
            double aspect = in.get("width").number(1) / in.get("height").number(1);
            if (aspect > 0 && aspect < Double.POSITIVE_INFINITY) {
                assembler.setAspectRatio(aspect);
            }
            List<Camera> moving = new ArrayList<>();
            for (JsonValue state : states.subList(1, states.size())) {
                moving.add(camera(state, isShifted));
            }
            if (!moving.isEmpty()) {
                tracks.addAll(new FrameTracks(firstFrame).of(SceneElement.CAMERA, Camera.ATTRIBUTES, moving));
            }
        } catch (RefusalException | ArithmeticException e) {
            assembler.notes.add("cameras that cannot be placed");
        }
    }

    /** Adds all cameras. Exposures of the others are those of the shown one, as there is one picture. */
    private void importOtherCameras(JsonValue shown, JsonValue others) throws MeshException {
        String name = shown.get("name").text().orElse("");
        assembler.camera.ifPresent(camera -> assembler.addCamera(name, camera));
        for (int i = 0; i < others.size(); i++) {
            JsonValue in = others.element(i);
            boolean isShifted = LensShift.isValid(shift(in, "offset_x", "width"), shift(in, "offset_y", "height"));
            assembler.notes.add(SceneExtras.INVALID_SHIFT, isShifted ? 0 : 1);
            assembler.notes.add("exposures of additional cameras", in.get("exposure").number(0) == shown.get("exposure").number(0) ? 0 : 1);
            try {
                assembler.addCamera(in.get("name").text().orElse(""), camera(in, isShifted));
            } catch (RefusalException | ArithmeticException e) {
                assembler.notes.add("cameras that cannot be placed");
            }
        }
    }

    /** Sets the size of the picture by the render settings of the stage. */
    private void importResolution() throws MeshException {
        JsonValue size = root.get("resolution");
        if (!size.node().isNull() && size.size() == 2) {
            int width = size.element(0).integer(1, Integer.MAX_VALUE);
            int height = size.element(1).integer(1, Integer.MAX_VALUE);
            if (width <= SceneLimits.MAX_SIZE && height <= SceneLimits.MAX_SIZE) {
                assembler.picture = assembler.picture.withSize(width, height);
            } else {
                assembler.notes.add("resolutions of render settings that a picture cannot have");
            }
        }
    }

    /** Sets the exposure of the camera, in stops; it does not change over a shot. */
    private void importExposure(JsonValue in) throws MeshException {
        double stops = UsdNumbers.rounded(Math.clamp(in.get("exposure").number(0), -ViewSettings.MAX_EXPOSURE, ViewSettings.MAX_EXPOSURE));
        assembler.picture = assembler.picture.withView(assembler.picture.view().withExposure(stops));
        boolean isAnimated = false;
        for (int i = 0; i < in.get("frames").size(); i++) {
            isAnimated |= in.get("frames").element(i).get("exposure").number(0) != in.get("exposure").number(0);
        }
        assembler.notes.add("animated exposures of cameras, imported as at the first frame", isAnimated ? 1 : 0);
    }

    private Camera camera(JsonValue in, boolean isShifted) throws MeshException {
        Transform m = upright.times(UsdStage.transform(in.get("matrix")));
        Vec3 from = m.transformPoint(Vec3.ZERO);
        Vec3 view = m.transformVector(new Vec3(0, 0, -1)).normalized();
        double fov = Math.toDegrees(2 * Math.atan(in.get("height").number(1) / (2 * in.get("focal").number(1))));
        double distance = Math.max(assembler.bounds.center().minus(from).dot(view), MIN_TARGET_DISTANCE * assembler.bounds.radius());
        return new Camera(UsdNumbers.rounded(from), UsdNumbers.rounded(from.plus(view.times(distance))),
                UsdNumbers.rounded(m.transformVector(Vec3.Y).normalized()),
                UsdNumbers.rounded(Math.clamp(fov, SceneLimits.MIN_FOV, SceneLimits.MAX_FOV)),
                isShifted ? new LensShift(shift(in, "offset_x", "width"), shift(in, "offset_y", "height")) : LensShift.NONE, lens(in, m));
    }

    /** Returns the lens of an f-number; a pinhole without one, and without a focus distance, at which nothing would be sharp. */
    private static Lens lens(JsonValue in, Transform camera) throws MeshException {
        double unit = camera.transformVector(new Vec3(0, 0, -1)).length();
        double fNumber = in.get("f_number").number(0);
        double focus = in.get("focus").number(0) * unit;
        if (!(fNumber > 0 && focus > 0) || in.get("orthographic").bool(false)) {
            return Lens.PINHOLE;
        }
        double focal = in.get("focal").number(1) / FOCAL_PER_UNIT * unit;
        return Lens.PINHOLE.withAperture(UsdNumbers.rounded(Math.clamp(focal / (2 * fNumber), 0, SceneLimits.MAX_EXTENT)))
                .withFocus(UsdNumbers.rounded(Math.clamp(focus, 0, SceneLimits.MAX_COORDINATE)));
    }

    /** Returns the offset of the aperture as a share of its size. */
    private static double shift(JsonValue in, String offset, String size) throws MeshException {
        return UsdNumbers.rounded(UsdNumbers.tidy(in.get(offset).number(0)) / UsdNumbers.tidy(in.get(size).number(1)));
    }
}
