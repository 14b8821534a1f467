package lightning.editor.window.timeline;

import java.util.ArrayList;
import java.util.List;
import lightning.scene.SceneElement;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;

/** Row of the timeline: an animated object, or below it one of its attributes. */
sealed interface TimelineRow {
    /** Returns the animated object. */
    SceneElement<?> target();

    /** Returns the tracks whose keyframes the row shows. */
    List<Track> tracks();

    /** Row of an object, with the keyframes of all of its attributes. */
    record ObjectRow(SceneElement<?> target, List<Track> tracks) implements TimelineRow {}

    /** Row of one attribute. */
    record TrackRow(Track track) implements TimelineRow {
        @Override
        public SceneElement<?> target() {
            return track.target();
        }

        @Override
        public List<Track> tracks() {
            return List.of(track);
        }
    }

    static List<TimelineRow> of(Shot shot) {
        List<TimelineRow> rows = new ArrayList<>();
        SceneElement<?> last = null;
        for (Track track : shot.tracks()) {
            if (!track.target().equals(last)) {
                last = track.target();
                SceneElement<?> target = last;
                rows.add(new ObjectRow(target, shot.tracks().stream().filter(t -> t.target().equals(target)).toList()));
            }
            rows.add(new TrackRow(track));
        }
        return rows;
    }
}
