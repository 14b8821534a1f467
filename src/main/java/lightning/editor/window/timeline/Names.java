package lightning.editor.window.timeline;

import java.util.List;
import lightning.base.text.Texts;
import lightning.scene.Attribute;
import lightning.scene.Bank;
import lightning.scene.Camera;
import lightning.scene.LightAttribute;
import lightning.scene.shot.ShotChange;
import lightning.scene.shot.Target;
import lightning.scene.shot.Track;

/** How the timeline calls what has keys. */
final class Names {
    private Names() {}

    static String of(Target target) {
        return ShotChange.name(target);
    }

    /** {@code key: intensity}. */
    static String of(Track track) {
        return of(track.target()) + ": " + attribute(track);
    }

    static String attribute(Track track) {
        List<? extends Attribute<?, ?>> known = switch (track.target().what()) {
            case CAMERA -> Camera.ATTRIBUTES;
            case LIGHT -> LightAttribute.ALL;
            case BANK -> Bank.ATTRIBUTES;
            case NODE -> List.of();
        };
        return Texts.of(known.stream().filter(a -> a.name().equals(track.attribute())).map(Attribute::title).findFirst()
                .orElse(track.attribute()));
    }
}
