package lightning.editor.window.cue;

import javafx.scene.control.Button;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.Tooltip;
import javafx.scene.image.ImageView;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.document.look.Cue;
import lightning.editor.window.widget.PixelImage;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import org.jspecify.annotations.Nullable;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignT;

/** Card of a look in the gallery: thumbnail, name and actions. */
final class CueCard extends VBox {
    private static final int WIDTH = 176;
    private static final int HEIGHT = 99;

    private final TextField name = new TextField();
    private final ToggleButton a = new ToggleButton("A");
    private final ToggleButton b = new ToggleButton("B");

    /** Actions of a card. */
    interface Callbacks {
        void restore(Cue cue);

        void rename(Cue cue, String name);

        void remove(Cue cue);

        void chooseA(Cue cue);

        void chooseB(Cue cue);
    }

    /**
     * Creates a card.
     *
     * @param thumbnail thumbnail from {@link #thumbnail}; null if there is none
     */
    CueCard(Cue cue, @Nullable CueThumbnail thumbnail, Callbacks callbacks) {
        setId("cue-" + cue.name());
        getStyleClass().add("cue-card");
        var frame = new StackPane();
        frame.getStyleClass().add("cue-frame");
        frame.setMinSize(WIDTH, HEIGHT);
        frame.setMaxSize(WIDTH, HEIGHT);
        if (thumbnail == null) {
            frame.getChildren().add(new Label(Messages.tr("no image")));
        } else {
            frame.getChildren().add(new ImageView(PixelImage.of(thumbnail.width, thumbnail.height, thumbnail.pixels)));
        }
        name.setId("cue-name-" + cue.name());
        name.setText(cue.name());
        name.setAccessibleText(Messages.tr("name of look {0}", cue.name()));
        name.setOnAction(_ -> callbacks.rename(cue, name.getText().strip()));
        name.addEventHandler(KeyEvent.KEY_PRESSED, e -> {
            if (e.getCode() == KeyCode.ESCAPE && !name.getText().equals(cue.name())) {
                name.setText(cue.name());
                e.consume();
            }
        });
        name.focusedProperty().subscribe(focused -> {
            if (!focused) {
                name.setText(cue.name());
            }
        });
        var restore = new Button(Messages.tr("Apply"));
        restore.setId("cue-restore-" + cue.name());
        restore.setTooltip(new Tooltip(Messages.tr("Apply this look to the scene")));
        restore.setOnAction(_ -> callbacks.restore(cue));
        a.setId("cue-a-" + cue.name());
        a.setTooltip(new Tooltip(Messages.tr("Use this look as A")));
        a.setAccessibleText(Messages.tr("{0} as A", cue.name()));
        a.setOnAction(_ -> callbacks.chooseA(cue));
        b.setId("cue-b-" + cue.name());
        b.setTooltip(new Tooltip(Messages.tr("Use this look as B")));
        b.setAccessibleText(Messages.tr("{0} as B", cue.name()));
        b.setOnAction(_ -> callbacks.chooseB(cue));
        var remove = new Button("", new FontIcon(MaterialDesignT.TRASH_CAN_OUTLINE));
        remove.setId("cue-remove-" + cue.name());
        remove.setAccessibleText(Messages.tr("delete look {0}", cue.name()));
        remove.setTooltip(new Tooltip(Messages.tr("Delete Look")));
        remove.setOnAction(_ -> callbacks.remove(cue));
        for (var control : new ButtonBase[] {restore, a, b}) {
            control.setDisable(cue.lighting().isEmpty());
        }
        var buttons = new HBox(restore, a, b, remove);
        buttons.getStyleClass().add("cue-buttons");
        getChildren().addAll(frame, name, buttons);
        if (cue.lighting().isEmpty()) {
            var problem = new Label(cue.problem());
            problem.setId("cue-problem-" + cue.name());
            problem.setWrapText(true);
            problem.setMaxWidth(WIDTH);
            problem.getStyleClass().add("cue-problem");
            getChildren().add(problem);
        }
    }

    /** Thumbnail of a look at the size of a card: {@code int[width * height]}, opaque. */
    record CueThumbnail(int width, int height, int[] pixels) {
        // Immutable by convention: the array is written only before construction.
    }

    /** Downscales a film by nearest-neighbor sampling at pixel centers. */
    static CueThumbnail thumbnail(Film film) {
        double shrink = Math.max(1, Math.max((double) film.width() / WIDTH, (double) film.height() / HEIGHT));
        int width = (int) Math.max(1, film.width() / shrink);
        int height = (int) Math.max(1, film.height() / shrink);
        float[] rgb = new float[3 * width * height];
        for (int y = 0, i = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int px = (int) ((2L * x + 1) * film.width() / (2L * width));
                int py = (int) ((2L * y + 1) * film.height() / (2L * height));
                rgb[i++] = film.red(px, py);
                rgb[i++] = film.green(px, py);
                rgb[i++] = film.blue(px, py);
            }
        }
        return new CueThumbnail(width, height, ViewTransform.DEFAULT.toPixels(Film.ofScanlines(width, height, rgb)));
    }

    void show(boolean isA, boolean isB) {
        a.setSelected(isA);
        b.setSelected(isB);
    }
}
