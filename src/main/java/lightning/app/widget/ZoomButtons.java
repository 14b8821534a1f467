package lightning.app.widget;

import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignF;
import org.kordamp.ikonli.materialdesign2.MaterialDesignN;

/** Fit and 1:1 of a picture; its wheel does the rest. */
public final class ZoomButtons {
    private ZoomButtons() {}

    public static Node of(PictureView picture, String id) {
        var box = new HBox(button(id + "-fit", "Fit", MaterialDesignF.FIT_TO_PAGE_OUTLINE,
                "The whole picture.\nThe wheel zooms, the middle button moves.", picture::fit),
                button(id + "-one-to-one", "1:1", MaterialDesignN.NUMERIC_1_BOX_OUTLINE,
                        "One pixel of the picture is one of the screen's.", picture::oneToOne));
        box.setAlignment(javafx.geometry.Pos.CENTER);
        return box;
    }

    private static Button button(String id, String title, Ikon icon, String help, Runnable action) {
        var button = new Button("", new FontIcon(icon));
        button.setId(id);
        button.setAccessibleText(title);
        button.setTooltip(new Tooltip(title + "\n" + help));
        button.getStyleClass().add("button-icon");
        button.setOnAction(_ -> action.run());
        return button;
    }
}
