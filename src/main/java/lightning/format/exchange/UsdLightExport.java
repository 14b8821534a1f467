package lightning.format.exchange;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import lightning.base.file.ParentFolder;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.format.exchange.usd.SoftCones;
import lightning.format.exchange.usd.UsdLightChanges;
import lightning.format.exchange.usd.UsdLightValues;
import lightning.format.exchange.usd.UsdOriginal;
import lightning.format.exchange.usd.UsdPaths;
import lightning.format.jen.asset.FileKind;
import lightning.format.mesh.ConversionNotes;
import lightning.format.usd.UsdLayer;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Falloff;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightType;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;
import lightning.scene.shot.TrackTarget;
import lightning.scene.value.ShapeLinks;

/** Writer of a scene's lights as a layer over the stage that the scene was imported from. */
public final class UsdLightExport {
    private static final String NEW_LIGHTS = "/lightning_lights";
    private static final String SHARED = "edited lights of point instancers, which a layer cannot change one by one";
    private static final String PROFILE = "asset inputs:shaping:ies:file";
    private static final String TEXTURE = "asset inputs:texture:file";
    private static final String ORDER = "uniform token[] xformOpOrder";
    private static final String RIG_ORDER = "[\"xformOp:transform:lightning\"]";
    private static final String RESET_ORDER = "[\"!resetXformStack!\", \"xformOp:transform:lightning\"]";

    private final AnimatedScene animated;
    private final Scene scene;
    private final UsdPaths paths;
    private final Path sceneFolder;
    private final Path outputFolder;
    private final ConversionNotes notes = new ConversionNotes();
    private final UsdLayer layer = new UsdLayer();
    private final List<Scene> frames = new ArrayList<>();
    private final int first;

    private UsdLightExport(AnimatedScene animated, UsdPaths paths, Path sceneFolder, Path outputFolder) {
        this.animated = animated;
        scene = animated.base();
        this.paths = paths;
        this.sceneFolder = sceneFolder;
        this.outputFolder = outputFolder;
        first = animated.shot().map(Shot::first).orElse(0);
    }

    /**
     * Returns the layer.
     *
     * @param text text of the scene file, whose comments name the prims
     * @param sceneFile file of the scene
     * @param output file of the layer, which names other files relative to its folder
     */
    static LightExport export(String text, AnimatedScene animated, Path sceneFile, Path output) throws IOException {
        return new UsdLightExport(animated, UsdPaths.findIn(text), ParentFolder.of(sceneFile.toAbsolutePath().normalize()),
                ParentFolder.of(output.toAbsolutePath().normalize())).layer();
    }

    private LightExport layer() throws IOException {
        layer.metadata("doc", UsdLayer.quoted("Lights from Lightning"));
        layer.metadata("upAxis", UsdLayer.quoted(paths.hasZUp() ? "Z" : "Y"));
        layer.metadata("metersPerUnit", String.valueOf(scene.world().meters()));
        if (animated.shot().isPresent()) {
            Shot shot = animated.shot().get();
            layer.metadata("timeCodesPerSecond", String.valueOf(shot.rate()));
            if (shot.tracks().stream()
                    .anyMatch(t -> t.target().kind() == TrackTarget.Kind.LIGHT || t.target().kind() == TrackTarget.Kind.LIGHT_GROUP)) {
                for (int frame = shot.first(); frame <= shot.last(); frame++) {
                    frames.add(animated.sceneAt(frame));
                }
            }
        }
        for (Light light : scene.lights()) {
            addLight(light);
        }
        addEnvironment();
        for (Map.Entry<String, UsdPaths.Prim> light : paths.lights().entrySet()) {
            if (scene.light(light.getKey()).isEmpty()) {
                deactivate(light.getValue(), Optional.ofNullable(paths.originals().get(light.getKey())));
            }
        }
        return new LightExport(layer.text().getBytes(StandardCharsets.UTF_8), Map.copyOf(notes.counts()));
    }

