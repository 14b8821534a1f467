package lightning.editor.window.timeline;

import java.util.ArrayList;
import java.util.List;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Target;
import lightning.scene.shot.Track;

/** One line of the timeline: what has keys, and below it each of its attributes. */
sealed interface Row {
    /** What has keys. */
    Target target();

    /** The keys in the line. */
    List<Track> tracks();

    /** Of a thing; in its line are the keys of all of its attributes. */
    record OfThing(Target target, List<Track> tracks) implements Row {}

    /** Of one attribute. */
    record OfTrack(Track track) implements Row {
        @Override
        public Target target() {
            return track.target();
        }

        @Override
        public List<Track> tracks() {
            return List.of(track);
        }
    }

    static List<Row> of(Shot shot) {
        List<Row> rows = new ArrayList<>();
        Target last = null;
        for (Track track : shot.tracks()) {
            if (!track.target().equals(last)) {
                last = track.target();
                Target target = last;
                rows.add(new OfThing(target, shot.tracks().stream().filter(t -> t.target().equals(target)).toList()));
            }
            rows.add(new OfTrack(track));
        }
        return rows;
    }
}
