package lightning.editor.window.contribution;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import javafx.animation.PauseTransition;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.TableCell;
import javafx.scene.control.TableColumn;
import javafx.scene.control.TableRow;
import javafx.scene.control.TableView;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import javafx.util.Duration;
import javafx.util.Subscription;
import lightning.base.text.Texts;
import lightning.editor.document.Change;
import lightning.editor.loop.Frame;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.PicturePart;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.Sentence;
import lightning.editor.window.model.TracedPicture;
import lightning.editor.window.widget.Obstacle;
import lightning.editor.window.widget.Percent;
import lightning.editor.window.widget.WhileSeen;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.Contribution;
import lightning.render.relight.Contributions;
import lightning.render.relight.SmallShares;
import lightning.render.relight.tile.Options;
import lightning.scene.Scene;

/**
 * Which lights matter: the share of each in the picture, in a part of it and in the pixel under the mouse, and what would be another
 * without it. What nobody sees is switched off by one click, and the new picture is held against the old one.
 */
public final class ContributionPane extends VBox {
    /** While edits come faster than that, nothing is asked. */
    private static final Duration REST = Duration.millis(300);

    private final EditorModel model;
    private final SceneEditor editor;
    private final TracedPicture picture;
    private final ContributionFeed feed;
    private final ContributionFeed pixels;
    private final TableView<Contribution> table = new TableView<>();
    private final Label summary = new Label("…");
    private final Label proof = new Label();
    /** In the place of the lights; empty while nothing is known of them. */
    private final Label none = new Label();
    private final Label regionText = new Label(Texts.of("Region: the whole picture"));
    private final Obstacle nothingIdle;
    private final PauseTransition rest = new PauseTransition(REST);
    private Map<String, Double> pointed = Map.of();
    private Optional<Contributions.Region> region = Optional.empty();
    private Contributions shown;
    private Scene shownOf;
    private Frame asked;
    /** What was switched off, and the picture before; null where nothing is to be proved. */
    private Proof wanted;

    private record Proof(Scene scene, Film before, int lights) {}

    public ContributionPane(EditorModel model) {
        this.model = model;
        editor = model.editor();
        picture = model.picture();
        feed = new ContributionFeed(model.files().window(), "lightning-contributions");
        pixels = new ContributionFeed(model.files().window(), "lightning-pixel-share");
        setId("contributions");
        getStyleClass().add("contributions");
        summary.setId("contribution-summary");
        summary.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(summary, Priority.ALWAYS);
        var off = new Button(Texts.of("Switch Off"));
        off.setId("switch-off-idle");
        off.getStyleClass().add("accent");
        off.setMinWidth(Region.USE_PREF_SIZE);
        off.setOnAction(_ -> switchOff());
        var around = new StackPane(off);
        nothingIdle = new Obstacle(around, off, Texts.of("Switch off the lights that change no displayed pixel, in one step to undo"));
        nothingIdle.set(Optional.of(Texts.of("nothing is known yet")));
        var head = new HBox(summary, around);
        head.getStyleClass().add("mixer-tools");
        var pick = new Button(Texts.of("Region…"));
        pick.setId("contribution-region");
        pick.setTooltip(new Tooltip(Texts.of("Drag a frame in the traced picture")));
        pick.setMinWidth(Region.USE_PREF_SIZE);
        pick.setOnAction(_ -> pickRegion());
        var whole = new Button(Texts.of("Whole Picture"));
        whole.setId("contribution-whole");
        whole.setMinWidth(Region.USE_PREF_SIZE);
        whole.setOnAction(_ -> setRegion(Optional.empty()));
        regionText.setId("contribution-region-text");
        regionText.getStyleClass().add("pane-note");
        var parts = new HBox(pick, whole, regionText);
        parts.getStyleClass().add("mixer-tools");
        proof.setId("contribution-proof");
        proof.setWrapText(true);
        proof.getStyleClass().add("contribution-proof");
        fillTable();
        VBox.setVgrow(table, Priority.ALWAYS);
        getChildren().addAll(head, table, parts, proof);
        rest.setOnFinished(_ -> ask());
        WhileSeen.follow(this, this::follow);
    }

