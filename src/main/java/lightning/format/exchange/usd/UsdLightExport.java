package lightning.format.exchange.usd;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import lightning.base.file.ParentFolder;
import lightning.format.exchange.assembly.ExportedLights;
import lightning.format.mesh.ConversionNotes;
import lightning.format.usd.UsdLayer;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.light.Beam;
import lightning.scene.light.Falloff;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightType;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;

/** Writer of a scene's lights as a layer over the stage that the scene was imported from. */
public final class UsdLightExport {
    private static final String NEW_LIGHTS = "/lightning_lights";

    private final AnimatedScene animated;
    private final Scene scene;
    private final UsdPaths paths;
    private final ConversionNotes notes = new ConversionNotes();
    private final UsdLayer layer = new UsdLayer();
    private final UsdPrimWriter writer;
    private final UsdSparseLights sparse;
    private final List<Scene> frames = new ArrayList<>();
    private final int first;
    /** Name of the image of a physical sky, next to the layer. */
    private final String skyImage;
    private final Map<String, byte[]> files = new HashMap<>();

    private UsdLightExport(AnimatedScene animated, UsdPaths paths, Path sceneFolder, Path output) {
        this.animated = animated;
        Path outputFolder = ParentFolder.of(output.toAbsolutePath().normalize());
        skyImage = output.getFileName().toString().replaceFirst("\\.[^.]*$", "") + ".sky.hdr";
        scene = animated.base();
        this.paths = paths;
        writer = new UsdPrimWriter(paths, sceneFolder, outputFolder, notes);
        sparse = new UsdSparseLights(layer, writer, notes);
        first = animated.shot().map(Shot::first).orElse(0);
    }

    /**
     * Returns the layer.
     *
     * @param text text of the scene file, whose comments name the prims
     * @param sceneFile file of the scene
     * @param output file of the layer, which names other files relative to its folder
     */
    public static ExportedLights export(String text, AnimatedScene animated, Path sceneFile, Path output) throws IOException {
        return new UsdLightExport(animated, UsdPaths.findIn(text), ParentFolder.of(sceneFile.toAbsolutePath().normalize()), output)
                .layer();
    }

    private ExportedLights layer() throws IOException {
        layer.metadata("doc", UsdLayer.quoted("Lights from Lightning"));
        layer.metadata("upAxis", UsdLayer.quoted(paths.hasZUp() ? "Z" : "Y"));
        layer.metadata("metersPerUnit", String.valueOf(scene.world().meters()));
        if (animated.shot().isPresent()) {
            Shot shot = animated.shot().get();
            layer.metadata("timeCodesPerSecond", String.valueOf(shot.rate()));
            if (shot.tracks().stream()
                    .anyMatch(t -> t.target() instanceof SceneElement.OfLight || t.target() instanceof SceneElement.OfLightGroup)) {
                for (int frame = shot.first(); frame <= shot.last(); frame++) {
                    frames.add(animated.sceneAt(frame));
                }
            }
        }
        for (Light light : scene.lights()) {
            addLight(light);
        }
        sparse.finish();
        addEnvironments();
        for (Map.Entry<String, UsdPaths.Prim> light : paths.lights().entrySet()) {
            if (scene.light(light.getKey()).isEmpty()) {
                sparse.remove(light.getValue(), Optional.ofNullable(paths.originals().get(light.getKey())));
            }
        }
        return new ExportedLights(layer.text().getBytes(StandardCharsets.UTF_8), Map.copyOf(files), Map.copyOf(notes.counts()));
    }

    /** Adds dome lights; for a physical sky one with its image, and a distant light for its sun. */
    private void addEnvironments() throws IOException {
        new UsdDomeExport(layer, writer, notes, name -> prim(name, Optional.empty(), "DomeLight")).add(scene, skyImage);
        Optional<EnvironmentMap> sky = UsdDomeExport.sky(scene.world());
        if (sky.isPresent()) {
            files.put(skyImage, UsdDomeImport.hdr(sky.get()));
        }
        UsdDomeExport.sun(scene).ifPresent(sun -> {
            UsdLayer.Prim prim = prim("sun", Optional.empty(), "DistantLight");
            prim.metadata("prepend apiSchemas", "[\"ShadowAPI\"]");
            new UsdLightValues("DistantLight", sun, scene.world().meters(), paths.hasZUp()).values(true).forEach(prim::set);
            prim.set(UsdPrimWriter.ORDER, UsdPrimWriter.RESET_ORDER);
        });
        notes.add("animation of domes", (int) animated.shot().stream().flatMap(s -> s.tracks().stream())
                .filter(t -> t.target() instanceof SceneElement.OfDome).map(Track::target).distinct().count());
    }

