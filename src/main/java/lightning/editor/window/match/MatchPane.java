package lightning.editor.window.match;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.Tooltip;
import javafx.scene.input.DragEvent;
import javafx.scene.input.TransferMode;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import javafx.util.Subscription;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.work.Progress;
import lightning.document.EditOutcome;
import lightning.document.loop.Frame;
import lightning.editor.Command;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.command.ForcedLiveUpdate;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.PictureQuery;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.PercentText;
import lightning.editor.window.widget.VisibilityListener;
import lightning.format.jen.asset.FileKind;
import lightning.format.reference.ReferenceFile;
import lightning.render.RenderOptions;
import lightning.render.image.ViewTransform;
import lightning.render.match.BrushDab;
import lightning.render.match.LightMatch;
import lightning.render.match.MatchChange;
import lightning.render.match.MatchContributions;
import lightning.render.match.MatchResult;
import lightning.render.match.MatchSettings;
import lightning.render.match.MatchedScene;
import lightning.render.match.PaintedReference;
import lightning.render.match.ReferenceImage;
import lightning.scene.Contribution;
import lightning.scene.Scene;

/**
 * Matches the lights to a reference image, or to what a brush painted on the picture. The result is one edit that can be undone; the pane shows
 * the difference before and after.
 */
public final class MatchPane extends VBox {
    private final EditorModel model;
    private final SceneEditor editor;
    private final PictureQuery query;
    private final MatchView view = new MatchView(this::updateReason);
    private final Label fileName = new Label();
    private final Label result = new Label();
    private final MenuButton changes = new MenuButton();
    private final Set<MatchChange> changed = EnumSet.noneOf(MatchChange.class);
    private final CheckBox anyExposure = new CheckBox(Messages.tr("Any Exposure"));
    private final CheckBox anyWhite = new CheckBox(Messages.tr("Any White Balance"));
    private final MenuButton lights = new MenuButton();
    /** Lights that shall stay as they are. */
    private final Set<Contribution> kept = new HashSet<>();
    private final ComboBox<MatchView.Arrangement> arrangement = new ComboBox<>();
    private final ToggleButton region = new ToggleButton(Messages.tr("Region"));
    private final Button close = new Button(Messages.tr("Remove Reference"));
    private final Button match = new Button(Messages.tr("Match"));
    private final DisabledReason matchReason;
    private final Map<BrushDab.Wish, ToggleButton> brushes = new LinkedHashMap<>();
    private final FlowPane brushRow;
    private Optional<ReferenceFile> reference = Optional.empty();
    private boolean isBusy;

    /** What the panel found, and the scene that it is for. */
    private record Found(Scene scene, MatchResult result, int invalidPixels) {}

