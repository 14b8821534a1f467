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

/** A remark that looks as those of style sheets do ({@code .badge}), where there are none yet. */
final class PlainNote extends Region {
    private static final Insets AROUND = new Insets(3, 8, 3, 8);
    private static final double SIZE = 12;

    private final Text text;

    PlainNote(String words) {
        text = new Text(words);
        setId("first-words");
        text.setFont(Font.font(Font.getDefault().getFamily(), FontWeight.BOLD, SIZE));
        text.setFill(Color.WHITE);
        text.setTextOrigin(VPos.TOP);
        setBackground(new Background(new BackgroundFill(Color.web("#b7791fe6"), new CornerRadii(4), Insets.EMPTY)));
        setPadding(AROUND);
        setMouseTransparent(true);
        getChildren().add(text);
    }

    @Override
    protected double computePrefWidth(double height) {
        return Math.ceil(text.getLayoutBounds().getWidth()) + AROUND.getLeft() + AROUND.getRight();
    }

    @Override
    protected double computePrefHeight(double width) {
        return Math.ceil(text.getLayoutBounds().getHeight()) + AROUND.getTop() + AROUND.getBottom();
    }

    @Override
    protected void layoutChildren() {
        text.relocate(AROUND.getLeft(), AROUND.getTop());
    }
}
