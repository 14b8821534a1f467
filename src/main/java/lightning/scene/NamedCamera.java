package lightning.scene;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.value.SceneLimits;

/**
 * Camera that a scene keeps under a name, to be chosen as the one of the picture.
 *
 * @param name unique among the named cameras
 */
public record NamedCamera(String name, Camera camera) {
    static final List<SceneAttribute<NamedCamera, ?>> ATTRIBUTES =
            Camera.ATTRIBUTES.stream().<SceneAttribute<NamedCamera, ?>>map(NamedCamera::attribute).toList();

    public NamedCamera {
        SceneLimits.checkName(name);
    }

    private static <V> SceneAttribute<NamedCamera, V> attribute(SceneAttribute<Camera, V> of) {
        return new SceneAttribute<>(of.name(), of.title(), of.kind(), of.initial(), of.unit(), named -> of.get(named.camera),
                (named, v) -> new NamedCamera(named.name, of.with(named.camera, v)));
    }

    /**
     * Returns an immutable copy.
     *
     * @throws IllegalArgumentException if two have the same name, or there are more than {@link SceneLimits#MAX_CAMERAS}
     */
    static List<NamedCamera> check(List<NamedCamera> cameras) {
        SceneLimits.checkRange("the number of named cameras", cameras.size(), 0, SceneLimits.MAX_CAMERAS);
        Set<String> names = new HashSet<>();
        for (NamedCamera camera : cameras) {
            if (!names.add(camera.name)) {
                throw new RefusalException("camera " + Quote.of(camera.name) + ": the name is already taken");
            }
        }
        return List.copyOf(cameras);
    }
}