    public MatchPane(EditorModel model) {
        this.model = model;
        editor = model.editor();
        query = new PictureQuery(model.files().windowExecutor(), "lightning-match");
        setId("match");
        getStyleClass().add("contributions");
        var open = new Button(Messages.tr("Open Reference…"));
        open.setId("match-open");
        open.setMinWidth(Region.USE_PREF_SIZE);
        open.setTooltip(new Tooltip(Messages.tr("PNG, JPEG, OpenEXR or HDR of the picture's shape; or drop the file here")));
        open.setOnAction(_ -> model.fileImporter().prompt(Messages.tr("Open Reference"), FileKind.TEXTURE).ifPresent(this::open));
        close.setId("match-close");
        close.setMinWidth(Region.USE_PREF_SIZE);
        close.setOnAction(_ -> setReference(Optional.empty()));
        arrangement.setId("match-arrangement");
        arrangement.setMinWidth(Region.USE_PREF_SIZE);
        arrangement.setTooltip(new Tooltip(Messages.tr("Where the reference is shown")));
        arrangement.getItems().setAll(MatchView.Arrangement.values());
        arrangement.setValue(MatchView.Arrangement.WIPE);
        arrangement.valueProperty().subscribe(view::setArrangement);
        region.setId("match-region");
        region.setMinWidth(Region.USE_PREF_SIZE);
        region.setTooltip(new Tooltip(Messages.tr("Drag a rectangle on the picture: only this part of the reference counts")));
        region.selectedProperty().subscribe(view::setSelectsRegion);
        fileName.setId("match-file");
        fileName.getStyleClass().add("pane-note");
        fileName.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(fileName, Priority.ALWAYS);
        var head = new HBox(open, close, arrangement, region, fileName);
        head.getStyleClass().add("mixer-tools");
        brushRow = brushes();
        VBox.setVgrow(view, Priority.ALWAYS);
        match.setId("match-run");
        match.getStyleClass().add("accent");
        match.setMinWidth(Region.USE_PREF_SIZE);
        match.setOnAction(_ -> run());
        var matchBox = new StackPane(match);
        matchReason = new DisabledReason(matchBox, match, Messages.tr("Set the lights so that the picture comes closest; can be undone"));
        changes.setId("match-changes");
        changes.setMinWidth(Region.USE_PREF_SIZE);
        changes.setTooltip(new Tooltip(Messages.tr("What may change besides intensities; all but colors is searched from where it is")));
        changes.getItems().setAll(changeItems());
        showChanges();
        anyExposure.setId("match-exposure");
        anyExposure.setTooltip(new Tooltip(Messages.tr("The brightness of the reference does not count")));
        anyWhite.setId("match-white");
        anyWhite.setTooltip(new Tooltip(Messages.tr("Neither brightness nor tint of the reference count")));
        lights.setId("match-lights");
        lights.setMinWidth(Region.USE_PREF_SIZE);
        lights.setTooltip(new Tooltip(Messages.tr("Lights that may change; lights that are off stay off")));
        lights.getItems().setAll(lightItems());
        lights.setOnShowing(_ -> lights.getItems().setAll(lightItems()));
        showLightCount();
        var options = new FlowPane(matchBox, lights, changes, anyExposure, anyWhite);
        options.getStyleClass().add("mixer-tools");
        options.setHgap(12);
        options.setVgap(4);
        result.setId("match-result");
        result.setWrapText(true);
        result.setMaxWidth(Double.MAX_VALUE);
        result.setMinHeight(Region.USE_PREF_SIZE);
        result.getStyleClass().add("pane-note");
        HBox.setHgrow(result, Priority.ALWAYS);
        var resultRow = new HBox(result);
        resultRow.getStyleClass().add("mixer-tools");
        getChildren().addAll(head, brushRow, view, options, resultRow);
        setOnDragOver(this::acceptDrag);
        setOnDragDropped(this::drop);
        setReference(Optional.empty());
        VisibilityListener.attach(this, this::subscribe);
    }

    private FlowPane brushes() {
        var row = new FlowPane(8, 4, new Label(Messages.tr("Paint:")));
        row.getStyleClass().add("mixer-tools");
        for (BrushDab.Wish wish : BrushDab.Wish.values()) {
            var button = new ToggleButton(wish.title());
            button.setId("match-" + wish.name().toLowerCase(Locale.ROOT));
            button.setMinWidth(Region.USE_PREF_SIZE);
            button.setOnAction(_ -> {
                brushes.forEach((other, b) -> b.setSelected(other == wish && button.isSelected()));
                view.setBrush(button.isSelected() ? wish : null);
            });
            brushes.put(wish, button);
            row.getChildren().add(button);
        }
        var erase = new Button(Messages.tr("Erase"));
        erase.setId("match-erase");
        erase.setMinWidth(Region.USE_PREF_SIZE);
        erase.setOnAction(_ -> view.erase());
        row.getChildren().add(erase);
        return row;
    }

    /** Starts to observe the picture. */
    private Subscription subscribe() {
        return Subscription.combine(model.picture().renderStateProperty().subscribe(_ -> showPicture()),
                model.picture().viewProperty().subscribe(_ -> showPicture()),
                ForcedLiveUpdate.renderWhileFocused(this, editor, model.files().windowExecutor()), this::cancel);
    }

    private void showPicture() {
        Frame frame = model.picture().frame();
        if (frame != null && frame.isFinished()) {
            view.show(frame.film(), model.picture().viewProperty().get().withMarksClipping(false));
        } else if (!isBusy) {
            query.cancel();
        }
        updateReason();
    }

