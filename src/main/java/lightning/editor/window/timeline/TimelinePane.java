package lightning.editor.window.timeline;

import static java.util.Objects.requireNonNull;

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
import lightning.base.text.Messages;
import lightning.base.text.RefusalException;
import lightning.document.KeyEdits;
import lightning.document.ShotFrame;
import lightning.document.StepRange;
import lightning.document.motion.RecordedShot;
import lightning.editor.Command;
import lightning.editor.EditorState;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.NumberField;
import lightning.editor.window.widget.NumberSetting;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/** Timeline of the shot: keyframes, the current frame and their commands. */
public final class TimelinePane extends BorderPane implements AutoCloseable {
    /** Width of the vertical scroll bar, pixels. */
    private static final double SCROLLBAR_WIDTH = 16;
    private static final double ZOOM_STEP = 1.2;
    /** Minimum height: tools, frame numbers and a few rows, pixels. */
    private static final double MIN_HEIGHT = 156;

    private final EditorModel model;
    private final SceneEditor editor;
    private final CommandRegistry commands;
    private final TimelineModel timeline;
    private final ListView<TimelineRow> rows = new ListView<>();
    private final Region playhead = new Region();
    private final Label note = new Label();
    private final NumberField frame;
    private final NumberField first;
    private final NumberField last;
    private final NumberField rate;
    private final NumberField every;
    /** Null while this pane is created, when the playhead may already move. */
    private final @Nullable Region keysPane;
    private final Region emptyPane;
    private @Nullable FilmStripPane strip;

    public TimelinePane(EditorModel model, Playback playback, MotionRecording recording) {
        this.model = model;
        editor = model.editor();
        commands = model.commands();
        timeline = new TimelineModel(editor, model.keySelection());
        setId("timeline");
        getStyleClass().add("timeline");
        frame = number(Messages.key("frame"), 0, Shot.MAX_FRAME, (v, _) -> {
            editor.showFrame((int) v);
            return Optional.empty();
        });
        first = number(Messages.key("first frame"), 0, Shot.MAX_FRAME,
                (v, g) -> editRange(s -> new Shot((int) v, s.last(), s.rate(), List.of()), g));
        last = number(Messages.key("last frame"), 0, Shot.MAX_FRAME,
                (v, g) -> editRange(s -> new Shot(s.first(), (int) v, s.rate(), List.of()), g));
        rate = field(Messages.key("frames per second"), new StepRange(1, Shot.MIN_RATE, Shot.MAX_RATE),
                (v, g) -> editRange(s -> new Shot(s.first(), s.last(), v, List.of()), g));
        note.setId("timeline-note");
        note.getStyleClass().add("pane-note");
        note.textProperty().bind(recording.statusProperty().concat(playback.frameRateProperty()));
        every = number(Messages.key("keyframe interval"), 1, RecordedShot.MAX_INTERVAL, (v, _) -> {
            recording.intervalProperty().set((int) v);
            return Optional.empty();
        });
        recording.intervalProperty().subscribe(v -> every.show(v.doubleValue()));
        keysPane = keysArea();
        emptyPane = emptyNote();
        setTop(toolBar());
        setCenter(new StackPane(keysPane, emptyPane));
        timeline.scaleProperty().subscribe(_ -> placePlayhead());
        model.layout().filmStripShownProperty().subscribe(this::showStrip);
        editor.editorStateProperty().subscribe(this::show);
    }

    private void showStrip(boolean on) {
        setMinHeight(MIN_HEIGHT + (on ? FilmStripPane.HEIGHT : 0));
        if (on) {
            strip = new FilmStripPane(model, timeline);
            setBottom(strip);
        } else if (strip != null) {
            strip.close();
            setBottom(null);
            strip = null;
        }
    }

    /** Closes the film strip and its threads. */
    @Override
    public void close() {
        showStrip(false);
    }

