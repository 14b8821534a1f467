package lightning.editor.window.timeline;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import javafx.css.PseudoClass;
import javafx.scene.layout.Pane;
import javafx.scene.layout.Region;
import lightning.base.text.Messages;
import lightning.document.KeyId;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.Track;

/** Keyframe marks of a row. Overlapping keyframes share one mark. */
final class KeyframeLane extends Pane {
    private static final PseudoClass CHOSEN = PseudoClass.getPseudoClass("chosen");
    private static final double KEY_SIZE = 10;
    /** Minimum distance of two marks, pixels; closer keyframes share a mark. */
    private static final double MIN_DISTANCE = 2;

    KeyframeLane() {
        getStyleClass().add("lane");
    }

    /** Keyframes of a mark, stored with its node. */
    record KeyMark(List<KeyId> keys) {}

    /**
     * Shows a row's keyframes.
     *
     * @param height height of the row, pixels
     */
    void show(TimelineRow row, FrameScale scale, Set<KeyId> chosen, double height) {
        List<Region> marks = new ArrayList<>();
        Set<Long> occupied = new HashSet<>();
        for (Track track : row.tracks()) {
            for (Keyframe key : track.keys()) {
                if (scale.isVisible(key.frame()) && occupied.add((long) (scale.x(key.frame()) / MIN_DISTANCE))) {
                    marks.add(mark(row, track, key, scale, chosen, height));
                }
            }
        }
        getChildren().setAll(marks);
    }

    private static Region mark(TimelineRow row, Track track, Keyframe key, FrameScale scale, Set<KeyId> chosen, double height) {
        List<KeyId> places = row.tracks().stream().filter(t -> row instanceof TimelineRow.TrackRow || t.key(key.frame()).isPresent())
                .map(t -> new KeyId(t.target(), t.attribute(), key.frame())).toList();
        var mark = new Region();
        mark.setUserData(new KeyMark(places));
        mark.getStyleClass().addAll("key",
                row instanceof TimelineRow.ObjectRow ? "together" : key.interpolation().name().toLowerCase(Locale.ROOT));
        mark.pseudoClassStateChanged(CHOSEN, chosen.containsAll(places));
        mark.setAccessibleText(Messages.tr("{0} at frame {1}", TrackNames.name(track), key.frame()));
        if (row instanceof TimelineRow.TrackRow) {
            mark.setId("key-" + track.target().name().replace(' ', '-') + "-" + track.attribute() + "-" + key.frame());
        }
        double width = row instanceof TimelineRow.ObjectRow ? KEY_SIZE / 2 : KEY_SIZE;
        mark.resizeRelocate(scale.x(key.frame()) - width / 2, (height - KEY_SIZE) / 2, width, KEY_SIZE);
        mark.setManaged(false);
        return mark;
    }
}
