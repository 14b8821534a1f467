package lightning.editor.window.property;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.TitledPane;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.editor.window.widget.TimeSlicedTask;

/** Layout of properties: scrollable, collapsible sections. */
final class SectionLayout {
    private SectionLayout() {}

    static ScrollPane scroll(Node... sections) {
        var box = new VBox(sections);
        box.getStyleClass().add("sections");
        var scroll = new ScrollPane(box);
        scroll.setFitToWidth(true);
        scroll.setHbarPolicy(ScrollPane.ScrollBarPolicy.NEVER);
        scroll.skinProperty().subscribe(skin -> {
            if (skin != null) {
                // A cached viewport would be redrawn completely for every number changed by a drag.
                scroll.lookup(".viewport").setCache(false);
            }
        });
        return scroll;
    }

    /**
     * Creates a scroll pane as {@link #scroll} does and fills it in time slices, so that the window's thread is never blocked for long.
     *
     * @param parts  steps that each create a part and {@link #add} it to the given box or to an earlier part
     */
    static ScrollPane incrementalScroll(Function<VBox, Stream<Runnable>> parts) {
        ScrollPane scroll = scroll();
        var box = (VBox) scroll.getContent();
        TimeSlicedTask.whileVisible(box, parts.apply(box).iterator());
        return scroll;
    }

    /** Appends a node and applies its style. */
    static void add(VBox box, Node node) {
        box.getChildren().add(node);
        TimeSlicedTask.applyStyle(node);
    }

    static TitledPane section(String title, Node... widgets) {
        var content = new VBox(widgets);
        content.getStyleClass().add("section-content");
        var pane = new TitledPane(title, content);
        pane.setAnimated(false);
        pane.getStyleClass().addAll("dense", "section");
        return pane;
    }

    /** Returns the column of widgets of a section. */
    static VBox content(TitledPane section) {
        return (VBox) section.getContent();
    }

    /** Returns a column of rows in a section. */
    @SafeVarargs
    static VBox column(List<? extends Node>... rows) {
        var column = new VBox(nodes(rows));
        column.getStyleClass().add("section-rows");
        return column;
    }

    @SafeVarargs
    static Node[] nodes(List<? extends Node>... rows) {
        return Arrays.stream(rows).flatMap(List::stream).toArray(Node[]::new);
    }

    static void setShown(Node node, boolean isShown) {
        node.setVisible(isShown);
        node.setManaged(isShown);
    }

    /** Returns the translated word with a capital first letter. */
    static String title(String word) {
        String local = Messages.tr(word);
        return local.substring(0, 1).toUpperCase(Locale.ROOT) + local.substring(1);
    }

    static Label caption(String text) {
        var label = new Label(text);
        label.getStyleClass().add("caption");
        return label;
    }
}
