package lightning.editor.window.timeline;

import java.util.List;
import lightning.base.text.Messages;
import lightning.scene.Camera;
import lightning.scene.Dome;
import lightning.scene.SceneElement;
import lightning.scene.World;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.shot.ShotDiff;
import lightning.scene.shot.Track;

/** Names of tracks and animated objects. */
final class TrackNames {
    private TrackNames() {}

    static String name(SceneElement<?> target) {
        return ShotDiff.name(target);
    }

    /** Returns the name of a track, such as {@code key: intensity}. */
    static String name(Track track) {
        return name(track.target()) + ": " + attribute(track);
    }

    static String attribute(Track track) {
        List<? extends SceneAttribute<?, ?>> attributes = switch (track.target()) {
            case SceneElement.OfCamera _ -> Camera.ATTRIBUTES;
            case SceneElement.OfWorld _ -> World.ATTRIBUTES;
            case SceneElement.OfLight _ -> LightAttribute.ALL;
            case SceneElement.OfLightGroup _ -> LightGroup.ATTRIBUTES;
            case SceneElement.OfDome _ -> Dome.ATTRIBUTES;
            default -> List.of();
        };
        return Messages.tr(attributes.stream().filter(a -> a.name().equals(track.attribute())).map(SceneAttribute::title).findFirst()
                .orElse(track.attribute()));
    }
}
