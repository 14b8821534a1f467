package lightning.document;

import lightning.scene.SceneElement;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.Track;

/** Identifier of one keyframe of a shot. */
public record KeyId(SceneElement<?> target, String attribute, int frame) {
    static KeyId of(Track track, Keyframe key) {
        return new KeyId(track.target(), track.attribute(), key.frame());
    }

    /** Returns the keyframe of the same attribute some frames later. */
    public KeyId shifted(int frames) {
        return new KeyId(target, attribute, frame + frames);
    }
}
