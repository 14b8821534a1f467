package lightning.editor.window.look;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javafx.geometry.Orientation;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.Slider;
import javafx.scene.control.SplitPane;
import javafx.scene.control.TextField;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import javafx.util.Subscription;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.document.EditOutcome;
import lightning.document.FileThread;
import lightning.document.look.Lighting;
import lightning.document.look.LightingBlend;
import lightning.document.look.Look;
import lightning.document.look.LookFiles;
import lightning.document.loop.Frame;
import lightning.editor.EditorState;
import lightning.editor.window.command.ForcedLiveUpdate;
import lightning.editor.window.model.ComparedLooks;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.TracedPicture;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.VisibilityListener;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;
import lightning.scene.Stage;
import org.jspecify.annotations.Nullable;

/** Gallery of the open scene's saved looks (looks): saves, applies, compares and blends them. */
public final class LookPane extends VBox {
    private static final double PERCENT = 100;
    /** Height of one row of looks with their buttons, pixels. */
    private static final double MIN_GALLERY_HEIGHT = 200;

    private final SceneEditor editor;
    private final TracedPicture picture;
    private final FileThread files;
    private final TextField name = new TextField();
    private final DisabledReason saveReason;
    private final FlowPane gallery = new FlowPane();
    private final Label message = new Label();
    private final Button restoreButton = new Button(Messages.tr("Undo Delete"));
    private final LookCompare compare = new LookCompare();
    private final Slider blend = new Slider(0, PERCENT, 0);
    private final DisabledReason blendReason;
    private final Label percent = new Label("0 %");
    private final Map<String, LookCard> cards = new LinkedHashMap<>();
    private List<Look> looks = List.of();
    private String a = "";
    private String b = "";
    private String removedName = "";
    private @Nullable Object gesture;
    private boolean isUpdating;

    /** Saved look with its thumbnail, which is null if there is no picture. */
    private record LookEntry(Look look, LookCard.@Nullable LookThumbnail thumbnail) {}

    public LookPane(SceneEditor editor, TracedPicture picture, FileThread files) {
        this.editor = editor;
        this.picture = picture;
        this.files = files;
        setId("looks");
        getStyleClass().add("looks");
        name.setId("look-new-name");
        name.setPromptText(Messages.tr("Look name"));
        name.setAccessibleText(Messages.tr("look name"));
        var saveButton = new Button(Messages.tr("Save Look"));
        saveButton.setId("look-keep");
        saveButton.getStyleClass().add("accent");
        saveButton.setOnAction(_ -> saveLook());
        saveButton.setMinWidth(Region.USE_PREF_SIZE);
        name.setOnAction(_ -> saveButton.fire());
        var saveBox = new StackPane(saveButton);
        saveReason = new DisabledReason(saveBox, saveButton,
                Messages.tr("Save the look and a thumbnail in the scene's folder"));
        message.setId("look-message");
        message.getStyleClass().add("pane-note");
        message.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(message, Priority.ALWAYS);
        restoreButton.setId("look-back");
        restoreButton.setVisible(false);
        restoreButton.setMinWidth(Region.USE_PREF_SIZE);
        restoreButton.setOnAction(_ -> restoreRemoved());
        var tools = new HBox(name, saveBox, message, restoreButton);
        tools.getStyleClass().add("mixer-tools");
        blend.setId("look-blend");
        blend.setAccessibleText(Messages.tr("blend from A to B in percent"));
        blend.setTooltip(new Tooltip(Messages.tr("Blend the lighting from A to B")));
        blend.setOnMousePressed(_ -> gesture = new Object());
        blend.setOnMouseReleased(_ -> gesture = null);
        blend.valueProperty().subscribe(v -> blendTo(v.doubleValue() / PERCENT));
        HBox.setHgrow(blend, Priority.ALWAYS);
        percent.setId("look-percent");
        percent.setMinWidth(44);
        var blendRow = new HBox(new Label(Messages.tr("Blend  A")), blend, new Label("B"), percent);
        blendRow.getStyleClass().add("mixer-tools");
        blendReason = new DisabledReason(blendRow, blend);
        gallery.getStyleClass().add("look-gallery");
        var scroll = new ScrollPane(gallery);
        scroll.setFitToWidth(true);
        // The comparison would leave no room for the looks in a low panel.
        scroll.setMinHeight(MIN_GALLERY_HEIGHT);
        scroll.getStyleClass().add("edge-to-edge");
        var parts = new SplitPane(scroll, new VBox(compare, blendRow));
        VBox.setVgrow(compare, Priority.ALWAYS);
        parts.setOrientation(Orientation.VERTICAL);
        parts.setDividerPositions(0.38);
        VBox.setVgrow(parts, Priority.ALWAYS);
        getChildren().addAll(tools, parts);
        updateChoice();
        VisibilityListener.attach(this, this::subscribe);
    }

