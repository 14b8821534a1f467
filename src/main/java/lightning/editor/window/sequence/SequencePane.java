package lightning.editor.window.sequence;

import static java.util.Objects.requireNonNull;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.ObjIntConsumer;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.util.Subscription;
import lightning.base.file.ParentFolder;
import lightning.base.text.Messages;
import lightning.base.text.RefusalException;
import lightning.document.OpenDocument;
import lightning.document.loop.ContactSheet;
import lightning.editor.Command;
import lightning.editor.window.command.PathPrompt;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.VisibilityListener;
import lightning.format.jen.JenFile;
import lightning.format.jen.PropertyChanges;
import lightning.format.sequence.LoadedSequence;
import lightning.format.sequence.Sequence;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Contact sheet of a sequence. All shots are lit by the lights of the open scene, or by those of the rig's file; each edit shows in all shots. The
 * selected shot has fields for its own values and notes.
 */
public final class SequencePane extends VBox implements SequenceFile.Listener {
    private static final String EXTENSION = "json";

    private final EditorModel model;
    private final SceneEditor editor;
    private final SequenceFile file;
    private final Button addShot;
    private final Label fileName = new Label();
    private final Button ownEdit = button("sequence-own", Messages.tr("Last Edit Only Here"), this::keepLastEdit);
    private final CheckBox followsScene = new CheckBox(Messages.tr("Light With the Open Scene"));
    private final ChoiceBox<SheetMoment> moment = new ChoiceBox<>();
    private final FlowPane cards = new FlowPane();
    private final ShotDetails details = new ShotDetails(this::changeShot, this::changeLightNote);
    private final Label message = new Label();
    private final Map<String, ShotCard> byName = new LinkedHashMap<>();
    private @Nullable ContactSheet sheet;
    /** Number of sheets so far. */
    private int sheets;
    /** Place of each picture of the sheet. */
    private List<Place> places = List.of();
    private @Nullable PathPrompt prompt;
    private String selected = "";

    /** Place of a picture on the card of a shot, from 0. */
    private record Place(String shot, int picture) {}

    public SequencePane(EditorModel model) {
        this.model = model;
        editor = model.editor();
        file = new SequenceFile(model.files(), this);
        setId("sequence");
        getStyleClass().add("looks");
        Button open = button("sequence-open", Messages.tr("Open Sequence…"),
                () -> prompt().fileToOpen(Messages.tr("Open Sequence"), EXTENSION).ifPresent(this::open));
        Button create = button("sequence-new", Messages.tr("New Sequence…"), this::create);
        create.setTooltip(new Tooltip(Messages.tr("Start a sequence whose rig and first shot are the open scene")));
        addShot = button("sequence-add", Messages.tr("Add Shot…"),
                () -> prompt().fileToOpen(Messages.tr("Add Shot"), "jen").ifPresent(file::add));
        ownEdit.setTooltip(new Tooltip(Messages.tr("Undo the last edit of lights, and keep it as a value of the selected shot alone")));
        fileName.setId("sequence-file");
        fileName.getStyleClass().add("pane-note");
        followsScene.setId("sequence-follows");
        followsScene.setTooltip(new Tooltip(Messages.tr("On: the lights of the open scene light all shots. Off: those of the rig's file")));
        followsScene.selectedProperty().subscribe(this::showPictures);
        moment.setId("sequence-moment");
        moment.setAccessibleText(Messages.tr("Frames of the pictures"));
        moment.getItems().setAll(SheetMoment.values());
        moment.setConverter(SheetMoment.TITLES);
        moment.setValue(SheetMoment.MIDDLE);
        moment.valueProperty().subscribe(this::showNewPictures);
        cards.setId("sequence-cards");
        cards.getStyleClass().add("look-gallery");
        var scroll = new ScrollPane(cards);
        scroll.setFitToWidth(true);
        scroll.getStyleClass().add("edge-to-edge");
        VBox.setVgrow(scroll, Priority.ALWAYS);
        message.setId("sequence-message");
        message.getStyleClass().add("pane-note");
        message.setWrapText(true);
        message.setMinHeight(Region.USE_PREF_SIZE);
        getChildren().addAll(row(open, create, addShot, fileName), row(followsScene, moment, ownEdit), scroll, details, row(message));
        showSequence();
        VisibilityListener.attach(this, this::subscribe);
    }

    private static Button button(String id, String text, Runnable action) {
        var button = new Button(text);
        button.setId(id);
        button.setMinWidth(Region.USE_PREF_SIZE);
        button.setOnAction(_ -> action.run());
        return button;
    }

