package lightning.editor.window.sequence;

import javafx.util.StringConverter;
import lightning.base.text.Messages;
import lightning.scene.shot.Shot;

/** Frame of each shot that its picture shows. */
enum SheetMoment {
    FIRST, MIDDLE, LAST;

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

    int frame(Shot shot) {
        return switch (this) {
            case FIRST -> shot.first();
            case MIDDLE -> shot.first() + (shot.last() - shot.first()) / 2;
            case LAST -> shot.last();
        };
    }

    private String title() {
        return switch (this) {
            case FIRST -> Messages.tr("First Frame");
            case MIDDLE -> Messages.tr("Middle Frame");
            case LAST -> Messages.tr("Last Frame");
        };
    }
}
