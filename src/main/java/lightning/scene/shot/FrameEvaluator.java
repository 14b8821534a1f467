package lightning.scene.shot;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import lightning.base.math.Vec3;
import lightning.base.text.RefusalException;
import lightning.scene.Camera;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.World;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;

/** Evaluation of the scene at one frame. Sets dependent values together, so that no intermediate state is rejected. */
final class FrameEvaluator {
    private final Map<SceneElement<?>, List<Track>> tracks;
    private final double frame;

    FrameEvaluator(List<Track> tracks, double frame) {
        this.tracks = tracks.stream().collect(Collectors.groupingBy(Track::target));
        this.frame = frame;
    }

    Scene evaluate(Scene scene) {
        Scene result = scene;
        if (tracks.containsKey(SceneElement.CAMERA)) {
            result = result.withCamera(camera(scene.camera(), tracks.get(SceneElement.CAMERA)));
        }
        if (has(SceneElement.OfLight.class) || has(SceneElement.OfLightGroup.class)) {
            result = result.withRig(LightRig.of(
                    scene.lights().stream().map(light -> animate(light, new SceneElement.OfLight(light.name()), LightAttribute.ALL))
                            .toList(),
                    scene.rig().lightGroups().stream()
                            .map(group -> animate(group, new SceneElement.OfLightGroup(group.name()), LightGroup.ATTRIBUTES)).toList()));
        }
        if (has(SceneElement.OfWorld.class) || has(SceneElement.OfDome.class)) {
            World world = animate(scene.world(), SceneElement.WORLD, World.ATTRIBUTES);
            result = result.withWorld(world.withNamed(world.named().stream()
                    .map(dome -> animate(dome, new SceneElement.OfDome(dome.name()), Dome.ATTRIBUTES)).toList()));
        }
        return has(SceneElement.OfNode.class) ? result.withNodes(nodes(scene.nodes())) : result;
    }

    private boolean has(Class<?> type) {
        return tracks.keySet().stream().anyMatch(type::isInstance);
    }

    private Camera camera(Camera base, List<Track> keys) {
        Vec3 from = Camera.FROM.get(base);
        Vec3 to = Camera.TO.get(base);
        Vec3 up = Camera.UP.get(base);
        for (Track track : keys) {
            if (track.attribute().equals(Camera.FROM.name())) {
                from = track.evaluate(frame, Camera.FROM.kind());
            } else if (track.attribute().equals(Camera.TO.name())) {
                to = track.evaluate(frame, Camera.TO.kind());
            } else if (track.attribute().equals(Camera.UP.name())) {
                up = track.evaluate(frame, Camera.UP.kind());
            }
        }
        return animate(base.withView(from, to, up), SceneElement.CAMERA, Camera.OPTICS);
    }

    private List<SceneNode> nodes(List<SceneNode> nodes) {
        return nodes.stream().map(this::node).toList();
    }

    private SceneNode node(SceneNode node) {
        SceneNode withChildren = switch (node) {
            case NodeGroup g when !g.children().isEmpty() -> g.withChildren(nodes(g.children()));
            case NodeGroup g -> g;
            case Shape s -> s;
        };
        return animate(withChildren, new SceneElement.OfNode(node.name()), node.attributes());
    }

    private <T> T animate(T record, SceneElement<T> target, List<? extends SceneAttribute<T, ?>> attributes) {
        T result = record;
        for (Track track : tracks.getOrDefault(target, List.of())) {
            for (SceneAttribute<T, ?> attribute : attributes) {
                if (attribute.name().equals(track.attribute())) {
                    result = animate(result, attribute, track);
                }
            }
        }
        return result;
    }

    private <T, V> T animate(T record, SceneAttribute<T, V> attribute, Track track) {
        try {
            V value = track.evaluate(frame, attribute.kind());
            attribute.kind().check(attribute.name(), value);
            return attribute.with(record, value);
        } catch (RefusalException e) {
            throw new RefusalException(track.target().label() + ": " + e.getMessage(), e);
        }
    }
}
