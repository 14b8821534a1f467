package lightning.editor.window.timeline;

import java.util.ArrayList;
import java.util.List;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;
import lightning.scene.shot.TrackTarget;

/** One line of the timeline: what has keys, and below it each of its attributes. */
sealed interface TimelineRow {
    /** What has keys. */
    TrackTarget target();

    /** The keys in the line. */
    List<Track> tracks();

    /** Of a thing; in its line are the keys of all of its attributes. */
    record ObjectRow(TrackTarget target, List<Track> tracks) implements TimelineRow {}

    /** Of one attribute. */
    record TrackRow(Track track) implements TimelineRow {
        @Override
        public TrackTarget target() {
            return track.target();
        }

        @Override
        public List<Track> tracks() {
            return List.of(track);
        }
    }

    static List<TimelineRow> of(Shot shot) {
        List<TimelineRow> rows = new ArrayList<>();
        TrackTarget last = null;
        for (Track track : shot.tracks()) {
            if (!track.target().equals(last)) {
                last = track.target();
                TrackTarget target = last;
                rows.add(new ObjectRow(target, shot.tracks().stream().filter(t -> t.target().equals(target)).toList()));
            }
            rows.add(new TrackRow(track));
        }
        return rows;
    }
}
