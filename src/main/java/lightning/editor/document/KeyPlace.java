package lightning.editor.document;

import lightning.scene.shot.Key;
import lightning.scene.shot.Target;
import lightning.scene.shot.Track;

/** One key of a shot. */
public record KeyPlace(Target target, String attribute, int frame) {
    static KeyPlace of(Track track, Key key) {
        return new KeyPlace(track.target(), track.attribute(), key.frame());
    }

    /** The key of the same attribute some frames later. */
    public KeyPlace later(int frames) {
        return new KeyPlace(target, attribute, frame + frames);
    }
}
