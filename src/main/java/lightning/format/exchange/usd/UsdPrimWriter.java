package lightning.format.exchange.usd;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import lightning.format.jen.asset.FileKind;
import lightning.format.mesh.ConversionNotes;
import lightning.format.usd.UsdLayer;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;
import lightning.scene.value.ShapeLinks;

/**
 * Writer of attributes of a layer's prims: values over time, files and links.
 *
 * @param paths paths of the scene's objects in the stage
 * @param sceneFolder folder of the scene, in which its files are
 * @param outputFolder folder of the layer, which names other files relative to it
 * @param notes receives what cannot be written
 */
public record UsdPrimWriter(UsdPaths paths, Path sceneFolder, Path outputFolder, ConversionNotes notes) {
    public static final String PROFILE = "asset inputs:shaping:ies:file";
    public static final String TEXTURE = "asset inputs:texture:file";
    public static final String ORDER = "uniform token[] xformOpOrder";
    public static final String RESET_ORDER = "[\"!resetXformStack!\", \"xformOp:transform:lightning\"]";

    /** Sets the values of an attribute at several times; a single value if they are equal. */
    public void set(UsdLayer.Prim prim, String declaration, TreeMap<Integer, String> samples) {
        notes.add("values that no float can have, limited", samples.containsValue(UsdLayer.LARGEST) ? 1 : 0);
        if (samples.values().stream().distinct().count() == 1) {
            prim.set(declaration, samples.firstEntry().getValue());
        } else {
            prim.set(declaration, samples);
        }
    }

    /** Sets the members of a collection of links, such as {@code lightLink}. */
    public void setLinks(UsdLayer.Prim prim, String collection, ShapeLinks links) {
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

    /** Returns the file of a light's profile; an empty one without a profile. */
    public String profile(Light light) throws IOException {
        boolean isSoftCone = light.type() == LightType.SPOT && SoftCones.softness(light).isPresent();
        return LightAttribute.PROFILE.appliesTo(light.type()) && light.profile().isPresent() && !isSoftCone
                ? asset(FileKind.PROFILE, light.profile().get().file()) : "@@";
    }

    /** Returns the file of a light's texture; an empty one without a texture. */
    public String texture(Light light) throws IOException {
        return light.faceImage().isPresent() ? asset(FileKind.TEXTURE, light.texture().orElseThrow().file()) : "@@";
    }

    /** Returns the name of a file of the scene, relative to the layer where that is possible. */
    String asset(FileKind kind, String name) throws IOException {
        Path file = kind.find(sceneFolder, name).orElse(sceneFolder.resolve(name)).toAbsolutePath().normalize();
        boolean isNear = file.getRoot().equals(outputFolder.getRoot());
        String path = (isNear ? outputFolder.relativize(file) : file).toString().replace('\\', '/');
        return UsdLayer.asset(path.startsWith("..") || path.startsWith("/") || !isNear ? path : "./" + path);
    }
}
