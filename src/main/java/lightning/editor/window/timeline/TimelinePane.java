package lightning.editor.window.timeline;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.geometry.Orientation;
import javafx.scene.Node;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.control.Separator;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Pane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.KeyEdits;
import lightning.editor.document.Moment;
import lightning.editor.document.Situation;
import lightning.editor.document.Steps;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.command.CommandItems;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.Gauge;
import lightning.editor.window.widget.NumberField;
import lightning.scene.Limits;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;

/** The keys of the shot over its frames, the frame that is shown, and what is done with both. */
public final class TimelinePane extends BorderPane implements AutoCloseable {
    /** Room for the bar that scrolls the lines, pixels. */
    private static final double SCROLL = 16;
    private static final double ZOOM = 1.2;
    /** Tools, numbers and a few lines, pixels. */
    private static final double LEAST = 156;

    private final EditorModel model;
    private final SceneEditor editor;
    private final Commands commands;
    private final Timeline timeline;
    private final ListView<Row> rows = new ListView<>();
    private final Region head = new Region();
    private final Label note = new Label();
    private final NumberField frame;
    private final NumberField first;
    private final NumberField last;
    private final NumberField rate;
    private final Region keys;
    private final Region empty;
    private StripPane strip;

    public TimelinePane(EditorModel model, Playback playback) {
        this.model = model;
        editor = model.editor();
        commands = model.commands();
        timeline = new Timeline(editor, model.keyChoice());
        setId("timeline");
        getStyleClass().add("timeline");
        frame = number(Texts.key("frame"), 0, Shot.MAX_FRAME, (v, _) -> {
            editor.showFrame((int) v);
            return Optional.empty();
        });
        first = number(Texts.key("first frame"), 0, Shot.MAX_FRAME,
                (v, g) -> lasting(s -> new Shot((int) v, s.last(), s.rate(), List.of()), g));
        last = number(Texts.key("last frame"), 0, Shot.MAX_FRAME,
                (v, g) -> lasting(s -> new Shot(s.first(), (int) v, s.rate(), List.of()), g));
        rate = field(Texts.key("frames per second"), new Steps(1, Shot.MIN_RATE, Shot.MAX_RATE),
                (v, g) -> lasting(s -> new Shot(s.first(), s.last(), v, List.of()), g));
        note.setId("timeline-note");
        note.getStyleClass().add("pane-note");
        note.textProperty().bind(playback.paceProperty());
        keys = keys();
        empty = empty();
        setTop(bar());
        setCenter(new StackPane(keys, empty));
        timeline.scaleProperty().subscribe(_ -> placeHead());
        model.arrangement().filmStripShownProperty().subscribe(this::showStrip);
        editor.situationProperty().subscribe(this::show);
    }

    private void showStrip(boolean on) {
        setMinHeight(LEAST + (on ? StripPane.HEIGHT : 0));
        if (on) {
            strip = new StripPane(model, timeline);
            setBottom(strip);
        } else if (strip != null) {
            strip.close();
            setBottom(null);
            strip = null;
        }
    }

    /** Ends what runs for it. */
    @Override
    public void close() {
        showStrip(false);
    }

    private FlowPane bar() {
        var bar = new FlowPane();
        bar.getStyleClass().add("timeline-bar");
        add(bar, Command.FIRST_FRAME, Command.PREVIOUS_KEY, Command.PREVIOUS_FRAME, Command.PLAY_SHOT, Command.NEXT_FRAME, Command.NEXT_KEY,
                Command.LAST_FRAME);
        bar.getChildren().addAll(new Separator(Orientation.VERTICAL), labelled(Texts.of("Frame"), frame),
                new Separator(Orientation.VERTICAL));
        add(bar, Command.SET_KEY, Command.DELETE_KEYS, Command.LINEAR_KEYS, Command.SMOOTH_KEYS, Command.STEPPED_KEYS);
        bar.getChildren().addAll(new Separator(Orientation.VERTICAL), labelled(Texts.of("from"), first), labelled(Texts.of("to"), last),
                labelled(Texts.of("a second"), rate),
                new Separator(Orientation.VERTICAL), CommandButton.icon(commands, Command.FILM_STRIP), note);
        return bar;
    }