    private void deactivate(UsdPaths.Prim prim, Optional<UsdOriginal> original) {
        if (original.isPresent() && original.get().isShared()) {
            notes.add(SHARED);
            return;
        }
        original.map(UsdOriginal::instances).orElse(List.of()).forEach(path -> layer.prim(path).metadata("instanceable", "false"));
        layer.prim(prim.path()).metadata("active", "false");
    }

    private UsdLayer.Prim prim(String name, Optional<UsdPaths.Prim> original, String type) {
        if (original.isPresent()) {
            UsdLayer.Prim prim = layer.prim(original.get().path());
            return original.get().type().equals(type) ? prim : prim.define(type);
        }
        layer.prim(NEW_LIGHTS).define("Scope");
        String identifier = name.replaceAll("[^A-Za-z0-9_]", "_").replaceFirst("^(?=[0-9])", "_");
        String path = NEW_LIGHTS + "/" + identifier;
        for (int i = 2; layer.contains(path); i++) {
            path = NEW_LIGHTS + "/" + identifier + "_" + i;
        }
        return layer.prim(path).define(type);
    }

    private void addLight(Light light) throws IOException {
        Optional<UsdPaths.Prim> stagePrim = Optional.ofNullable(paths.lights().get(light.name()));
        Optional<UsdOriginal> original = Optional.ofNullable(paths.originals().get(light.name()));
        String type = UsdLightValues.typeOf(light, stagePrim.map(UsdPaths.Prim::type).orElse(""));
        noteLosses(light);
        if (stagePrim.isPresent() && original.isPresent()) {
            addChanges(light, type, stagePrim.get(), original.get());
            return;
        }
        notes.add("lights of an import without their values, written whole; import the stage again for a sparse layer",
                stagePrim.isPresent() ? 1 : 0);
        UsdLayer.Prim prim = prim(light.name(), stagePrim, type);
        boolean isShaped = isShaped(type);
        prim.metadata("prepend apiSchemas", isShaped ? "[\"ShapingAPI\", \"ShadowAPI\"]" : "[\"ShadowAPI\"]");
        values(light, type).forEach((declaration, samples) -> set(prim, declaration, samples));
        prim.set(ORDER, RESET_ORDER);
        if (isShaped) {
            prim.set(PROFILE, profile(light));
        }
        if (type.equals("RectLight")) {
            prim.set(TEXTURE, texture(light));
        }
        addLinks(prim, "lightLink", light.illuminates());
        addLinks(prim, "shadowLink", light.shadowedBy());
    }

    private static boolean isShaped(String type) {
        return type.equals("SphereLight") || type.equals("DiskLight");
    }

    private static void set(UsdLayer.Prim prim, String declaration, TreeMap<Integer, String> samples) {
        if (samples.values().stream().distinct().count() == 1) {
            prim.set(declaration, samples.firstEntry().getValue());
        } else {
            prim.set(declaration, samples);
        }
    }

    private String profile(Light light) throws IOException {
        return LightAttribute.PROFILE.appliesTo(light.type()) && light.profile().isPresent() && SoftCones.softness(light).isEmpty()
                ? asset(FileKind.PROFILE, light.profile().get().file()) : "@@";
    }

    private String texture(Light light) throws IOException {
        return light.faceImage().isPresent() ? asset(FileKind.TEXTURE, light.texture().orElseThrow().file()) : "@@";
    }

