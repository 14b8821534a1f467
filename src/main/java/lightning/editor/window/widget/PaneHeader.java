package lightning.editor.window.widget;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javafx.geometry.VPos;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.Region;

/**
 * Header of a pane: title and controls in one row. A narrow pane first leaves out the title, then controls that menus and keys replace; only
 * if that is not enough, the row wraps.
 */
public final class PaneHeader extends FlowPane {
    private final List<Saving> savings = new ArrayList<>();

    /** Way to make the row shorter. */
    private static final class Saving {
        private final DoubleSource width;
        private final Consumer<Boolean> action;
        private boolean isApplied;

        Saving(DoubleSource width, Consumer<Boolean> action) {
            this.width = width;
            this.action = action;
        }

        void apply(boolean on) {
            if (on != isApplied) {
                isApplied = on;
                action.accept(on);
            }
        }
    }

    /** Width in pixels, known once the node is styled. */
    private interface DoubleSource {
        double get();
    }

    public PaneHeader(String title, Node... controls) {
        var name = new Label(title);
        name.getStyleClass().add("pane-title");
        List<Node> nodes = new ArrayList<>(List.of(name));
        nodes.addAll(List.of(controls));
        for (Node part : nodes) {
            if (part instanceof Region region) {
                // Prevents truncated text.
                region.setMinWidth(Region.USE_PREF_SIZE);
            }
        }
        setRowValignment(VPos.CENTER);
        getStyleClass().add("pane-header");
        getChildren().setAll(nodes);
        withOptional(name);
        widthProperty().subscribe(_ -> requestLayout());
    }

    /** Leaves out controls in a narrow pane, in the given order. */
    public PaneHeader withOptional(Node... controls) {
        for (Node control : controls) {
            savings.add(new Saving(() -> control.prefWidth(-1) + getHgap(), hidden -> {
                control.setVisible(!hidden);
                control.setManaged(!hidden);
            }));
        }
        return this;
    }

    /**
     * Makes a control narrower in a narrow pane, after the parts that were named before.
     *
     * @param width pixels that it saves
     * @param narrow receives true to save the width
     */
    public PaneHeader withNarrow(double width, Consumer<Boolean> narrow) {
        savings.add(new Saving(() -> width, narrow));
        return this;
    }

    /** The parent asks for the height first: an earlier row would be laid out for a moment. */
    @Override
    protected double computePrefHeight(double width) {
        fit(width > 0 ? width : getWidth());
        return super.computePrefHeight(width);
    }

    private void fit(double width) {
        double excess = naturalWidth() - width;
        for (Saving saving : savings) {
            boolean save = width > 0 && excess > 0;
            excess -= save ? saving.width.get() : 0;
            saving.apply(save);
        }
    }

    /** Returns the width of a row without savings, pixels. */
    private double naturalWidth() {
        return snappedLeftInset() + snappedRightInset() - getHgap()
                + getManagedChildren().stream().mapToDouble(c -> c.prefWidth(-1) + getHgap()).sum()
                + savings.stream().filter(s -> s.isApplied).mapToDouble(s -> s.width.get()).sum();
    }
}
