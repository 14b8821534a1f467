package lightning.editor.window.sequence;

import java.util.List;
import java.util.stream.Stream;
import javafx.util.StringConverter;
import lightning.base.text.Messages;
import lightning.scene.shot.Shot;

/** Frames of each shot that its pictures show. */
enum SheetMoment {
    FIRST, MIDDLE, LAST,
    /** The first, the middle and the last frame. */
    ALL;

    /** Titles in a menu. */
    static final StringConverter<SheetMoment> TITLES = new StringConverter<>() {
        @Override
        public String toString(SheetMoment value) {
            return value.title();
        }

        @Override
        public SheetMoment fromString(String text) {
            throw new UnsupportedOperationException();
        }
    };

    /** Returns one to three different frames, ascending. */
    List<Integer> frames(Shot shot) {
        int middle = shot.first() + (shot.last() - shot.first()) / 2;
        return switch (this) {
            case FIRST -> List.of(shot.first());
            case MIDDLE -> List.of(middle);
            case LAST -> List.of(shot.last());
            case ALL -> Stream.of(shot.first(), middle, shot.last()).distinct().toList();
        };
    }

    private String title() {
        return switch (this) {
            case FIRST -> Messages.tr("First Frame");
            case MIDDLE -> Messages.tr("Middle Frame");
            case LAST -> Messages.tr("Last Frame");
            case ALL -> Messages.tr("First, Middle and Last Frame");
        };
    }
}