    private UsdLayer.Prim prim(String name, Optional<UsdPaths.Prim> original, String type) {
        if (original.isPresent()) {
            UsdLayer.Prim prim = layer.prim(original.get().path());
            return original.get().type().equals(type) ? prim : prim.define(type);
        }
        defineScope();
        String identifier = name.replaceAll("[^A-Za-z0-9_]", "_").replaceFirst("^(?=[0-9])", "_");
        String path = NEW_LIGHTS + "/" + identifier;
        for (int i = 2; layer.contains(path); i++) {
            path = NEW_LIGHTS + "/" + identifier + "_" + i;
        }
        return layer.prim(path).define(type);
    }

    /** Defines the prim of new lights, the default one, which a layer without another needs to be valid. */
    private void defineScope() {
        layer.prim(NEW_LIGHTS).define("Scope");
        layer.metadata("defaultPrim", UsdLayer.quoted(NEW_LIGHTS.substring(1)));
    }

    private void addLight(Light light) throws IOException {
        Optional<UsdPaths.Prim> stagePrim = Optional.ofNullable(paths.lights().get(light.name()));
        Optional<UsdOriginal> original = Optional.ofNullable(paths.originals().get(light.name()));
        String type = UsdLightValues.typeOf(light, stagePrim.map(UsdPaths.Prim::type).orElse(""));
        noteLosses(light);
        boolean isMesh = type.equals(UsdLightValues.MESH);
        if (stagePrim.isPresent() && isMesh != stagePrim.get().type().equals(UsdLightValues.MESH)) {
            notes.add("lights that became an object or were one, not written");
            return;
        }
        if (isMesh && stagePrim.isEmpty()) {
            addMeshLight(light);
            return;
        }
        if (stagePrim.isPresent() && original.isPresent()) {
            sparse.add(light, type, stagePrim.get(), original.get(), animated.shot(), states(light));
            return;
        }
        notes.add("lights of an import without their values, written whole; import the stage again for a sparse layer",
                stagePrim.isPresent() ? 1 : 0);
        UsdLayer.Prim prim = prim(light.name(), stagePrim, type);
        boolean isShaped = UsdLightValues.isShaped(type);
        prim.metadata("prepend apiSchemas", isShaped ? "[\"ShapingAPI\", \"ShadowAPI\"]" : "[\"ShadowAPI\"]");
        values(light, type).forEach((declaration, samples) -> writer.set(prim, declaration, samples));
        prim.set(UsdPrimWriter.ORDER, UsdPrimWriter.RESET_ORDER);
        if (isShaped) {
            prim.set(UsdPrimWriter.PROFILE, writer.profile(light));
        }
        if (type.equals("RectLight")) {
            prim.set(UsdPrimWriter.TEXTURE, writer.texture(light));
        }
        writer.setLinks(prim, "lightLink", light.illuminates());
        writer.setLinks(prim, "shadowLink", light.shadowedBy());
    }

    /** Makes the prim of a shape, which must be a mesh, a light. */
    private void addMeshLight(Light light) {
        Optional<String> path = Optional.ofNullable(paths.objects().get(light.area().shape()));
        if (path.isEmpty()) {
            notes.add("lights of objects that the stage does not have");
            defineScope();
        } else {
            UsdLayer.Prim prim = layer.prim(path.get());
            prim.metadata("prepend apiSchemas", "[\"MeshLightAPI\"]");
            values(light, UsdLightValues.MESH).forEach((declaration, samples) -> writer.set(prim, declaration, samples));
            writer.setLinks(prim, "lightLink", light.illuminates());
            writer.setLinks(prim, "shadowLink", light.shadowedBy());
        }
    }

    /** Returns a light at all frames; at one time only if nothing moves. */
    private List<UsdLightChanges.State> states(Light light) {
        List<UsdLightChanges.State> states = new ArrayList<>();
        for (Scene state : frames.isEmpty() ? List.of(scene) : frames) {
            Light own = state.rig().withSurface(state.light(light.name()).orElseThrow());
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

    private void noteLosses(Light light) {
        LightType type = light.type();
        notes.add("barn doors", LightAttribute.DOORS.appliesTo(type) && !light.doors().isOpen() ? 1 : 0);
        notes.add("flags of lights", light.flag().on() ? 1 : 0);
        notes.add("light filters", light.filter().isActive() ? 1 : 0);
        notes.add("gobos", LightAttribute.GOBO.appliesTo(type) && light.gobo().isPresent() ? 1 : 0);
        notes.add("beam spreads of area lights", type.isSurface() && light.beam().spread() < Beam.OPEN_ANGLE ? 1 : 0);
        notes.add("textures of disc lights", type == LightType.DISC && light.faceImage().isPresent() ? 1 : 0);
        notes.add("gains on single objects", light.influence().gains().isNone() ? 0 : 1);
        notes.add("lights without inverse-square falloff, exact only at distance 1",
                type.hasPosition() && light.falloff() == Falloff.CUSTOM
                        && !(light.attenuation().constant() == 0 && light.attenuation().linear() == 0) ? 1 : 0);
        notes.add("lights of a group, with its color and intensity", light.lightGroup().isEmpty() ? 0 : 1);
    }
}