    private FlowPane toolBar() {
        var bar = new FlowPane();
        bar.getStyleClass().add("timeline-bar");
        add(bar, Command.FIRST_FRAME, Command.PREVIOUS_KEY, Command.PREVIOUS_FRAME, Command.PLAY_SHOT, Command.NEXT_FRAME, Command.NEXT_KEY,
                Command.LAST_FRAME);
        bar.getChildren().addAll(new Separator(Orientation.VERTICAL), labeled(Messages.tr("Frame"), frame),
                new Separator(Orientation.VERTICAL));
        add(bar, Command.SET_KEY, Command.DELETE_KEYS, Command.LINEAR_KEYS, Command.SMOOTH_KEYS, Command.STEPPED_KEYS);
        bar.getChildren().add(new Separator(Orientation.VERTICAL));
        add(bar, Command.MAKE_ANIMATION);
        bar.getChildren().add(labeled(Messages.tr("keyframe every"), every));
        bar.getChildren().addAll(new Separator(Orientation.VERTICAL), labeled(Messages.tr("from"), first), labeled(Messages.tr("to"), last),
                labeled(Messages.tr("fps"), rate),
                new Separator(Orientation.VERTICAL), CommandButton.iconButton(commands, Command.FILM_STRIP), note);
        return bar;
    }

    private void add(FlowPane bar, Command... commandsToAdd) {
        for (Command command : commandsToAdd) {
            bar.getChildren().add(CommandButton.iconButton(commands, command));
        }
    }

    private static HBox labeled(String text, Node field) {
        var label = new Label(text);
        label.getStyleClass().add("pane-note");
        label.setMinWidth(USE_PREF_SIZE);
        var box = new HBox(label, field);
        box.getStyleClass().add("timeline-field");
        return box;
    }

    private NumberField number(String title, int min, int max, NumberSetting.Setter setter) {
        return field(title, new StepRange(1, min, max), (v, gesture) -> {
            double value = gesture == null ? v : Math.rint(v);
            if (value != Math.rint(value)) {
                return Optional.of(Messages.tr("{0}: expected a whole number, found {1}", Messages.tr(title), SceneLimits.format(value)));
            }
            try {
                SceneLimits.checkRange(Messages.tr(title), value, min, max);
            } catch (RefusalException e) {
                return Optional.of(e.getMessage());
            }
            return setter.set(value, gesture);
        });
    }

    private NumberField field(String title, StepRange steps, NumberSetting.Setter setter) {
        var field = new NumberField(title, NumberSetting.of(title, steps, setter));
        field.setId("timeline-" + title.replace(' ', '-'));
        return field;
    }

    private interface ShotRangeEdit {
        Shot apply(Shot shot);
    }

    private Optional<String> editRange(ShotRangeEdit edit, @Nullable Object gesture) {
        return editor.editShot(scene -> editRange(scene, edit), gesture);
    }

    private static AnimatedScene editRange(AnimatedScene scene, ShotRangeEdit edit) {
        Shot range = edit.apply(scene.shot().orElseThrow());
        return KeyEdits.setFrames(scene, range.first(), range.last(), range.rate());
    }

    private Region keysArea() {
        rows.setId("timeline-rows");
        rows.getStyleClass().addAll("edge-to-edge", "tracks");
        rows.setAccessibleText(Messages.tr("keys"));
        rows.setFixedCellSize(TrackCell.HEIGHT);
        rows.setCellFactory(_ -> new TrackCell(timeline));
        rows.setContextMenu(menu());
        rows.addEventFilter(KeyEvent.KEY_PRESSED, this::handleKey);
        KeyframeMouse.attach(timeline, rows, model.workbench());
        var ruler = new Ruler(timeline);
        HBox.setHgrow(ruler, Priority.ALWAYS);
        var top = new HBox(space(TrackCell.NAME_WIDTH), ruler, space(SCROLLBAR_WIDTH));
        VBox.setVgrow(rows, Priority.ALWAYS);
        var lines = new VBox(top, rows);
        playhead.getStyleClass().add("playhead");
        playhead.setId("playhead");
        playhead.setManaged(false);
        var overlay = new Pane(playhead);
        overlay.setMouseTransparent(true);
        var stack = new StackPane(lines, overlay);
        stack.widthProperty().subscribe(w -> timeline.setWidth(Math.max(1, w.doubleValue() - TrackCell.NAME_WIDTH - SCROLLBAR_WIDTH)));
        stack.heightProperty().subscribe(_ -> placePlayhead());
        stack.addEventFilter(ScrollEvent.SCROLL, this::scroll);
        stack.setMinHeight(0);
        return stack;
    }