    /** Writes what has been edited of an imported light. */
    private void addChanges(Light light, String type, UsdPaths.Prim stagePrim, UsdOriginal original) throws IOException {
        var changes = new UsdLightChanges(original, light, animated.shot(), stagePrim.type(), type, states(light), paths);
        Map<String, TreeMap<Integer, String>> values = changes.values();
        Map<String, String> files = new LinkedHashMap<>();
        if (isShaped(type) && !profile(light).equals(profile(changes.before()))) {
            files.put(PROFILE, profile(light));
        }
        if (type.equals("RectLight") && changes.has(LightAttribute.TEXTURE)) {
            files.put(TEXTURE, texture(light));
        }
        boolean hasLinks = changes.has(LightAttribute.ILLUMINATES) || changes.has(LightAttribute.SHADOWED_BY);
        if (values.isEmpty() && files.isEmpty() && !hasLinks && !changes.isRetyped()) {
            return;
        }
        if (original.isShared()) {
            notes.add(SHARED);
            return;
        }
        original.instances().forEach(path -> layer.prim(path).metadata("instanceable", "false"));
        UsdLayer.Prim prim = layer.prim(stagePrim.path());
        if (changes.isRetyped()) {
            prim.define(type);
        }
        addSchemas(prim, original, values.keySet(), files.keySet());
        values.forEach((declaration, samples) -> set(prim, declaration, samples));
        if (values.containsKey(UsdLightValues.MATRIX)) {
            prim.set(ORDER, changes.leavesRig() || original.resetsTransform() ? RESET_ORDER : RIG_ORDER);
        }
        notes.add("moved lights whose parents move or are flat, placed in the world", changes.leavesRig() ? 1 : 0);
        files.forEach(prim::set);
        if (changes.has(LightAttribute.ILLUMINATES)) {
            addLinks(prim, "lightLink", light.illuminates());
        }
        if (changes.has(LightAttribute.SHADOWED_BY)) {
            addLinks(prim, "shadowLink", light.shadowedBy());
        }
    }

    /** Applies the schemas of attributes that are written, where the stage does not. */
    private static void addSchemas(UsdLayer.Prim prim, UsdOriginal original, Set<String> values, Set<String> files) {
        List<String> missing = new ArrayList<>();
        if (!original.hasSchema("ShapingAPI")
                && (files.contains(PROFILE) || values.stream().anyMatch(s -> s.contains("inputs:shaping:")))) {
            missing.add("ShapingAPI");
        }
        if (!original.hasSchema("ShadowAPI") && values.stream().anyMatch(s -> s.contains("inputs:shadow:"))) {
            missing.add("ShadowAPI");
        }
        if (!missing.isEmpty()) {
            prim.metadata("prepend apiSchemas", missing.stream().map(UsdLayer::quoted).collect(Collectors.joining(", ", "[", "]")));
        }
    }

    /** Returns a light at all frames; at one time only if nothing moves. */
    private List<UsdLightChanges.State> states(Light light) {
        List<UsdLightChanges.State> states = new ArrayList<>();
        for (Scene state : frames.isEmpty() ? List.of(scene) : frames) {
            Light own = state.light(light.name()).orElseThrow();
            states.add(new UsdLightChanges.State(first + states.size() + paths.shift(), inGroup(own, state), state.isActive(own),
                    state.world().meters()));
        }
        return states;
    }

    /** Returns all values of a light that the stage does not have. */
    private Map<String, TreeMap<Integer, String>> values(Light light, String type) {
        return UsdLightChanges.series(states(light),
                s -> new UsdLightValues(type, s.light(), s.meters(), paths.hasZUp()).values(s.isOn()));
    }

    /** Returns a light with color and intensity of its group, which USD has not. */
    private static Light inGroup(Light light, Scene state) {
        Optional<LightGroup> group = state.rig().lightGroup(light.lightGroup());
        return group.isEmpty() ? light
                : light.withColor(light.color().times(group.get().color())).withIntensity(light.intensity() * group.get().intensity());
    }

