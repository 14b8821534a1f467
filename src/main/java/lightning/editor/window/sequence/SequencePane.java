package lightning.editor.window.sequence;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import javafx.animation.PauseTransition;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.TextArea;
import javafx.scene.control.TextField;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.util.Duration;
import javafx.util.StringConverter;
import javafx.util.Subscription;
import lightning.base.file.AtomicFile;
import lightning.base.file.ChangedFileException;
import lightning.base.file.FileState;
import lightning.base.file.ParentFolder;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.editor.loop.ContactSheet;
import lightning.editor.window.command.PathPrompt;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.VisibilityListener;
import lightning.format.jen.JenException;
import lightning.format.sequence.LoadedSequence;
import lightning.format.sequence.Sequence;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;
import org.jspecify.annotations.Nullable;

/**
 * Contact sheet of a sequence. All shots are lit by the lights of the open scene, or by those of the rig's file; each edit shows in all shots. The
 * selected shot has fields for its own values and notes.
 */
public final class SequencePane extends VBox {
    private static final String EXTENSION = "json";

    private final EditorModel model;
    private final SceneEditor editor;
    private final Button addShot = new Button(Messages.tr("Add Shot…"));
    private final Label fileName = new Label();
    private final CheckBox followsScene = new CheckBox(Messages.tr("Light With the Open Scene"));
    private final ChoiceBox<Moment> moment = new ChoiceBox<>();
    private final FlowPane cards = new FlowPane();
    private final Label shotName = new Label();
    private final TextArea overrides = new TextArea();
    private final TextField note = new TextField();
    private final Label lightName = new Label();
    private final TextField lightNote = new TextField();
    private final Label message = new Label();
    private final VBox details;
    private final Map<String, ShotCard> byName = new LinkedHashMap<>();
    private final PauseTransition autosave = new PauseTransition(Duration.seconds(1));
    private @Nullable LoadedSequence loaded;
    private @Nullable ContactSheet sheet;
    private @Nullable PathPrompt prompt;
    /** File as it was read or last saved. */
    private FileState known = FileState.MISSING;
    private boolean isChanged;
    private boolean isSaving;
    private boolean isUpdating;
    private String selected = "";

    /** Frame of each shot that its picture shows. */
    private enum Moment {
        FIRST, MIDDLE, LAST;

        private int frame(Shot shot) {
            return switch (this) {
                case FIRST -> shot.first();
                case MIDDLE -> shot.first() + (shot.last() - shot.first()) / 2;
                case LAST -> shot.last();
            };
        }

        private String title() {
            return switch (this) {
                case FIRST -> Messages.tr("First Frame");
                case MIDDLE -> Messages.tr("Middle Frame");
                case LAST -> Messages.tr("Last Frame");
            };
        }
    }