    private void fillTable() {
        table.setId("contribution-table");
        table.setAccessibleText(Texts.of("lights and what they give"));
        table.setPlaceholder(none);
        table.setColumnResizePolicy(TableView.CONSTRAINED_RESIZE_POLICY_FLEX_LAST_COLUMN);
        table.getColumns().setAll(List.of(
                column(Texts.of("Light"), Contribution::light, Function.identity(), 130),
                column(Texts.of("Picture"), Contribution::picture, Percent::text, 80),
                column(Texts.of("Region"), Contribution::region, Percent::text, 80),
                column(Texts.of("Pointer"), c -> pointed.getOrDefault(c.light(), Double.NaN), p -> p.isNaN() ? "–" : Percent.text(p), 80),
                column(Texts.of("Without it"), c -> c.shines() ? c.without().shown() : -1L, Object::toString, 240)));
        ((TableColumn<Contribution, Long>) table.getColumns().get(4)).setCellFactory(_ -> new TableCell<>() {
            @Override
            protected void updateItem(Long item, boolean empty) {
                super.updateItem(item, empty);
                Contribution of = getTableRow() == null ? null : getTableRow().getItem();
                setText(empty || of == null ? null : without(of));
            }
        });
        table.setRowFactory(_ -> {
            TableRow<Contribution> row = new TableRow<>();
            row.setOnMouseClicked(_ -> {
                if (row.getItem() != null && editor.scene().light(row.getItem().light()).isPresent()) {
                    editor.selection().selectLight(row.getItem().light());
                }
            });
            return row;
        });
    }

    private static <T> TableColumn<Contribution, T> column(String title, Function<Contribution, T> value, Function<T, String> text,
            double width) {
        var column = new TableColumn<Contribution, T>(title);
        column.setCellValueFactory(c -> new ReadOnlyObjectWrapper<>(value.apply(c.getValue())));
        column.setCellFactory(_ -> new TableCell<>() {
            @Override
            protected void updateItem(T item, boolean empty) {
                super.updateItem(item, empty);
                setText(empty || item == null ? null : text.apply(item));
            }
        });
        column.setPrefWidth(width);
        return column;
    }

    /** What the picture would be without a light. */
    static String without(Contribution of) {
        Contribution.Change change = of.without();
        return !of.shines() ? Texts.of("does not shine") : change.isNone() ? Texts.of("equal in every bit")
                : change.isUnseen() ? String.format(Texts.locale(), Texts.of("looks the same, off by %.1e at most"), change.largest())
                : String.format(Texts.locale(), Texts.of("%,d pixels change"), change.shown());
    }

    /** Follows the picture. */
    private Subscription follow() {
        return Subscription.combine(picture.renderingProperty().subscribe(state -> follow(state.frame())),
                picture.viewProperty().subscribe(_ -> again()), model.part().pointedProperty().subscribe(this::point), this::close);
    }

    /** Gives up what is asked, and ends its threads until the window opens again. */
    private void close() {
        rest.stop();
        feed.close();
        pixels.close();
        asked = null;
        PicturePart.Ask ask = model.part().askProperty().get();
        if (ask != null) {
            model.part().askProperty().set(null);
        }
    }

    private void follow(Frame frame) {
        if (frame != null && frame != asked && frame.finished()) {
            asked = frame;
            prove(frame);
            again();
        }
    }

    private void again() {
        summary.setText(Texts.of("Asking all lights …"));
        feed.stop();
        rest.playFromStart();
    }

    private void ask() {
        Options options = model.precisionProperty().get().options().withThreads(1);
        ViewTransform view = picture.viewProperty().get().withMarked(false);
        Optional<Contributions.Region> part = region;
        feed.ask(progress -> model.workbench().known().map(cache -> new Answer(cache.scene(), Contributions.of(cache, options, view,
                part.orElseGet(() -> Contributions.Region.all(cache.film())), progress))), this::show,
                why -> summary.setText(Sentence.of(why)));
    }

    private record Answer(Scene scene, Contributions contributions) {}

