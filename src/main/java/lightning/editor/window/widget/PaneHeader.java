package lightning.editor.window.widget;

import java.util.ArrayList;
import java.util.List;
import javafx.geometry.VPos;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.Region;

/** Header of a pane: title and controls, wrapped to more rows if the pane is narrow. */
public final class PaneHeader extends FlowPane {

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
    }
}
