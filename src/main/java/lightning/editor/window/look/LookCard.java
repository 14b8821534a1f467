package lightning.editor.window.look;

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
import lightning.document.look.Look;
import lightning.editor.window.widget.PixelImage;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import org.jspecify.annotations.Nullable;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignT;

/** Card of a look in the gallery: thumbnail, name and actions. */
final class LookCard extends VBox {
    private static final int WIDTH = 176;
    private static final int HEIGHT = 99;

    private final TextField name = new TextField();
    private final ToggleButton a = new ToggleButton("A");
    private final ToggleButton b = new ToggleButton("B");

    /** Actions of a card. */
    interface Callbacks {
        void restore(Look look);

        void rename(Look look, String name);

        void remove(Look look);

        void chooseA(Look look);

        void chooseB(Look look);
    }

    /**
     * Creates a card.
     *
     * @param thumbnail thumbnail from {@link #thumbnail}; null if there is none
     */
    LookCard(Look look, @Nullable LookThumbnail thumbnail, Callbacks callbacks) {
        setId("look-" + look.name());
        getStyleClass().add("look-card");
        var frame = new StackPane();
        frame.getStyleClass().add("look-frame");
        frame.setMinSize(WIDTH, HEIGHT);
        frame.setMaxSize(WIDTH, HEIGHT);
        if (thumbnail == null) {
            frame.getChildren().add(new Label(Messages.tr("no image")));
        } else {
            frame.getChildren().add(new ImageView(PixelImage.of(thumbnail.width, thumbnail.height, thumbnail.pixels)));
        }
        name.setId("look-name-" + look.name());
        name.setText(look.name());
        name.setAccessibleText(Messages.tr("name of look {0}", look.name()));
        name.setOnAction(_ -> callbacks.rename(look, name.getText().strip()));
        name.addEventHandler(KeyEvent.KEY_PRESSED, e -> {
            if (e.getCode() == KeyCode.ESCAPE && !name.getText().equals(look.name())) {
                name.setText(look.name());
                e.consume();
            }
        });
        name.focusedProperty().subscribe(focused -> {
            if (!focused) {
                name.setText(look.name());
            }
        });
        var restore = new Button(Messages.tr("Apply"));
        restore.setId("look-restore-" + look.name());
        restore.setTooltip(new Tooltip(Messages.tr("Apply this look to the scene")));
        restore.setOnAction(_ -> callbacks.restore(look));
        a.setId("look-a-" + look.name());
        a.setTooltip(new Tooltip(Messages.tr("Use this look as A")));
        a.setAccessibleText(Messages.tr("{0} as A", look.name()));
        a.setOnAction(_ -> callbacks.chooseA(look));
        b.setId("look-b-" + look.name());
        b.setTooltip(new Tooltip(Messages.tr("Use this look as B")));
        b.setAccessibleText(Messages.tr("{0} as B", look.name()));
        b.setOnAction(_ -> callbacks.chooseB(look));
        var remove = new Button("", new FontIcon(MaterialDesignT.TRASH_CAN_OUTLINE));
        remove.setId("look-remove-" + look.name());
        remove.setAccessibleText(Messages.tr("delete look {0}", look.name()));
        remove.setTooltip(new Tooltip(Messages.tr("Delete Look")));
        remove.setOnAction(_ -> callbacks.remove(look));
        for (var control : new ButtonBase[] {restore, a, b}) {
            control.setDisable(look.lighting().isEmpty());
        }
        var buttons = new HBox(restore, a, b, remove);
        buttons.getStyleClass().add("look-buttons");
        getChildren().addAll(frame, name, buttons);
        if (look.lighting().isEmpty()) {
            var problem = new Label(look.problem());
            problem.setId("look-problem-" + look.name());
            problem.setWrapText(true);
            problem.setMaxWidth(WIDTH);
            problem.getStyleClass().add("look-problem");
            getChildren().add(problem);
        }
    }

    /** Thumbnail of a look at the size of a card: {@code int[width * height]}, opaque. */
    record LookThumbnail(int width, int height, int[] pixels) {
        // Immutable by convention: the array is written only before construction.
    }

    /** Downscales a film by nearest-neighbor sampling at pixel centers. */
    static LookThumbnail thumbnail(Film film) {
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
        return new LookThumbnail(width, height, ViewTransform.DEFAULT.toPixels(Film.ofScanlines(width, height, rgb)));
    }

    void show(boolean isA, boolean isB) {
        a.setSelected(isA);
        b.setSelected(isB);
    }
}