    private void acceptDrag(DragEvent e) {
        if (e.getDragboard().hasFiles()) {
            e.acceptTransferModes(TransferMode.COPY);
            e.consume();
        }
    }

    private void drop(DragEvent e) {
        e.getDragboard().getFiles().stream().findFirst().ifPresent(file -> open(file.toPath()));
        e.setDropCompleted(true);
        e.consume();
    }

    /** Opens a reference. */
    public void open(Path file) {
        model.files().runConcurrently(() -> ReferenceFile.read(file),
                opened -> setReference(Optional.of(opened)), failure -> result.setText(ErrorMessage.of(failure)));
    }

    private void setReference(Optional<ReferenceFile> newReference) {
        reference = newReference;
        region.setSelected(false);
        view.setReference(newReference.map(r -> new MatchView.Shown(r.image().film(),
                r.isDisplayReferred() ? Optional.of(ViewTransform.DEFAULT) : Optional.empty())));
        fileName.setText(newReference.map(r -> r.file().getFileName().toString()).orElse(""));
        boolean isOpen = newReference.isPresent();
        for (Region part : List.of(close, arrangement, region, anyExposure, anyWhite)) {
            part.setVisible(isOpen);
            part.setManaged(isOpen);
        }
        brushRow.setVisible(!isOpen);
        brushRow.setManaged(!isOpen);
        result.setText(isOpen ? "" : Messages.tr("Open an image that the picture shall resemble, or paint how it shall change."));
        updateReason();
    }

    private void updateReason() {
        Frame frame = model.picture().frame();
        Optional<String> reason = isBusy ? Optional.of(Messages.tr("matching is in progress"))
                : frame == null || !frame.isFinished() ? Optional.of(Messages.tr("nothing is rendered yet"))
                : editor.editorStateProperty().get().hasPendingEdits() ? Optional.of(Messages.tr("the picture is not up to date"))
                : reference.isPresent()
                        ? reference.filter(r -> !r.image().hasShapeOf(frame.film().width(), frame.film().height()))
                                .map(r -> Messages.tr("the reference has another shape: {0} × {1} pixels, the picture {2} × {3}",
                                        r.image().film().width(), r.image().film().height(), frame.film().width(), frame.film().height()))
                : view.dabs().isEmpty() ? Optional.of(Messages.tr("there is no reference and no paint")) : Optional.empty();
        matchReason.set(reason);
    }

    private Stream<Contribution> candidates() {
        return Contribution.shining(editor.scene()).stream();
    }

    private List<MenuItem> lightItems() {
        CommandMenuItems items = CommandMenuItems.forMenu(model.commands());
        return candidates()
                .map(part -> items.checkBoxValue(Command.MATCH_REFERENCE, part.title(editor.scene()), !kept.contains(part), 0, on -> {
                    if (on) {
                        kept.remove(part);
                    } else {
                        kept.add(part);
                    }
                    showLightCount();
                })).toList();
    }

    private List<MenuItem> changeItems() {
        CommandMenuItems items = CommandMenuItems.forMenu(model.commands());
        return Arrays.stream(MatchChange.values())
                .map(change -> items.checkBoxValue(Command.MATCH_REFERENCE, change.title(), false, 0, on -> {
                    if (on) {
                        changed.add(change);
                    } else {
                        changed.remove(change);
                    }
                    showChanges();
                })).toList();
    }

    private void showChanges() {
        changes.setText(Stream.concat(Stream.of(Messages.tr("Intensities")), changed.stream().map(MatchChange::title))
                .collect(Collectors.joining(", ")));
    }

    private void showLightCount() {
        lights.setText(kept.isEmpty() ? Messages.tr("All Lights")
                : Messages.count(kept.size(), "All Lights but 1", "All Lights but {0}", kept.size()));
    }

    private MatchSettings settings() {
        Optional<Set<Contribution>> chosen = kept.isEmpty() ? Optional.empty()
                : Optional.of(candidates().filter(part -> !kept.contains(part)).collect(Collectors.toSet()));
        boolean isOpen = reference.isPresent();
        return new MatchSettings(chosen, Set.copyOf(changed), referenceOf(isOpen && anyExposure.isSelected()),
                referenceOf(isOpen && anyWhite.isSelected()), isOpen ? 0 : MatchSettings.PAINTED);
    }

