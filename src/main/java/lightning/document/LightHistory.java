package lightning.document;

import static java.util.Objects.requireNonNull;

import java.util.List;
import lightning.scene.light.Light;
import lightning.scene.shot.Track;
import org.jspecify.annotations.Nullable;

/**
 * History of one light, as linked lists that several states of the document share.
 *
 * @param past   previous states, newest first; null if none
 * @param future undone states, next to redo first; null if none
 */
record LightHistory(@Nullable Entry past, @Nullable Entry future) {
    static final LightHistory EMPTY = new LightHistory(null, null);

    /** @param keys keyframe tracks of the light */
    record Entry(Light light, List<Track> keys, @Nullable Entry next) {}

    LightHistory afterEdit(Light previous, List<Track> keys) {
        return new LightHistory(new Entry(previous, keys, past), null);
    }

    LightHistory afterUndo(Light current, List<Track> keys) {
        return new LightHistory(requireNonNull(past).next(), new Entry(current, keys, future));
    }

    LightHistory afterRedo(Light current, List<Track> keys) {
        return new LightHistory(new Entry(current, keys, past), requireNonNull(future).next());
    }
}