    public SequencePane(EditorModel model) {
        this.model = model;
        editor = model.editor();
        setId("sequence");
        getStyleClass().add("cues");
        var open = new Button(Messages.tr("Open Sequence…"));
        open.setId("sequence-open");
        open.setMinWidth(Region.USE_PREF_SIZE);
        open.setOnAction(_ -> prompt().fileToOpen(Messages.tr("Open Sequence"), EXTENSION).ifPresent(this::open));
        var create = new Button(Messages.tr("New Sequence…"));
        create.setId("sequence-new");
        create.setMinWidth(Region.USE_PREF_SIZE);
        create.setTooltip(new Tooltip(Messages.tr("Start a sequence whose rig and first shot are the open scene")));
        create.setOnAction(_ -> create());
        addShot.setId("sequence-add");
        addShot.setMinWidth(Region.USE_PREF_SIZE);
        addShot.setOnAction(_ -> prompt().fileToOpen(Messages.tr("Add Shot"), "jen").ifPresent(this::add));
        autosave.setOnFinished(_ -> save());
        fileName.setId("sequence-file");
        fileName.getStyleClass().add("pane-note");
        followsScene.setId("sequence-follows");
        followsScene.setTooltip(new Tooltip(Messages.tr("On: the lights of the open scene light all shots. Off: those of the rig's file")));
        followsScene.selectedProperty().subscribe(this::showPictures);
        moment.setId("sequence-moment");
        moment.setAccessibleText(Messages.tr("Frame of the pictures"));
        moment.getItems().setAll(Moment.values());
        moment.setConverter(new StringConverter<>() {
            @Override
            public String toString(Moment value) {
                return value.title();
            }

            @Override
            public Moment fromString(String text) {
                throw new UnsupportedOperationException();
            }
        });
        moment.setValue(Moment.MIDDLE);
        moment.valueProperty().subscribe(this::showPictures);
        cards.setId("sequence-cards");
        cards.getStyleClass().add("cue-gallery");
        var scroll = new ScrollPane(cards);
        scroll.setFitToWidth(true);
        scroll.getStyleClass().add("edge-to-edge");
        VBox.setVgrow(scroll, Priority.ALWAYS);
        message.setId("sequence-message");
        message.getStyleClass().add("pane-note");
        message.setWrapText(true);
        message.setMinHeight(Region.USE_PREF_SIZE);
        details = details();
        getChildren().addAll(row(open, create, addShot, fileName), row(followsScene, moment), scroll, details, row(message));
        showSequence();
        VisibilityListener.attach(this, this::subscribe);
    }

    private VBox details() {
        overrides.setId("sequence-overrides");
        overrides.setPromptText("key.intensity=2");
        overrides.setPrefRowCount(3);
        overrides.setAccessibleText(Messages.tr("Values of the shot, one in each line"));
        overrides.textProperty().subscribe(text -> changeShot(shot -> shot.withOverrides(text.lines().map(String::strip)
                .filter(line -> !line.isEmpty()).toList())));
        note.setId("sequence-note");
        note.setPromptText(Messages.tr("Note about the shot"));
        note.setAccessibleText(Messages.tr("Note about the shot"));
        note.textProperty().subscribe(text -> changeShot(shot -> shot.withNote(text)));
        lightNote.setId("sequence-light-note");
        lightNote.setAccessibleText(Messages.tr("Note about the selected light"));
        lightNote.textProperty().subscribe(text -> {
            String light = editor.selection().lightName();
            if (!isUpdating && loaded != null && !light.isEmpty()) {
                change(loaded.sequence().withLightNote(light, text));
            }
        });
        HBox.setHgrow(note, Priority.ALWAYS);
        HBox.setHgrow(lightNote, Priority.ALWAYS);
        shotName.setMinWidth(Region.USE_PREF_SIZE);
        lightName.setMinWidth(Region.USE_PREF_SIZE);
        return new VBox(4, row(shotName, note), overrides, row(lightName, lightNote));
    }

    private static HBox row(Region... nodes) {
        var row = new HBox(nodes);
        row.getStyleClass().add("mixer-tools");
        return row;
    }

    private PathPrompt prompt() {
        return prompt != null ? prompt : PathPrompt.ofSystem(getScene().getWindow(), model.fileImporter().folder());
    }

    /** Replaces the system's dialogs. */
    void setPrompt(PathPrompt v) {
        prompt = v;
    }

    /** Starts to render the sheet; the pictures are forgotten with the window. */
    private Subscription subscribe() {
        sheet = newSheet();
        showPictures();
        return Subscription.combine(editor.sceneProperty().subscribe((_, _) -> {
            if (followsScene.isSelected()) {
                showPictures();
            }
        }), editor.editorStateProperty().subscribe(_ -> showLightNote()), this::save, () -> {
            if (sheet != null) {
                sheet.close();
                sheet = null;
            }
        });
    }

    private Optional<ShotCard> card(int index) {
        return loaded == null || index >= loaded.shots().size() ? Optional.empty()
                : Optional.ofNullable(byName.get(loaded.shots().get(index).name()));
    }