    /** Lists the looks and starts to observe the editor. */
    private Subscription subscribe() {
        return Subscription.combine(editor.documentProperty().subscribe(_ -> loadLooks()),
                editor.comparedLooksProperty().subscribe(_ -> takeComparison()),
                editor.looksVersionProperty().subscribe(_ -> loadLooks()),
                editor.editorStateProperty().map(EditorState::untitled).subscribe(_ -> loadLooks()),
                editor.editorStateProperty().subscribe(state -> saveReason.set(saveDisabledReason(state))),
                ForcedLiveUpdate.renderWhileFocused(this, editor, files.windowExecutor()));
    }

    private static Optional<String> saveDisabledReason(EditorState state) {
        return state.frame().isEmpty() ? Optional.of(Messages.tr("nothing is rendered yet")) : state.pendingMessage();
    }

    private LookFiles folder() {
        return editor.looksFolder();
    }

    /** Chooses the two looks that are to be compared, if there are any. */
    private void takeComparison() {
        ComparedLooks looks = editor.comparedLooksProperty().get();
        if (looks != null) {
            editor.comparedLooksProperty().set(null);
            a = looks.a();
            b = looks.b();
            updateChoice();
        }
    }

    private <T> void runFileTask(FileThread.FileTask<T> work, Consumer<T> onDone) {
        files.runInOrder(work, onDone, failure -> showMessage(ErrorMessage.of(failure)));
    }

    private void showMessage(@Nullable String text) {
        message.setText(text);
    }

    private void loadLooks() {
        LookFiles folder = folder();
        Stage stage = editor.scene().stage();
        runFileTask(() -> {
            List<LookEntry> entries = new ArrayList<>();
            for (Look look : folder.list(stage)) {
                entries.add(new LookEntry(look, look.picture().map(LookCard::thumbnail).orElse(null)));
            }
            return entries;
        }, entries -> {
            if (folder.path().equals(folder().path())) {
                showLooks(entries);
            }
        });
    }

    private void showLooks(List<LookEntry> entries) {
        looks = entries.stream().map(LookEntry::look).toList();
        cards.clear();
        for (LookEntry entry : entries) {
            cards.put(entry.look().name(), new LookCard(entry.look(), entry.thumbnail(), new CardCallbacks()));
        }
        gallery.getChildren().setAll(cards.values());
        if (looks.isEmpty()) {
            var empty = new Label(editor.document().isUntitled()
                    ? Messages.tr("No looks yet. Saved looks appear here and are stored with the scene when you save it.")
                    : Messages.tr("No looks yet. Saved looks appear here and are stored in {0}.", folder().path().getFileName()));
            empty.getStyleClass().add("pane-note");
            gallery.getChildren().add(empty);
        }
        updateChoice();
    }

    private Optional<Look> findLook(String lookName) {
        return looks.stream().filter(c -> c.name().equals(lookName)).findFirst();
    }

    private Optional<Lighting> lighting(String lookName) {
        return findLook(lookName).flatMap(Look::lighting);
    }

