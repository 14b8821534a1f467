package lightning.scene.shot;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import lightning.base.math.Vec3;
import lightning.scene.Attribute;
import lightning.scene.Bank;
import lightning.scene.Camera;
import lightning.scene.Group;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.Node;
import lightning.scene.Rig;
import lightning.scene.Scene;
import lightning.scene.Shape;

/** Makes the scene of one frame. All that goes together is set together, so that nothing in between is ever refused. */
final class FrameScene {
    private final Map<Target, List<Track>> tracks;
    private final double frame;

    FrameScene(List<Track> tracks, double frame) {
        this.tracks = tracks.stream().collect(Collectors.groupingBy(Track::target));
        this.frame = frame;
    }

    Scene of(Scene scene) {
        Scene of = scene;
        if (tracks.containsKey(Target.CAMERA)) {
            of = of.withCamera(camera(scene.camera(), tracks.get(Target.CAMERA)));
        }
        if (has(Target.What.LIGHT) || has(Target.What.BANK)) {
            of = of.withRig(Rig.of(scene.lights().stream().map(this::light).toList(),
                    scene.rig().banks().stream().map(this::bank).toList()));
        }
        return has(Target.What.NODE) ? of.withNodes(nodes(scene.nodes())) : of;
    }

    private boolean has(Target.What what) {
        return tracks.keySet().stream().anyMatch(t -> t.what() == what);
    }

    private Camera camera(Camera still, List<Track> keys) {
        Vec3 from = Camera.FROM.of(still);
        Vec3 to = Camera.TO.of(still);
        Vec3 up = Camera.UP.of(still);
        double fov = Camera.FOV.of(still);
        for (Track track : keys) {
            if (track.attribute().equals(Camera.FROM.name())) {
                from = track.at(frame, Camera.FROM.kind());
            } else if (track.attribute().equals(Camera.TO.name())) {
                to = track.at(frame, Camera.TO.kind());
            } else if (track.attribute().equals(Camera.UP.name())) {
                up = track.at(frame, Camera.UP.kind());
            } else if (track.attribute().equals(Camera.FOV.name())) {
                fov = track.at(frame, Camera.FOV.kind());
            }
        }
        return new Camera(from, to, up, fov);
    }

    private Light light(Light light) {
        return moved(light, Target.light(light.name()), LightAttribute.ALL);
    }

    private Bank bank(Bank bank) {
        return moved(bank, Target.bank(bank.name()), Bank.ATTRIBUTES);
    }

    private List<Node> nodes(List<Node> nodes) {
        return nodes.stream().map(this::node).toList();
    }

    private Node node(Node node) {
        Node inside = switch (node) {
            case Group g when !g.children().isEmpty() -> g.withChildren(nodes(g.children()));
            case Group g -> g;
            case Shape s -> s;
        };
        return moved(inside, Target.node(node.name()), node.attributes());
    }

    private <T> T moved(T record, Target target, List<? extends Attribute<T, ?>> attributes) {
        T moved = record;
        for (Track track : tracks.getOrDefault(target, List.of())) {
            for (Attribute<T, ?> attribute : attributes) {
                if (attribute.name().equals(track.attribute())) {
                    moved = moved(moved, attribute, track);
                }
            }
        }
        return moved;
    }

    private <T, V> T moved(T record, Attribute<T, V> attribute, Track track) {
        try {
            V value = track.at(frame, attribute.kind());
            attribute.kind().check(attribute.name(), value);
            return attribute.with(record, value);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(track.target() + ": " + e.getMessage(), e);
        }
    }
}