    /** Opens a sequence; the one that is open stays if it cannot be read. */
    void open(Path file) {
        message.setText("");
        save();
        model.files().runInOrder(() -> Opened.read(file), this::show, failure -> message.setText(ErrorMessage.of(failure)));
    }

    /** A sequence and the state of its file. */
    private record Opened(LoadedSequence sequence, FileState state) {
        private static Opened read(Path file) throws IOException, JenException {
            FileState state = FileState.of(file);
            return new Opened(LoadedSequence.read(file), state);
        }
    }

    private void create() {
        if (editor.document().isUntitled()) {
            message.setText(Messages.tr("Save the scene first: the sequence names its file"));
            return;
        }
        Path scene = editor.document().file();
        String stem = scene.getFileName().toString().replaceFirst("\\.[^.]*$", "");
        prompt().fileToSave(Messages.tr("New Sequence"), stem + Sequence.EXTENSION, EXTENSION).ifPresent(file -> {
            String name = relative(file, scene);
            var sequence = new Sequence(name, false, List.of(new Sequence.Entry(stem, name, Optional.empty(), List.of(), "")),
                    new LinkedHashMap<>());
            model.files().runInOrder(() -> {
                sequence.write(AtomicFile.of(file));
                return Opened.read(file);
            }, this::show, failure -> message.setText(ErrorMessage.of(failure)));
        });
    }

    private static String relative(Path file, Path scene) {
        Path folder = ParentFolder.of(file.toAbsolutePath().normalize());
        Path target = scene.toAbsolutePath().normalize();
        return folder.getRoot() != null && folder.getRoot().equals(target.getRoot())
                ? folder.relativize(target).toString().replace('\\', '/')
                : target.toString();
    }

    private void add(Path scene) {
        LoadedSequence open = loaded;
        if (open == null) {
            return;
        }
        String stem = scene.getFileName().toString().replaceFirst("\\.[^.]*$", "");
        String name = stem;
        for (int i = 2; open.sequence().shot(name).isPresent(); i++) {
            name = stem + " " + i;
        }
        List<Sequence.Entry> shots = new ArrayList<>(open.sequence().shots());
        shots.add(new Sequence.Entry(name, relative(open.file(), scene), Optional.empty(), List.of(), ""));
        var extended = new Sequence(open.sequence().rig(), open.sequence().sharesWorld(), shots, open.sequence().lightNotes());
        FileState before = known;
        model.files().runInOrder(() -> {
            extended.write(AtomicFile.of(open.file()).ifUnchanged(before));
            return Opened.read(open.file());
        }, this::show, failure -> message.setText(reason(open, failure)));
    }

    private static String reason(LoadedSequence sequence, Throwable failure) {
        return failure instanceof ChangedFileException
                ? Messages.tr("{0} was changed by another program; open it again", Quote.path(sequence.file().getFileName()))
                : ErrorMessage.of(failure);
    }

    /** Saves changes that are not saved yet: a second after the last one, and when the window closes. */
    private void save() {
        autosave.stop();
        LoadedSequence open = loaded;
        if (open == null || !isChanged || isSaving) {
            return;
        }
        isChanged = false;
        isSaving = true;
        FileState before = known;
        model.files().runInOrder(() -> open.sequence().write(AtomicFile.of(open.file()).ifUnchanged(before)), state -> {
            isSaving = false;
            if (loaded != null && loaded.file().equals(open.file())) {
                known = state;
                showFile();
                // What changed meanwhile.
                save();
            }
        }, failure -> {
            isSaving = false;
            isChanged = true;
            showFile();
            message.setText(reason(open, failure));
        });
    }