    private void add(FlowPane bar, Command... added) {
        for (Command command : added) {
            bar.getChildren().add(CommandButton.icon(commands, command));
        }
    }

    private static HBox labelled(String text, Node field) {
        var label = new Label(text);
        label.getStyleClass().add("pane-note");
        label.setMinWidth(USE_PREF_SIZE);
        var both = new HBox(label, field);
        both.getStyleClass().add("timeline-field");
        return both;
    }

    private NumberField number(String title, int min, int max, Gauge.Setter setter) {
        return field(title, new Steps(1, min, max), (v, gesture) -> {
            double whole = gesture == null ? v : Math.rint(v);
            if (whole != Math.rint(whole)) {
                return Optional.of(Texts.of("{0} must be a whole number, was {1}", Texts.of(title), Limits.text(whole)));
            }
            try {
                Limits.range(Texts.of(title), whole, min, max);
            } catch (IllegalArgumentException e) {
                return Optional.of(e.getMessage());
            }
            return setter.set(whole, gesture);
        });
    }

    private NumberField field(String title, Steps steps, Gauge.Setter setter) {
        var field = new NumberField(title, Gauge.of(title, steps, setter));
        field.setId("timeline-" + title.replace(' ', '-'));
        return field;
    }

    private interface Lasting {
        Shot of(Shot shot);
    }

    private Optional<String> lasting(Lasting edit, Object gesture) {
        return editor.editAll(scene -> lasting(scene, edit), gesture);
    }

    private static AnimatedScene lasting(AnimatedScene scene, Lasting edit) {
        Shot wanted = edit.of(scene.shot().orElseThrow());
        return KeyEdits.lasting(scene, wanted.first(), wanted.last(), wanted.rate());
    }

    private Region keys() {
        rows.setId("timeline-rows");
        rows.getStyleClass().addAll("edge-to-edge", "tracks");
        rows.setAccessibleText(Texts.of("keys"));
        rows.setFixedCellSize(TrackCell.HEIGHT);
        rows.setCellFactory(_ -> new TrackCell(timeline));
        rows.setContextMenu(menu());
        rows.addEventFilter(KeyEvent.KEY_PRESSED, this::press);
        KeyMouse.follow(timeline, rows, model.workbench());
        var ruler = new Ruler(timeline);
        HBox.setHgrow(ruler, Priority.ALWAYS);
        var top = new HBox(space(TrackCell.NAME), ruler, space(SCROLL));
        VBox.setVgrow(rows, Priority.ALWAYS);
        var lines = new VBox(top, rows);
        head.getStyleClass().add("playhead");
        head.setId("playhead");
        head.setManaged(false);
        var over = new Pane(head);
        over.setMouseTransparent(true);
        var all = new StackPane(lines, over);
        all.widthProperty().subscribe(w -> timeline.setWidth(Math.max(1, w.doubleValue() - TrackCell.NAME - SCROLL)));
        all.heightProperty().subscribe(_ -> placeHead());
        all.addEventFilter(ScrollEvent.SCROLL, this::scroll);
        all.setMinHeight(0);
        return all;
    }

    private static Region space(double width) {
        var space = new Region();
        space.setMinWidth(width);
        space.setMaxWidth(width);
        return space;
    }

    private ContextMenu menu() {
        var items = CommandItems.of(commands, "timeline-");
        var menu = new ContextMenu();
        for (Command command : List.of(Command.SET_KEY, Command.DELETE_KEYS, Command.LINEAR_KEYS, Command.SMOOTH_KEYS,
                Command.STEPPED_KEYS)) {
            menu.getItems().add(items.item(command));
        }
        return menu;
    }