    /** Returns a row of controls. */
    static HBox row(Region... nodes) {
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
        }), editor.editorStateProperty().subscribe(_ -> showLightNote()), file::save, this::closeSheet);
    }

    private void closeSheet() {
        if (sheet != null) {
            sheet.close();
            sheet = null;
        }
    }

    private ContactSheet newSheet() {
        int generation = ++sheets;
        return new ContactSheet(ShotCard.WIDTH, ShotCard.HEIGHT,
                (i, picture) -> inWindow(generation, i, (card, index) -> card.show(index, picture)),
                (i, failure) -> inWindow(generation, i, (card, _) -> card.setProblem(ErrorMessage.of(failure))));
    }

    /**
     * Changes the card of a shot, on the window's thread.
     *
     * @param generation number of the sheet; an earlier one changes nothing
     * @param place      number of a picture
     * @param change     receives the card and the number of the picture on it
     */
    private void inWindow(int generation, int place, ObjIntConsumer<ShotCard> change) {
        model.files().windowExecutor().execute(() -> {
            if (generation == sheets && place < places.size()) {
                Place at = places.get(place);
                Optional.ofNullable(byName.get(at.shot)).ifPresent(card -> change.accept(card, at.picture));
            }
        });
    }

    /** Opens a sequence; the one that is open stays if it cannot be read. */
    void open(Path path) {
        message.setText("");
        file.open(path);
    }

    private void create() {
        if (editor.document().isUntitled()) {
            message.setText(Messages.tr("Save the scene first: the sequence names its file"));
            return;
        }
        prompt().fileToSave(Messages.tr("New Sequence"), JenFile.stem(editor.document().name()) + Sequence.EXTENSION, EXTENSION)
                .ifPresent(chosen -> file.create(chosen, editor.document().file()));
    }

    @Override
    public void opened(LoadedSequence sequence) {
        selected = sequence.shots().getFirst().name();
        Path rig = ParentFolder.of(sequence.file()).resolve(sequence.sequence().rig());
        showSequence();
        followsScene.setSelected(normalized(editor.document().file()).equals(normalized(rig)));
        showNewPictures();
    }

    /** Forgets the pictures, which are of other scenes or frames, and shows new ones. */
    private void showNewPictures() {
        if (sheet != null) {
            closeSheet();
            sheet = newSheet();
        }
        showPictures();
    }

    private static Path normalized(Path path) {
        return path.toAbsolutePath().normalize();
    }

    @Override
    public void titleChanged() {
        fileName.setText(file.title());
    }

    @Override
    public void failed(String text) {
        message.setText(text);
    }

    private void showSequence() {
        byName.clear();
        LoadedSequence open = file.loaded();
        if (open != null) {
            for (Sequence.Entry entry : open.sequence().shots()) {
                byName.put(entry.name(), new ShotCard(entry, () -> select(entry.name())));
            }
        }
        cards.getChildren().setAll(byName.values());
        for (Region control : List.of(details, addShot, followsScene, moment, ownEdit)) {
            control.setDisable(open == null);
        }
        message.setText(open == null ? Messages.tr("Several shots with the lights of one scene: open a sequence, or start one") : "");
        select(selected);
    }

    private void select(String name) {
        selected = name;
        byName.forEach((shot, card) -> card.setSelected(shot.equals(name)));
        LoadedSequence open = file.loaded();
        details.show(open == null ? null : open.sequence().shot(name).orElse(null));
        showLightNote();
    }

    private void showLightNote() {
        String light = editor.selection().lightName();
        LoadedSequence open = file.loaded();
        details.showLight(light, open == null ? "" : open.sequence().lightNotes().getOrDefault(light, ""));
    }

    private void changeShot(UnaryOperator<Sequence.Entry> change) {
        LoadedSequence open = file.loaded();
        if (open != null) {
            Sequence changed = open.sequence().with(selected, change);
            file.change(changed);
            changed.shot(selected).ifPresent(entry -> requireNonNull(byName.get(selected)).show(entry));
            showPictures();
        }
    }

    /** Turns the last edit of the open scene into values of the selected shot. */
    private void keepLastEdit() {
        LoadedSequence open = file.loaded();
        OpenDocument document = editor.document();
        Optional<List<String>> edits = document.history().beforeLastStep()
                .flatMap(before -> PropertyChanges.between(before.base(), document.scene(), ParentFolder.of(document.file())));
        if (open == null || edits.isEmpty() || edits.get().isEmpty()) {
            message.setText(Messages.tr("The last edit did not change values of lights"));
            return;
        }
        try {
            changeShot(shot -> shot.withOverrides(PropertyChanges.joined(shot.overrides(), edits.get())));
        } catch (RefusalException e) {
            message.setText(ErrorMessage.of(e));
            return;
        }
        model.commands().run(Command.UNDO);
        message.setText("");
        select(selected);
    }

    private void changeLightNote(String light, String text) {
        LoadedSequence open = file.loaded();
        if (open != null && !light.isEmpty()) {
            file.change(open.sequence().withLightNote(light, text));
        }
    }

    private void showPictures() {
        LoadedSequence sequence = file.loaded();
        if (sequence == null || sheet == null) {
            return;
        }
        Scene lights = followsScene.isSelected() ? editor.scene() : sequence.rig();
        List<Place> shown = new ArrayList<>();
        List<Supplier<Scene>> scenes = new ArrayList<>();
        for (LoadedSequence.LoadedShot shot : sequence.shots()) {
            List<Integer> frames = moment.getValue().frames(shot.frames());
            requireNonNull(byName.get(shot.name())).setPictureCount(frames.size());
            for (int i = 0; i < frames.size(); i++) {
                int frame = frames.get(i);
                shown.add(new Place(shot.name(), i));
                scenes.add(() -> sequence.lit(shot, lights).sceneAt(frame));
            }
        }
        places = List.copyOf(shown);
        sheet.show(scenes);
    }
}
