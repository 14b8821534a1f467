package lightning.editor.window.model;

import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import lightning.base.text.Texts;

/** How the window's room is given to the pictures, and to what stands around them. */
public final class Arrangement {
    private final ObjectProperty<Canvases> canvases = new SimpleObjectProperty<>(Canvases.SIDE_BY_SIDE);
    private final BooleanProperty panelsHidden = new SimpleBooleanProperty();

    private final BooleanProperty timelineShown = new SimpleBooleanProperty();
    private final BooleanProperty filmStripShown = new SimpleBooleanProperty();

    /** Which of the two pictures are seen, and how large. */
    public enum Canvases {
        SIDE_BY_SIDE(Texts.key("Side by Side"), 0.5), PICTURE_LARGE(Texts.key("Traced Picture Large"), 0.72),
        PREVIEW_LARGE(Texts.key("Preview Large"), 0.28),
        PICTURE_ALONE(Texts.key("Traced Picture Alone"), 1), PREVIEW_ALONE(Texts.key("Preview Alone"), 0);

        private final String title;
        private final double share;

        Canvases(String title, double share) {
            this.title = title;
            this.share = share;
        }

        /** The traced picture's share of the width; 1 and 0 where one is alone. */
        public double share() {
            return share;
        }

        @Override
        public String toString() {
            return Texts.of(title);
        }
    }

    public ObjectProperty<Canvases> canvasesProperty() {
        return canvases;
    }

    /** Whether lists, properties and the tool bar are hidden. */
    public BooleanProperty panelsHiddenProperty() {
        return panelsHidden;
    }

    /** Whether the keys of the shot are seen below the pictures; when a scene is opened, where it has a shot. */
    public BooleanProperty timelineShownProperty() {
        return timelineShown;
    }

    /** Whether the timeline has its film strip. */
    public BooleanProperty filmStripShownProperty() {
        return filmStripShown;
    }

    /** As it was left. The panels are shown in any case: without them nobody would find anything. */
    public void restore(Preferences preferences) {
        canvases.set(preferences.choice("arrangement", Canvases.SIDE_BY_SIDE));
    }

    /** Keeps what is restored. */
    public void remember(Preferences preferences) {
        preferences.set("arrangement", canvases.get().name());
    }
}
