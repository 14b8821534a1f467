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
record LightHistory(Entry past, Entry future) {
    static final LightHistory EMPTY = new LightHistory(null, null);

    /** @param keys the light's own */
    record Entry(Light light, List<Track> keys, Entry next) {}

    LightHistory afterEdit(Light previous, List<Track> keys) {
        return new LightHistory(new Entry(previous, keys, past), null);
    }

    LightHistory afterUndo(Light current, List<Track> keys) {
        return new LightHistory(past.next(), new Entry(current, keys, future));
    }

    LightHistory afterRedo(Light current, List<Track> keys) {
        return new LightHistory(new Entry(current, keys, past), future.next());
    }
}
