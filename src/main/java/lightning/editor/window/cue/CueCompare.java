package lightning.editor.window.cue;

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
import lightning.base.text.Texts;
import lightning.editor.document.cue.Cue;
import lightning.editor.window.widget.PictureView;
import lightning.render.image.Difference;
import lightning.render.image.DifferencePicture;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/** The pictures of two cues: A over the left part of B, one or the other, or where they differ. */
final class CueCompare extends BorderPane {
    /** How they are seen. */
    enum Way {
        WIPE(Texts.key("Wipe"), Texts.key("A at the left, B at the right; drag in the picture")),
        FLIP(Texts.key("Flip"), Texts.key("One picture at a time; a click in the picture shows the other")),
        DIFFERENCE(Texts.key("Difference"), Texts.key("Where they differ, and how much: black where they are equal"));

        private final String title;
        private final String help;

        Way(String title, String help) {
            this.title = title;
            this.help = help;
        }
    }

    private final PictureView picture = new PictureView();
    private final Label note = new Label();
    private Way way = Way.WIPE;
    private boolean flipped;
    private Optional<Cue> a = Optional.empty();
    private Optional<Cue> b = Optional.empty();

    CueCompare() {
        getStyleClass().add("cue-compare");
        picture.setId("cue-picture");
        note.setId("cue-note");
        note.getStyleClass().add("pane-note");
        var group = new ToggleGroup();
        var ways = new HBox();
        for (Way one : Way.values()) {
            var button = new ToggleButton(Texts.of(one.title));
            button.setId("cue-" + one.name().toLowerCase(Locale.ROOT));
            button.setTooltip(new Tooltip(Texts.of(one.help)));
            button.setToggleGroup(group);
            button.setSelected(one == way);
            button.setOnAction(_ -> {
                button.setSelected(true);
                way = one;
                flipped = false;
                show();
            });
            ways.getChildren().add(button);
        }
        var head = new HBox(ways, note);
        head.getStyleClass().add("mixer-tools");
        setTop(head);
        var canvas = new StackPane(picture);
        canvas.getStyleClass().add("canvas");
        canvas.setMinHeight(180);
        setCenter(canvas);
        picture.addEventHandler(MouseEvent.MOUSE_PRESSED, this::wipe);
        picture.addEventHandler(MouseEvent.MOUSE_DRAGGED, this::wipe);
        picture.addEventHandler(MouseEvent.MOUSE_CLICKED, _ -> {
            if (way == Way.FLIP) {
                flipped = !flipped;
                show();
            }
        });
    }

    private void wipe(MouseEvent e) {
        if (picture.wipe().isVisible()) {
            picture.wipeTo(e.getX());
        }
    }

    /** Compares the pictures of two cues; that of one alone is shown. */
    void show(Optional<Cue> first, Optional<Cue> second) {
        a = first;
        b = second;
        flipped = false;
        show();
    }

    private void show() {
        picture.wipe().setVisible(false);
        Optional<Film> left = a.flatMap(Cue::picture);
        Optional<Film> right = b.flatMap(Cue::picture);
        if (left.isEmpty() || right.isEmpty()) {
            note.setText(Texts.of("Choose two cues, A and B, to compare their pictures"));
            left.or(() -> right).ifPresentOrElse(this::pixels, picture::clear);
            return;
        }
        Film first = left.get();
        Film second = right.get();
        boolean alike = first.width() == second.width() && first.height() == second.height();
        note.setText(
                alike ? "" : Texts.of("The pictures differ in size: {0} × {1} and {2} × {3}", first.width(), first.height(), second.width(),
                        second.height()));
        switch (way) {
            case WIPE -> {
                pixels(second);
                if (alike) {
                    picture.wipe().store(first.width(), first.height(), ViewTransform.DEFAULT.toPixels(first));
                    picture.wipe().setVisible(true);
                }
            }
            case FLIP -> {
                pixels(flipped ? second : first);
                note.setText(flipped ? "B: " + b.get().name() : "A: " + a.get().name());
            }
            case DIFFERENCE -> {
                if (alike) {
                    pixels(DifferencePicture.of(first, second));
                    note.setText(Difference.of(first, second).isNone() ? Texts.of("The pictures are equal")
                            : Texts.of("Black is equal, pale differs most"));
                } else {
                    pixels(second);
                }
            }
        }
    }

    private void pixels(Film film) {
        picture.setPixels(film.width(), film.height(), ViewTransform.DEFAULT.toPixels(film));
        picture.fit();
    }
}