    private static MatchSettings.Reference referenceOf(boolean isFree) {
        return isFree ? MatchSettings.Reference.FREE : MatchSettings.Reference.FIXED;
    }

    private void run() {
        MatchSettings settings = settings();
        RenderOptions options = model.accuracyModeProperty().get().options();
        List<BrushDab> dabs = view.dabs();
        Optional<ReferenceFile> opened = reference;
        Optional<MatchRegion> counting = view.region();
        ViewTransform shown = model.picture().viewProperty().get();
        isBusy = true;
        updateReason();
        result.setText(Messages.tr("Matching …"));
        query.submit(canceled -> model.workbench().cache().map(cache -> {
            ReferenceImage target = opened.map(r -> r.light(shown, cache.film().width(), cache.film().height())).map(r -> counting.map(
                    c -> r.within(c.left(), c.top(), c.right(), c.bottom())).orElse(r))
                    .orElseGet(() -> PaintedReference.of(cache.film(), dabs));
            var known = MatchContributions.of(cache, options,
                    new CountingProgress(canceled, Messages.key("Matching: {0} of {1} lights")));
            return new Found(cache.scene(), LightMatch.of(known, cache, options, target, settings,
                    new CountingProgress(canceled, Messages.key("Searching: step {0} of at most {1}"))), target.invalidPixels());
        }), this::apply, failure -> {
            isBusy = false;
            updateReason();
            result.setText(ErrorMessage.of(failure));
        });
    }

    /** Shows how far a match is. */
    private final class CountingProgress implements Progress {
        private final Progress canceled;
        private final String text;

        /** @param text key of a message with the number that is done, and the number of all */
        CountingProgress(Progress canceled, String text) {
            this.canceled = canceled;
            this.text = text;
        }

        @Override
        public void report(int done, int total) {
            model.files().windowExecutor().execute(() -> {
                if (isBusy && total > 0) {
                    result.setText(Messages.tr(text, done, total));
                }
            });
        }

        @Override
        public boolean isCanceled() {
            return canceled.isCanceled();
        }
    }

    private void apply(Found found) {
        isBusy = false;
        updateReason();
        if (!editor.scene().rig().equals(found.scene().rig())) {
            result.setText(Messages.tr("The lights were edited meanwhile; match again"));
            return;
        }
        MatchResult matched = found.result();
        Optional<String> refusal = editor.editAndRenderOrReport(scene -> EditOutcome.of(() -> MatchedScene.of(scene, matched))
                .named(Messages.tr("Match Reference")), null);
        result.setText(refusal.orElseGet(() -> text(matched, found.scene(), found.invalidPixels())));
        if (refusal.isEmpty()) {
            view.erase();
        }
    }

    /**
     * Returns the result in words.
     *
     * @param scene         scene that was matched
     * @param invalidPixels pixels of the reference that did not count, since they are infinite or not a number
     */
    static String text(MatchResult matched, Scene scene, int invalidPixels) {
        List<String> sentences = new ArrayList<>();
        sentences.add(Messages.tr("Difference: {0} before, {1} after.", PercentText.format(matched.errorBefore()),
                PercentText.format(matched.errorAfter())));
        matched.alike().forEach(pair -> sentences
                .add(Messages.tr("{0} and {1} look alike in this picture: only their sum is known.", Quote.of(pair.first().title(scene)),
                        Quote.of(pair.second().title(scene)))));
        if (!matched.unseen().isEmpty()) {
            sentences
                    .add(Messages.tr("Lights that reach nothing in this picture are unchanged: {0}.",
                            matched.unseen().stream().map(light -> light.title(scene)).collect(Collectors.joining(", "))));
        }
        if (invalidPixels > 0) {
            sentences.add(Messages.tr("Pixels of the reference that are infinite or not a number did not count: {0}.", invalidPixels));
        }
        return String.join(" ", sentences);
    }

    /** Cancels the match and ends its thread until the window opens again. */
    private void cancel() {
        query.close();
        if (isBusy) {
            isBusy = false;
            result.setText(Messages.tr("Canceled"));
        }
    }
}
