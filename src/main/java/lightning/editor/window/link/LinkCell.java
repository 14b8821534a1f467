package lightning.editor.window.link;

import static java.util.Objects.requireNonNull;

import javafx.css.PseudoClass;
import javafx.geometry.HPos;
import javafx.geometry.VPos;
import javafx.scene.control.Label;
import javafx.scene.layout.Region;
import lightning.document.LinkTable;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/** Cell of a link: a bar as long as the gain, and the gain in percent unless it is 100. Empty if the object is not linked. */
final class LinkCell extends Region {
    private static final PseudoClass OFF = PseudoClass.getPseudoClass("off");
    private static final PseudoClass MIXED = PseudoClass.getPseudoClass("mixed");
    private static final PseudoClass INHERITED = PseudoClass.getPseudoClass("inherited");
    private static final PseudoClass CURRENT = PseudoClass.getPseudoClass("chosen");
    private static final PseudoClass LINE = PseudoClass.getPseudoClass("line");
    private static final double MARGIN = 2;
    /** Placeholder of a gain that differs among the objects of a group. */
    private static final String DIFFERENT = "~";

    private final Region bar = new Region();
    private final Label text = new Label();
    private LinkTable.@Nullable Link link;

    LinkCell() {
        getStyleClass().add("link-cell");
        bar.getStyleClass().add("link-bar");
        text.setMouseTransparent(true);
        bar.setMouseTransparent(true);
        getChildren().addAll(bar, text);
        setMouseTransparent(true);
    }

    /**
     * Shows a link.
     *
     * @param isCurrent true if the keyboard acts on it
     * @param isOnLine  true if it is in the row or column of the pointer, or in that of the selected light
     */
    void show(LinkTable.Link newLink, boolean isCurrent, boolean isOnLine) {
        pseudoClassStateChanged(CURRENT, isCurrent);
        pseudoClassStateChanged(LINE, isOnLine);
        if (!newLink.equals(link)) {
            link = newLink;
            pseudoClassStateChanged(OFF, link.state() == LinkTable.State.OFF);
            pseudoClassStateChanged(MIXED, link.state() == LinkTable.State.MIXED);
            pseudoClassStateChanged(INHERITED, !link.isOwn() && link.gain() != 1);
            text.setText(text(link));
            setAccessibleText(link.describe());
            requestLayout();
        }
    }

    LinkTable.Link link() {
        return requireNonNull(link);
    }

    static String text(LinkTable.Link link) {
        return link.state() == LinkTable.State.OFF ? ""
                : link.hasOthers() ? DIFFERENT : link.gain() == 1 ? "" : SceneLimits.format(Math.rint(link.gain() * 1000) / 10);
    }

    @Override
    protected void layoutChildren() {
        double width = link == null || link.state() == LinkTable.State.OFF ? 0 : (getWidth() - 2 * MARGIN) * Math.min(1, link.gain());
        bar.resizeRelocate(MARGIN, MARGIN, width, getHeight() - 2 * MARGIN);
        layoutInArea(text, 0, 0, getWidth(), getHeight(), 0, HPos.CENTER, VPos.CENTER);
    }
}
