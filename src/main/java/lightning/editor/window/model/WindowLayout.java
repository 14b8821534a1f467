package lightning.editor.window.model;

import static java.util.Objects.requireNonNull;

import java.util.Map;
import java.util.function.Supplier;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.beans.property.SimpleObjectProperty;
import lightning.base.text.Messages;
import lightning.document.PictureArea;
import lightning.editor.Command;

/** Layout of the window: sizes and visibility of pictures, panels and timeline. */
public final class WindowLayout {
    /** Maximum size of a dock, pixels. A larger stored value is an invalid preference. */
    private static final double MAX_DOCK_SIZE = 32_768;
    private static final CanvasLayout INITIAL_CANVASES = CanvasLayout.PICTURE_LARGE;

    private final ObjectProperty<CanvasLayout> canvasLayout = new SimpleObjectProperty<>(INITIAL_CANVASES);
    private final ObjectProperty<WorkingSize> workingSize = new SimpleObjectProperty<>(WorkingSize.SCENE);
    private final ObjectProperty<InsetPlace> insetPlace = new SimpleObjectProperty<>(InsetPlace.INITIAL);
    private final BooleanProperty panelsHidden = new SimpleBooleanProperty();

    private final BooleanProperty welcomeAtStart = new SimpleBooleanProperty(true);
    private Supplier<PictureArea> pictureArea = () -> PictureArea.DEFAULT;
    private final ObjectProperty<PanelArrangement> panels = new SimpleObjectProperty<>(PanelArrangement.INITIAL);
    private final Map<PanelPlace, DoubleProperty> dockSizes =
            Map.of(PanelPlace.LEFT, new SimpleDoubleProperty(), PanelPlace.BELOW, new SimpleDoubleProperty());
    private final BooleanProperty timelineShown = new SimpleBooleanProperty();
    private final BooleanProperty filmStripShown = new SimpleBooleanProperty();

    /** Arrangement of the traced picture and the preview. */
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

        /** Returns whether the preview is an inset in a corner of the traced picture. */
        public boolean hasInset() {
            return this == PICTURE_LARGE;
        }

        /** Returns the traced picture's share of the width; 1 or 0 if only one of both is shown. */
        public double share() {
            return share;
        }

        @Override
        public String toString() {
            return Messages.tr(title);
        }
    }

    /** Creates the layout with both pictures and no panel. */
    public WindowLayout() {
        panels.subscribe(now -> timelineShown.set(now.isShown(Command.TIMELINE)));
        timelineShown.subscribe(on -> {
            PanelArrangement now = panels.get();
            if (on != now.isShown(Command.TIMELINE)) {
                panels.set(on ? now.open(Command.TIMELINE) : now.close(Command.TIMELINE));
            }
        });
    }

    /** Makes the commands show the inset and apply their presets. */
    void register(CommandRegistry commands) {
        commands.setToggle(Command.PREVIEW_INSET, canvasLayout.map(CanvasLayout::hasInset), () -> canvasLayout
                .set(canvasLayout.get().hasInset() ? CanvasLayout.PICTURE_ALONE : CanvasLayout.PICTURE_LARGE));
        for (ArrangementPreset preset : ArrangementPreset.values()) {
            commands.setAction(preset.command(), () -> preset.apply(this));
        }
    }

    /** Places of the panels. */
    public ObjectProperty<PanelArrangement> panelsProperty() {
        return panels;
    }

    /** Width of the left dock or height of the lower one, pixels; 0 for the default. */
    public DoubleProperty dockSizeProperty(PanelPlace dock) {
        return requireNonNull(dockSizes.get(dock));
    }

    public ObjectProperty<CanvasLayout> canvasLayoutProperty() {
        return canvasLayout;
    }

    /** Size in which the picture is traced while the scene is edited; that of the scene before preferences are restored. */
    public ObjectProperty<WorkingSize> workingSizeProperty() {
        return workingSize;
    }

    /** Place of the preview when it is an inset. */
    public ObjectProperty<InsetPlace> insetPlaceProperty() {
        return insetPlace;
    }

    /** True if lists, properties and the tool bar are hidden. */
    public BooleanProperty panelsHiddenProperty() {
        return panelsHidden;
    }

    /** True if the timeline is open and not behind another panel. Initially true for scenes with a shot. */
    public BooleanProperty timelineShownProperty() {
        return timelineShown;
    }

    /** True if the timeline shows its filmstrip. */
    public BooleanProperty filmStripShownProperty() {
        return filmStripShown;
    }

    /** True if the welcome page opens with the start scene. Initially true. */
    public BooleanProperty welcomeAtStartProperty() {
        return welcomeAtStart;
    }

    /** Returns the area in which the traced picture is shown. */
    public PictureArea pictureArea() {
        return pictureArea.get();
    }

    /** Sets the source of {@link #pictureArea}. */
    public void setPictureArea(Supplier<PictureArea> source) {
        pictureArea = source;
    }

    /** Restores the arrangement. Panels are always shown at startup; the timeline is if the document has a shot. */
    public void restore(Preferences preferences) {
        canvasLayout.set(preferences.enumValue("arrangement", INITIAL_CANVASES));
        workingSize.set(WorkingSize.of(preferences));
        insetPlace.set(new InsetPlace(preferences.enumValue("inset.corner", InsetPlace.INITIAL.corner()),
                preferences.number("inset.size", InsetPlace.MIN_SIZE, 1, InsetPlace.INITIAL.size())));
        welcomeAtStart.set(!preferences.hasValue("welcome", "false"));
        dockSizes.forEach((dock, size) -> size.set(preferences.number("dock." + dock.name(), 0, MAX_DOCK_SIZE, 0)));
        PanelArrangement stored = PanelArrangement.parse(preferences.text("panels", ""));
        panels.set(timelineShown.get() ? stored.open(Command.TIMELINE) : stored.close(Command.TIMELINE));
    }

    /** Stores the arrangement. */
    public void save(Preferences preferences) {
        preferences.set("arrangement", canvasLayout.get().name());
        preferences.set("working-size", workingSize.get().name());
        preferences.set("inset.corner", insetPlace.get().corner().name());
        preferences.set("inset.size", insetPlace.get().size());
        preferences.set("welcome", welcomeAtStart.get());
        dockSizes.forEach((dock, size) -> preferences.set("dock." + dock.name(), size.get()));
        preferences.set("panels", panels.get().format());
    }
}