    private void show(Answer answer) {
        shown = answer.contributions();
        none.setText(Texts.of("No lights"));
        shownOf = answer.scene();
        List<TableColumn<Contribution, ?>> order = List.copyOf(table.getSortOrder());
        table.getItems().setAll(Stream.concat(shown.lights().stream(), shown.environment().stream()).toList());
        table.getSortOrder().setAll(order);
        table.sort();
        int idle = shown.idle().size();
        summary.setText(idle == 0 ? Texts.of("Every light that shines changes some pixel")
                : Texts.count(idle, "1 light changes no displayed pixel: {1}", "{0} lights together change no displayed pixel: {1}", idle,
                        String.join(", ", shown.idle())));
        nothingIdle.set(idle == 0 ? Optional.of(Texts.of("every light that shines changes some pixel")) : Optional.empty());
    }

    private void pickRegion() {
        model.part().askProperty()
                .set(new PicturePart.Ask(Texts.of("Drag a frame around what to ask about"), part -> setRegion(Optional.of(part))));
    }

    private void setRegion(Optional<Contributions.Region> part) {
        region = part;
        regionText.setText(
                Texts.of("Region: {0}", part
                        .map(r -> Texts.of("{0} × {1} pixels at {2}, {3}", r.right() - r.left(), r.bottom() - r.top(), r.left(), r.top()))
                        .orElse(Texts.of("the whole picture"))));
        again();
    }

    private void point(PicturePart.Pixel pixel) {
        if (pixel == null) {
            pixels.stop();
            pointed = Map.of();
            table.refresh();
            return;
        }
        pixels.ask(_ -> model.workbench().known()
                .filter(c -> pixel.x() < c.scene().picture().width() && pixel.y() < c.scene().picture().height())
                .map(cache -> parts(SmallShares.pixel(cache, pixel.x(), pixel.y()))), parts -> {
                    pointed = parts;
                    table.refresh();
                }, why -> editor.message().show(Sentence.of(why)));
    }

    private static Map<String, Double> parts(SmallShares shares) {
        double all = SmallShares.brightness(shares.picture());
        Map<String, Double> parts = new HashMap<>();
        for (int l = 0; l < shares.scene().lights().size(); l++) {
            parts.put(shares.scene().lights().get(l).name(), all > 0 ? SmallShares.brightness(shares.light(l)) / all : 0);
        }
        parts.put(Contributions.ENVIRONMENT, all > 0 ? SmallShares.brightness(shares.environment()) / all : 0);
        return parts;
    }

    private void switchOff() {
        Frame frame = picture.frame();
        if (shown == null || frame == null || !editor.scene().rig().equals(shownOf.rig())) {
            editor.message().show(Texts.of("The scene was edited since; press Go first"));
            return;
        }
        List<String> idle = shown.idle();
        if (editor.editOrReport(scene -> Change.of(() -> Contributions.off(scene, idle))).isEmpty()) {
            wanted = new Proof(editor.scene(), frame.film(), idle.size());
            proof.setText(Texts.of("Switched off; comparing the new picture …"));
            nothingIdle.set(Optional.of(Texts.of("it is being compared")));
            if (!editor.liveProperty().get()) {
                editor.go();
            }
        }
    }

    /** Holds the picture after lights were switched off against the one before. */
    private void prove(Frame frame) {
        Proof of = wanted;
        if (of == null) {
            return;
        }
        if (!frame.scene().rig().equals(of.scene().rig())) {
            return;
        }
        wanted = null;
        ViewTransform view = picture.viewProperty().get().withMarked(false);
        model.files().beside(() -> Contribution.Change.between(of.before(), frame.film(), view),
                change -> proof.setText(told(of.lights(), change)),
                why -> proof.setText(Sentence.of(why)));
    }

    static String told(int lights, Contribution.Change change) {
        String begin = Texts.count(lights, "Switched off 1 light: ", "Switched off {0} lights: ", lights);
        return begin + (change.isNone() ? Texts.of("the new picture is equal to the old one in every bit.")
                : change.isUnseen() ? String.format(Texts.locale(),
                        Texts.of("every pixel is displayed as before; %,d linear values differ, by %.2e at most."), change.values(),
                        change.largest())
                : String.format(Texts.locale(), Texts.of("%,d pixels are displayed in another colour."), change.shown()));
    }
}
