package lightning.editor.window.timeline;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import javafx.css.PseudoClass;
import javafx.scene.layout.Pane;
import javafx.scene.layout.Region;
import lightning.base.text.Texts;
import lightning.editor.document.KeyPlace;
import lightning.scene.shot.Key;
import lightning.scene.shot.Track;

/** The keys of a line at their frames. Those that would hide each other are one. */
final class Lane extends Pane {
    private static final PseudoClass CHOSEN = PseudoClass.getPseudoClass("chosen");
    private static final double SIZE = 10;
    /** Keys nearer than this are drawn once, pixels. */
    private static final double NEAR = 2;

    Lane() {
        getStyleClass().add("lane");
    }

    /** The key that a node stands for. */
    record Mark(List<KeyPlace> keys) {}

    /** @param height of the line, pixels */
    void show(Row row, FrameScale scale, Set<KeyPlace> chosen, double height) {
        List<Region> marks = new ArrayList<>();
        Set<Long> taken = new HashSet<>();
        for (Track track : row.tracks()) {
            for (Key key : track.keys()) {
                if (scale.shows(key.frame()) && taken.add((long) (scale.x(key.frame()) / NEAR))) {
                    marks.add(mark(row, track, key, scale, chosen, height));
                }
            }
        }
        getChildren().setAll(marks);
    }

    private static Region mark(Row row, Track track, Key key, FrameScale scale, Set<KeyPlace> chosen, double height) {
        List<KeyPlace> places = row.tracks().stream().filter(t -> row instanceof Row.OfTrack || t.key(key.frame()).isPresent())
                .map(t -> new KeyPlace(t.target(), t.attribute(), key.frame())).toList();
        var mark = new Region();
        mark.setUserData(new Mark(places));
        mark.getStyleClass().addAll("key", row instanceof Row.OfThing ? "together" : key.passage().name().toLowerCase(Locale.ROOT));
        mark.pseudoClassStateChanged(CHOSEN, chosen.containsAll(places));
        mark.setAccessibleText(Texts.of("{0} at frame {1}", Names.of(track), key.frame()));
        if (row instanceof Row.OfTrack) {
            mark.setId("key-" + track.target().name().replace(' ', '-') + "-" + track.attribute() + "-" + key.frame());
        }
        double width = row instanceof Row.OfThing ? SIZE / 2 : SIZE;
        mark.resizeRelocate(scale.x(key.frame()) - width / 2, (height - SIZE) / 2, width, SIZE);
        mark.setManaged(false);
        return mark;
    }
}
