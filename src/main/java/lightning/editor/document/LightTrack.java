package lightning.editor.document;

import java.util.List;
import lightning.scene.Light;
import lightning.scene.shot.Track;

/**
 * The history of one light alone, in chains that several states of the document share.
 *
 * @param past   what it was, the latest first; null where there is nothing
 * @param future what was undone, the next to redo first; null where there is nothing
 */
record LightTrack(Link past, Link future) {
    static final LightTrack EMPTY = new LightTrack(null, null);

    /** @param keys the light's own */
    record Link(Light light, List<Track> keys, Link rest) {}

    LightTrack edited(Light old, List<Track> keys) {
        return new LightTrack(new Link(old, keys, past), null);
    }

    LightTrack undone(Light now, List<Track> keys) {
        return new LightTrack(past.rest(), new Link(now, keys, future));
    }

    LightTrack redone(Light now, List<Track> keys) {
        return new LightTrack(new Link(now, keys, past), future.rest());
    }
}