    private void updateChoice() {
        cards.forEach((lookName, card) -> card.show(lookName.equals(a), lookName.equals(b)));
        compare.show(findLook(a), findLook(b));
        boolean hasBoth = lighting(a).isPresent() && lighting(b).isPresent();
        blendReason.set(hasBoth ? Optional.empty() : Optional.of(Messages.tr("choose two looks, A and B")));
        isUpdating = true;
        blend.setValue(0);
        percent.setText("0 %");
        isUpdating = false;
    }

    private void saveLook() {
        String lookName = name.getText().strip();
        Optional<String> refusal = LookFiles.nameProblem(lookName).or(() -> saveDisabledReason(editor.editorStateProperty().get()));
        if (refusal.isPresent()) {
            showMessage(refusal.get());
            return;
        }
        if (findLook(lookName).isPresent()) {
            showMessage(Messages.tr("The name {0} is already in use", Quote.of(lookName)));
            return;
        }
        LookFiles folder = folder();
        Lighting lighting = Lighting.of(editor.scene());
        Frame frame = requireNonNull(picture.frame());
        Film film = frame.film();
        ViewTransform view = picture.viewProperty().get().withMarksClipping(false);
        runFileTask(() -> {
            folder.save(lookName, lighting, film, view);
            return lookName;
        }, savedName -> {
            showMessage(Messages.tr("Saved {0}", Quote.of(savedName)));
            editor.savedLooksProperty().set(editor.savedLooksProperty().get() + 1);
            editor.looksChanged();
            name.clear();
            loadLooks();
        });
    }

    private void restoreRemoved() {
        LookFiles folder = folder();
        String lookName = removedName;
        runFileTask(() -> {
            folder.restore(lookName);
            return lookName;
        }, _ -> {
            showMessage("");
            restoreButton.setVisible(false);
            loadLooks();
        });
    }

    /** Applies a lighting to the document and renders it immediately. */
    private void applyLighting(Lighting lighting) {
        applyEdit(lighting::applyTo, null);
    }

    private void applyEdit(Function<Scene, EditOutcome> edit, @Nullable Object gesture) {
        showMessage(editor.editAndRender(edit, gesture).orElse(""));
    }

    private void blendTo(double t) {
        if (isUpdating) {
            return;
        }
        percent.setText(Math.round(t * PERCENT) + " %");
        lighting(a).ifPresent(from -> lighting(b).ifPresent(to -> {
            try {
                Lighting blended = LightingBlend.blend(from, to, t);
                applyEdit(scene -> blended.applyTo(scene).named(Messages.tr("Blend A/B {0}", percent.getText())), gesture);
            } catch (RefusalException e) {
                showMessage(e.getMessage());
            }
        }));
    }

    /** Handles the actions of the cards. */
    private final class CardCallbacks implements LookCard.Callbacks {
        @Override
        public void restore(Look look) {
            look.lighting().ifPresent(LookPane.this::applyLighting);
        }

        @Override
        public void rename(Look look, String to) {
            if (to.equals(look.name())) {
                return;
            }
            LookFiles folder = folder();
            runFileTask(() -> {
                folder.rename(look.name(), to);
                return to;
            }, _ -> {
                a = a.equals(look.name()) ? to : a;
                b = b.equals(look.name()) ? to : b;
                showMessage("");
                loadLooks();
            });
        }

        @Override
        public void remove(Look look) {
            LookFiles folder = folder();
            runFileTask(() -> {
                folder.remove(look.name());
                return look.name();
            }, lookName -> {
                removedName = lookName;
                restoreButton.setVisible(true);
                showMessage(Messages.tr("Deleted {0}", Quote.of(lookName)));
                loadLooks();
            });
        }

        @Override
        public void chooseA(Look look) {
            a = a.equals(look.name()) ? "" : look.name();
            updateChoice();
        }

        @Override
        public void chooseB(Look look) {
            b = b.equals(look.name()) ? "" : look.name();
            updateChoice();
        }
    }
}
