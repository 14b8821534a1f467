package lightning.editor.window.property;

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

/** How properties are laid out: sections below each other, which can be folded and are scrolled. */
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
                // Kept as one picture, all of it would be drawn again for each number that a drag changes.
                scroll.lookup(".viewport").setCache(false);
            }
        });
        return scroll;
    }

    /**
     * As {@link #scroll}, where all is made one after the other, so that the window's thread is never away for long.
     *
     * @param parts makes a part each, put by {@link #add} into what it is given or into what was put there
     */
    static ScrollPane incrementalScroll(Function<VBox, Stream<Runnable>> parts) {
        ScrollPane scroll = scroll();
        var box = (VBox) scroll.getContent();
        TimeSlicedTask.whileVisible(box, parts.apply(box).iterator());
        return scroll;
    }

    /** Puts a node below the others, with its looks. */
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

    /** A word as it begins a label. */
    static String title(String word) {
        String local = Messages.tr(word.toLowerCase(Locale.ROOT));
        return local.substring(0, 1).toUpperCase(Locale.ROOT) + local.substring(1);
    }

    static Label caption(String text) {
        var label = new Label(text);
        label.getStyleClass().add("caption");
        return label;
    }
}
