package lightning.editor.window.widget;

import javafx.geometry.Insets;
import javafx.geometry.VPos;
import javafx.scene.layout.Background;
import javafx.scene.layout.BackgroundFill;
import javafx.scene.layout.CornerRadii;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;
import javafx.scene.text.Font;
import javafx.scene.text.FontWeight;
import javafx.scene.text.Text;

/** Note that looks like {@code .badge} before style sheets are loaded. */
final class UnstyledNote extends Region {
    private static final Insets PADDING = new Insets(3, 8, 3, 8);
    private static final double FONT_SIZE = 12;

    private final Text text;

    UnstyledNote(String message) {
        text = new Text(message);
        setId("first-words");
        text.setFont(Font.font(Font.getDefault().getFamily(), FontWeight.BOLD, FONT_SIZE));
        text.setFill(Color.WHITE);
        text.setTextOrigin(VPos.TOP);
        setBackground(new Background(new BackgroundFill(Color.web("#b7791fe6"), new CornerRadii(4), Insets.EMPTY)));
        setPadding(PADDING);
        setMouseTransparent(true);
        getChildren().add(text);
    }

    @Override
    protected double computePrefWidth(double height) {
        return Math.ceil(text.getLayoutBounds().getWidth()) + PADDING.getLeft() + PADDING.getRight();
    }

    @Override
    protected double computePrefHeight(double width) {
        return Math.ceil(text.getLayoutBounds().getHeight()) + PADDING.getTop() + PADDING.getBottom();
    }

    @Override
    protected void layoutChildren() {
        text.relocate(PADDING.getLeft(), PADDING.getTop());
    }
}
