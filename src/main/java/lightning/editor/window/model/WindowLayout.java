package lightning.editor.window.model;

import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import lightning.base.text.Messages;

/** How the window's room is given to the pictures, and to what stands around them. */
public final class WindowLayout {
    private final ObjectProperty<CanvasLayout> canvasLayout = new SimpleObjectProperty<>(CanvasLayout.SIDE_BY_SIDE);
    private final BooleanProperty panelsHidden = new SimpleBooleanProperty();

    private final BooleanProperty timelineShown = new SimpleBooleanProperty();
    private final BooleanProperty filmStripShown = new SimpleBooleanProperty();

    /** Which of the two pictures are seen, and how large. */
    public enum CanvasLayout {
        SIDE_BY_SIDE(Messages.key("Side by Side"), 0.5), PICTURE_LARGE(Messages.key("Render Large"), 0.72),
        PREVIEW_LARGE(Messages.key("Preview Large"), 0.28),
        PICTURE_ALONE(Messages.key("Render Only"), 1), PREVIEW_ALONE(Messages.key("Preview Only"), 0);

        private final String title;
        private final double share;

        CanvasLayout(String title, double share) {
            this.title = title;
            this.share = share;
        }

        /** The traced picture's share of the width; 1 and 0 where one is alone. */
        public double share() {
            return share;
        }

        @Override
        public String toString() {
            return Messages.tr(title);
        }
    }

    public ObjectProperty<CanvasLayout> canvasLayoutProperty() {
        return canvasLayout;
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
        canvasLayout.set(preferences.enumValue("arrangement", CanvasLayout.SIDE_BY_SIDE));
    }

    /** Keeps what is restored. */
    public void save(Preferences preferences) {
        preferences.set("arrangement", canvasLayout.get().name());
    }
}