    private static Region space(double width) {
        var space = new Region();
        space.setMinWidth(width);
        space.setMaxWidth(width);
        return space;
    }

    private ContextMenu menu() {
        var items = CommandMenuItems.forMenu(commands, "timeline-");
        var menu = new ContextMenu();
        for (Command command : List.of(Command.SET_KEY, Command.DELETE_KEYS, Command.LINEAR_KEYS, Command.SMOOTH_KEYS,
                Command.STEPPED_KEYS)) {
            menu.getItems().add(items.item(command));
        }
        return menu;
    }

    private Region emptyNote() {
        var text = new Label(Messages.tr("No shot: the scene is not animated"));
        text.getStyleClass().add("pane-note");
        var box = new HBox(text, CommandButton.titledButton(commands, Command.NEW_SHOT));
        box.getStyleClass().add("no-shot");
        return box;
    }

    private void handleKey(KeyEvent event) {
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
            // No row can be selected.
            event.consume();
        }
    }

    /** Zooms with Ctrl, pans with Shift; otherwise the rows scroll. */
    private void scroll(ScrollEvent event) {
        double delta = event.getDeltaY() == 0 ? event.getDeltaX() : event.getDeltaY();
        if (event.isShortcutDown()) {
            timeline.zoom(delta > 0 ? ZOOM_STEP : 1 / ZOOM_STEP, event.getX() - TrackCell.NAME_WIDTH);
            event.consume();
        } else if (event.isShiftDown()) {
            timeline.pan(-delta);
            event.consume();
        }
    }

    private void show(EditorState state) {
        Shot oldShot = timeline.shotProperty().get();
        timeline.show(state);
        Shot shot = timeline.shotProperty().get();
        requireNonNull(keysPane).setVisible(shot != null);
        emptyPane.setVisible(shot == null);
        boolean disabled = shot == null;
        for (NumberField field : List.of(frame, first, last, rate)) {
            field.setDisable(disabled);
        }
        if (shot == null) {
            rows.getItems().clear();
            List.of(frame, first, last, rate).forEach(NumberField::showNothing);
            return;
        }
        if (shot != oldShot) {
            List<TimelineRow> newRows = TimelineRow.of(shot);
            if (newRows.size() == rows.getItems().size()) {
                forEachChanged(newRows, i -> rows.getItems().set(i, newRows.get(i)));
            } else {
                List<String> oldIds = rows.getItems().stream().map(TimelinePane::rowId).toList();
                rows.getItems().setAll(newRows);
                // Scroll to the row that was added.
                newRows.stream().filter(r -> oldShot != null && !oldIds.contains(rowId(r))).reduce((_, row) -> row)
                        .ifPresent(row -> rows.scrollTo(Math.max(0, newRows.indexOf(row) - 1)));
            }
            first.show(shot.first());
            last.show(shot.last());
            rate.show(shot.rate());
        }
        frame.show(state.shotFrame().map(ShotFrame::frame).orElseThrow());
        placePlayhead();
    }

    private static String rowId(TimelineRow row) {
        return switch (row) {
            case TimelineRow.ObjectRow t -> t.target().toString();
            case TimelineRow.TrackRow t -> t.target() + "." + t.track().attribute();
        };
    }

    private void forEachChanged(List<TimelineRow> newRows, Consumer<Integer> action) {
        for (int i = 0; i < newRows.size(); i++) {
            if (!newRows.get(i).equals(rows.getItems().get(i))) {
                action.accept(i);
            }
        }
    }

    private void placePlayhead() {
        FrameScale scale = timeline.scaleProperty().get();
        Optional<ShotFrame> now = editor.document().shotFrame();
        playhead.setVisible(now.filter(m -> scale.isVisible(m.frame())).isPresent());
        now.ifPresent(m -> playhead.resizeRelocate(TrackCell.NAME_WIDTH + scale.x(m.frame()) - 1, 0, 2,
                keysPane == null ? 0 : keysPane.getHeight()));
    }
}