    private void show(Opened opened) {
        LoadedSequence sequence = opened.sequence();
        loaded = sequence;
        known = opened.state();
        isChanged = false;
        selected = sequence.shots().getFirst().name();
        Path open = editor.document().file().toAbsolutePath().normalize();
        Path rig = ParentFolder.of(sequence.file()).resolve(sequence.sequence().rig()).toAbsolutePath().normalize();
        followsScene.setSelected(open.equals(rig));
        showSequence();
        if (sheet != null) {
            // The pictures of another sequence are of other scenes.
            sheet.close();
            sheet = newSheet();
        }
        showPictures();
    }

    private ContactSheet newSheet() {
        return new ContactSheet(ShotCard.WIDTH, ShotCard.HEIGHT,
                (i, picture) -> model.files().windowExecutor().execute(() -> card(i).ifPresent(card -> card.show(picture))),
                (i, failure) -> model.files().windowExecutor()
                        .execute(() -> card(i).ifPresent(card -> card.setProblem(ErrorMessage.of(failure)))));
    }

    private void showSequence() {
        byName.clear();
        if (loaded != null) {
            for (Sequence.Entry entry : loaded.sequence().shots()) {
                byName.put(entry.name(), new ShotCard(entry, () -> select(entry.name())));
            }
        }
        cards.getChildren().setAll(byName.values());
        details.setDisable(loaded == null);
        addShot.setDisable(loaded == null);
        followsScene.setDisable(loaded == null);
        moment.setDisable(loaded == null);
        message.setText(loaded == null ? Messages.tr("Several shots with the lights of one scene: open a sequence, or start one") : "");
        showFile();
        select(selected);
    }

    private void showFile() {
        fileName.setText(loaded == null ? "" : Quote.path(loaded.file().getFileName()) + (isChanged ? " *" : ""));
    }

    private void select(String name) {
        selected = name;
        byName.forEach((shot, card) -> card.setSelected(shot.equals(name)));
        Optional<Sequence.Entry> entry = loaded == null ? Optional.empty() : loaded.sequence().shot(name);
        isUpdating = true;
        shotName.setText(entry.map(Sequence.Entry::name).orElse(Messages.tr("Shot")));
        overrides.setText(entry.map(shot -> String.join("\n", shot.overrides())).orElse(""));
        note.setText(entry.map(Sequence.Entry::note).orElse(""));
        isUpdating = false;
        showLightNote();
    }

    private void showLightNote() {
        String light = editor.selection().lightName();
        isUpdating = true;
        lightName.setText(light.isEmpty() ? Messages.tr("Light") : light);
        lightNote.setDisable(light.isEmpty());
        String text = loaded == null ? "" : loaded.sequence().lightNotes().getOrDefault(light, "");
        if (!lightNote.getText().equals(text)) {
            lightNote.setText(text);
        }
        lightNote.setPromptText(Messages.tr("Note about the light, for all shots"));
        isUpdating = false;
    }

    private void changeShot(UnaryOperator<Sequence.Entry> change) {
        if (!isUpdating && loaded != null) {
            change(loaded.sequence().with(selected, change));
            loaded.sequence().shot(selected).ifPresent(entry -> requireNonNull(byName.get(selected)).show(entry));
            showPictures();
        }
    }

    private void change(Sequence sequence) {
        loaded = requireNonNull(loaded).withSequence(sequence);
        isChanged = true;
        showFile();
        autosave.playFromStart();
    }

    private void showPictures() {
        LoadedSequence sequence = loaded;
        if (sequence == null || sheet == null) {
            return;
        }
        Scene lights = followsScene.isSelected() ? editor.scene() : sequence.rig();
        Moment at = moment.getValue();
        List<Supplier<Scene>> scenes = new ArrayList<>();
        for (LoadedSequence.LoadedShot shot : sequence.shots()) {
            scenes.add(() -> {
                AnimatedScene lit = sequence.lit(shot, lights);
                return lit.sceneAt(at.frame(shot.frames()));
            });
        }
        sheet.show(scenes);
    }
}
