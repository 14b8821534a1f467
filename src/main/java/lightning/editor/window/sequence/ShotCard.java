package lightning.editor.window.sequence;

import java.util.ArrayList;
import java.util.List;
import javafx.css.PseudoClass;
import javafx.scene.control.Label;
import javafx.scene.control.Tooltip;
import javafx.scene.image.ImageView;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.HBox;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.document.loop.ContactSheet;
import lightning.editor.window.widget.PixelImage;
import lightning.format.sequence.Sequence;

/** Card of a shot: pictures, name, and how many values are its own. */
final class ShotCard extends VBox {
    static final int WIDTH = 256;
    static final int HEIGHT = 144;
    private static final PseudoClass SELECTED = PseudoClass.getPseudoClass("selected");

    private final String shot;
    private final HBox frames = new HBox(2);
    private final List<ImageView> pictures = new ArrayList<>();
    private final Label overrides = new Label();
    private final Label problem = new Label();

    /** @param onChosen runs when the card is clicked, or chosen by Enter or Space */
    ShotCard(Sequence.Entry entry, Runnable onChosen) {
        shot = entry.name();
        setId("shot-" + shot);
        getStyleClass().addAll("look-card", "shot-card");
        setFocusTraversable(true);
        setOnMouseClicked(_ -> {
            requestFocus();
            onChosen.run();
        });
        setOnKeyPressed(e -> {
            if (e.getCode() == KeyCode.ENTER || e.getCode() == KeyCode.SPACE) {
                onChosen.run();
                e.consume();
            }
        });
        setPictureCount(1);
        overrides.getStyleClass().add("shot-overrides");
        problem.getStyleClass().add("look-problem");
        problem.setWrapText(true);
        problem.setMaxWidth(WIDTH);
        problem.setManaged(false);
        getChildren().addAll(frames, new Label(shot), overrides, problem);
        show(entry);
    }

    /** Shows how many values of a shot are its own. */
    void show(Sequence.Entry entry) {
        int count = entry.overrides().size();
        overrides.setText(count == 0 ? "" : count == 1 ? Messages.tr("1 value of its own") : Messages.tr("{0} values of its own", count));
        setAccessibleText(Messages.tr("shot {0}", shot) + (count == 0 ? "" : ", " + overrides.getText()));
        String text = String.join("\n", entry.overrides()) + (entry.note().isBlank() ? "" : "\n" + entry.note());
        Tooltip.install(this, new Tooltip(text.isBlank() ? entry.scene() : text.strip()));
    }

    /** Sets the number of pictures; existing ones stay if it is the same. */
    void setPictureCount(int count) {
        if (count == pictures.size()) {
            return;
        }
        pictures.clear();
        frames.getChildren().clear();
        for (int i = 0; i < count; i++) {
            var picture = new ImageView();
            var frame = new StackPane(picture);
            frame.getStyleClass().add("look-frame");
            frame.setMinSize(WIDTH, HEIGHT);
            frame.setMaxSize(WIDTH, HEIGHT);
            pictures.add(picture);
            frames.getChildren().add(frame);
        }
    }

    /** @param index number of the picture, from 0 */
    void show(int index, ContactSheet.SheetPicture newPicture) {
        ImageView picture = pictures.get(index);
        picture.setImage(PixelImage.of(newPicture.width(), newPicture.height(), newPicture.pixels()));
        boolean isCoarse = !newPicture.isExact();
        picture.setFitWidth(isCoarse ? WIDTH : 0);
        picture.setFitHeight(isCoarse ? HEIGHT : 0);
        picture.setPreserveRatio(true);
        setProblem("");
    }

    /** Shows why there is no picture; empty if there is one. */
    void setProblem(String text) {
        problem.setText(text);
        problem.setManaged(!text.isEmpty());
        pictures.forEach(picture -> picture.setVisible(text.isEmpty()));
    }

    String problem() {
        return problem.getText();
    }

    void setSelected(boolean isSelected) {
        pseudoClassStateChanged(SELECTED, isSelected);
    }
}