    private Region empty() {
        var text = new Label(Texts.of("The scene has no shot: nothing of it moves"));
        text.getStyleClass().add("pane-note");
        var both = new HBox(text, CommandButton.titled(commands, Command.NEW_SHOT));
        both.getStyleClass().add("no-shot");
        return both;
    }

    private void press(KeyEvent event) {
        Command command = switch (event.getCode()) {
            case LEFT -> Command.PREVIOUS_FRAME;
            case RIGHT -> Command.NEXT_FRAME;
            case HOME -> Command.FIRST_FRAME;
            case END -> Command.LAST_FRAME;
            case SPACE -> Command.PLAY_SHOT;
            case DELETE, BACK_SPACE -> Command.DELETE_KEYS;
            default -> null;
        };
        boolean plain = !event.isShortcutDown() && !event.isAltDown() && !event.isShiftDown();
        if (command != null && plain) {
            commands.run(command);
            event.consume();
        } else if (plain && (event.getCode() == KeyCode.UP || event.getCode() == KeyCode.DOWN)) {
            // Nothing is selected among the lines.
            event.consume();
        }
    }

    /** With Ctrl frames come nearer, with Shift they go along; else the lines scroll. */
    private void scroll(ScrollEvent event) {
        double way = event.getDeltaY() == 0 ? event.getDeltaX() : event.getDeltaY();
        if (event.isShortcutDown()) {
            timeline.zoom(way > 0 ? ZOOM : 1 / ZOOM, event.getX() - TrackCell.NAME);
            event.consume();
        } else if (event.isShiftDown()) {
            timeline.move(-way);
            event.consume();
        }
    }

    private void show(Situation now) {
        Shot before = timeline.shotProperty().get();
        timeline.show(now);
        Shot shot = timeline.shotProperty().get();
        keys.setVisible(shot != null);
        empty.setVisible(shot == null);
        boolean held = shot == null || editor.isAnimating();
        for (NumberField field : List.of(frame, first, last, rate)) {
            field.setDisable(held);
        }
        if (shot == null) {
            rows.getItems().clear();
            List.of(frame, first, last, rate).forEach(NumberField::showNothing);
            return;
        }
        if (shot != before) {
            List<Row> wanted = Row.of(shot);
            if (wanted.size() == rows.getItems().size()) {
                forEachOther(wanted, i -> rows.getItems().set(i, wanted.get(i)));
            } else {
                List<String> were = rows.getItems().stream().map(TimelinePane::name).toList();
                rows.getItems().setAll(wanted);
                // What came is seen.
                wanted.stream().filter(r -> before != null && !were.contains(name(r))).reduce((_, row) -> row)
                        .ifPresent(row -> rows.scrollTo(Math.max(0, wanted.indexOf(row) - 1)));
            }
            first.show(shot.first());
            last.show(shot.last());
            rate.show(shot.rate());
        }
        frame.show(now.moment().map(Moment::frame).orElseThrow());
        placeHead();
    }

    private static String name(Row row) {
        return switch (row) {
            case Row.OfThing t -> t.target().toString();
            case Row.OfTrack t -> t.target() + "." + t.track().attribute();
        };
    }

    private void forEachOther(List<Row> wanted, Consumer<Integer> then) {
        for (int i = 0; i < wanted.size(); i++) {
            if (!wanted.get(i).equals(rows.getItems().get(i))) {
                then.accept(i);
            }
        }
    }

    private void placeHead() {
        FrameScale scale = timeline.scaleProperty().get();
        Optional<Moment> now = editor.document().moment();
        head.setVisible(now.filter(m -> scale.shows(m.frame())).isPresent());
        now.ifPresent(m -> head.resizeRelocate(TrackCell.NAME + scale.x(m.frame()) - 1, 0, 2, keys == null ? 0 : keys.getHeight()));
    }
}
