package lightning.editor.window.look;

import java.util.Locale;
import java.util.Optional;
import javafx.scene.control.Label;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.ToggleGroup;
import javafx.scene.control.Tooltip;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.StackPane;
import lightning.base.text.Messages;
import lightning.document.look.Look;
import lightning.editor.window.widget.PictureView;
import lightning.render.image.Difference;
import lightning.render.image.DifferenceImage;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/** Comparison of two looks' pictures: A over the left part of B, one at a time, or their difference. */
final class LookCompare extends BorderPane {
    /** Mode of the comparison. */
    enum CompareMode {
        WIPE(Messages.key("Wipe"), Messages.key("A on the left, B on the right; drag to wipe")),
        FLIP(Messages.key("Flip"), Messages.key("Shows one image at a time; click to switch")),
        DIFFERENCE(Messages.key("Difference"), Messages.key("Absolute difference (black: identical)"));

        private final String title;
        private final String help;

        CompareMode(String title, String help) {
            this.title = title;
            this.help = help;
        }
    }

    private final PictureView picture = new PictureView();
    private final Label note = new Label();
    private CompareMode mode = CompareMode.WIPE;
    private boolean isFlipped;
    private Optional<Look> a = Optional.empty();
    private Optional<Look> b = Optional.empty();

    LookCompare() {
        getStyleClass().add("look-compare");
        picture.setId("look-picture");
        note.setId("look-note");
        note.getStyleClass().add("pane-note");
        var group = new ToggleGroup();
        var modeButtons = new HBox();
        for (CompareMode option : CompareMode.values()) {
            var button = new ToggleButton(Messages.tr(option.title));
            button.setId("look-" + option.name().toLowerCase(Locale.ROOT));
            button.setTooltip(new Tooltip(Messages.tr(option.help)));
            button.setToggleGroup(group);
            button.setSelected(option == mode);
            button.setOnAction(_ -> {
                button.setSelected(true);
                mode = option;
                isFlipped = false;
                show();
            });
            modeButtons.getChildren().add(button);
        }
        var head = new HBox(modeButtons, note);
        head.getStyleClass().add("mixer-tools");
        setTop(head);
        var canvas = new StackPane(picture);
        canvas.getStyleClass().add("canvas");
        canvas.setMinHeight(180);
        setCenter(canvas);
        picture.addEventHandler(MouseEvent.MOUSE_PRESSED, this::wipe);
        picture.addEventHandler(MouseEvent.MOUSE_DRAGGED, this::wipe);
        picture.addEventHandler(MouseEvent.MOUSE_CLICKED, e -> {
            if (mode == CompareMode.FLIP) {
                isFlipped = !isFlipped;
                show();
            }
            if (e.getClickCount() == 2) {
                picture.fit();
            }
        });
    }

    private void wipe(MouseEvent e) {
        if (picture.wipe().isVisible()) {
            picture.wipeTo(e.getX());
        }
    }

    /** Compares the pictures of two looks; shows the picture if only one is given. */
    void show(Optional<Look> first, Optional<Look> second) {
        a = first;
        b = second;
        isFlipped = false;
        show();
    }

    private void show() {
        picture.wipe().setVisible(false);
        Optional<Film> left = a.flatMap(Look::picture);
        Optional<Film> right = b.flatMap(Look::picture);
        if (left.isEmpty() || right.isEmpty()) {
            note.setText(Messages.tr("Choose two looks, A and B, to compare"));
            left.or(() -> right).ifPresentOrElse(this::showFilm, picture::clear);
            return;
        }
        Film first = left.get();
        Film second = right.get();
        boolean sameSize = first.width() == second.width() && first.height() == second.height();
        note.setText(
                sameSize ? ""
                        : Messages.tr("The images differ in size: {0} × {1} and {2} × {3}", first.width(), first.height(), second.width(),
                                second.height()));
        switch (mode) {
            case WIPE -> {
                showFilm(second);
                if (sameSize) {
                    picture.wipe().store(first.width(), first.height(), ViewTransform.DEFAULT.toPixels(first));
                    picture.wipe().setVisible(true);
                }
            }
            case FLIP -> {
                showFilm(isFlipped ? second : first);
                note.setText(isFlipped ? "B: " + b.get().name() : "A: " + a.get().name());
            }
            case DIFFERENCE -> {
                if (sameSize) {
                    showFilm(DifferenceImage.of(first, second));
                    note.setText(Difference.of(first, second).isNone() ? Messages.tr("The images are identical")
                            : Messages.tr("Black: identical; bright: largest difference"));
                } else {
                    showFilm(second);
                }
            }
        }
    }

    private void showFilm(Film film) {
        picture.setPixels(film.width(), film.height(), ViewTransform.DEFAULT.toPixels(film));
        picture.fit();
    }
}