    private void addLinks(UsdLayer.Prim prim, String collection, ShapeLinks links) {
        List<String> targets = new ArrayList<>();
        for (String name : links.names()) {
            Optional<String> path = Optional.ofNullable(paths.objects().get(name));
            notes.add("links to objects that the stage does not have", path.isEmpty() ? 1 : 0);
            path.ifPresent(targets::add);
        }
        String prefix = "collection:" + collection + ":";
        prim.set("uniform bool " + prefix + "includeRoot", links.exclusive() ? "0" : "1");
        prim.set("rel " + prefix + "includes", UsdLayer.targets(links.exclusive() ? targets : List.of()));
        prim.set("rel " + prefix + "excludes", UsdLayer.targets(links.exclusive() ? List.of() : targets));
    }

    private void noteLosses(Light light) {
        LightType type = light.type();
        notes.add("barn doors", LightAttribute.DOORS.appliesTo(type) && !light.doors().isOpen() ? 1 : 0);
        notes.add("gobos", type.hasCone() && light.gobo().isPresent() ? 1 : 0);
        notes.add("textures of disc lights", type == LightType.DISC && light.faceImage().isPresent() ? 1 : 0);
        notes.add("gains on single objects", light.contribution().gains().isNone() ? 0 : 1);
        notes.add("lights without inverse-square falloff, exact only at distance 1",
                type.hasPosition() && light.falloff() == Falloff.CUSTOM
                        && !(light.attenuation().constant() == 0 && light.attenuation().linear() == 0) ? 1 : 0);
        notes.add("lights of a group, with its color and intensity", light.lightGroup().isEmpty() ? 0 : 1);
    }

    private void addEnvironment() throws IOException {
        World world = scene.world();
        Optional<UsdPaths.Dome> dome = paths.dome();
        if (world.environment().isEmpty()) {
            dome.ifPresent(d -> layer.prim(d.prim().path()).metadata("active", "false"));
            return;
        }
        notes.add("light gain of the environment", world.gain() == 1 ? 0 : 1);
        String file = world.environment().get().file();
        boolean isBrightness =
                dome.isEmpty() || dome.get().intensity().isEmpty() || dome.get().intensity().getAsDouble() != world.intensity();
        boolean isImage = dome.isEmpty() || !paths.isSameFile(dome.get().file(), file);
        boolean isTurned = dome.isEmpty() || dome.get().rotation() != world.rotation();
        if (!isBrightness && !isImage && !isTurned) {
            return;
        }
        UsdLayer.Prim prim = dome.map(d -> layer.prim(d.prim().path())).orElseGet(() -> prim("environment", Optional.empty(), "DomeLight"));
        if (isBrightness) {
            prim.set("float inputs:intensity", UsdLayer.number(world.intensity() * dome.map(UsdPaths.Dome::factor).orElse(1.0)));
        }
        if (isImage) {
            prim.set(TEXTURE, asset(FileKind.ENVIRONMENT, file));
            prim.set("token inputs:texture:format", UsdLayer.quoted("latlong"));
        }
        if (isTurned) {
            Transform turn = Transform.rotation(new Vec3(0, world.rotation() - 180, 0));
            if (paths.hasZUp() && dome.isPresent() && dome.get().prim().type().equals("DomeLight_1")) {
                turn = turn.times(Transform.rotation(new Vec3(-90, 0, 0)));
            }
            prim.set(UsdLightValues.MATRIX, UsdLightValues.matrix(turn.transformVector(new Vec3(1, 0, 0)),
                    turn.transformVector(new Vec3(0, 0, 1)), Vec3.ZERO, paths.hasZUp()));
            prim.set(ORDER, RESET_ORDER);
        }
    }

    /** Returns the name of a file of the scene, relative to the layer where that is possible. */
    private String asset(FileKind kind, String name) throws IOException {
        Path file = kind.find(sceneFolder, name).orElse(sceneFolder.resolve(name)).toAbsolutePath().normalize();
        boolean isNear = file.getRoot().equals(outputFolder.getRoot());
        String path = (isNear ? outputFolder.relativize(file) : file).toString().replace('\\', '/');
        return UsdLayer.asset(path.startsWith("..") || path.startsWith("/") || !isNear ? path : "./" + path);
    }
}
